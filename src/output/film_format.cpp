#include "film_format.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace taut {
namespace {

// Players take films of HD size to be in the colours of BT.709; ffmpeg left alone converts to BT.601 and says
// neither, which turns reds orange.
constexpr std::string_view bt709 =
    "-vf scale=out_color_matrix=bt709:out_range=tv -colorspace bt709 -color_primaries bt709 -color_trc bt709 "
    "-color_range tv";

// H.264 at a quality where the eye sees no loss; the index in front, so that a page can start playing early.
constexpr std::string_view h264 =
    "-c:v libx264 -preset veryfast -crf 18 -pix_fmt yuv420p -movflags +faststart";

constexpr std::string_view vp9 =
    "-c:v libvpx-vp9 -crf 24 -b:v 0 -deadline good -cpu-used 5 -row-mt 1 -pix_fmt yuv420p";
constexpr std::string_view vp9_with_opacity =
    "-c:v libvpx-vp9 -crf 24 -b:v 0 -deadline good -cpu-used 5 -row-mt 1 -pix_fmt yuva420p";

// A palette a frame: one for the whole film would have to hold all frames in memory first.
constexpr std::string_view gif =
    "-vf split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=bayer:bayer_scale=3 "
    "-loop 0";

constexpr std::string_view webp = "-c:v libwebp_anim -quality 75 -compression_level 4 -loop 0";

constexpr std::array<FilmFormat, 4> formats{{
    {".mp4", true, false, 16384, bt709, h264, {}},
    {".webm", true, true, 16384, bt709, vp9, vp9_with_opacity},
    {".gif", false, false, 16384, {}, gif, {}},
    {".webp", false, true, 16383, {}, webp, webp},
}};

}  // namespace

std::span<const FilmFormat> film_formats() {
  return formats;
}

const FilmFormat* find_film_format(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found = std::ranges::find(formats, ending, &FilmFormat::ending);
  return found == formats.end() ? nullptr : &*found;
}

}  // namespace taut
