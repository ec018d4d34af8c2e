#include "film_format.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <system_error>

namespace taut {
namespace {

// Players take films of HD size to be in the colours of BT.709; ffmpeg left alone converts to BT.601 and says
// neither, which turns reds orange.
constexpr std::string_view bt709 =
    "-vf scale=out_color_matrix=bt709:out_range=tv -colorspace bt709 -color_primaries bt709 -color_trc bt709 "
    "-color_range tv";

// The encoder of ProRes takes what frames say of themselves.
constexpr std::string_view bt709_stated =
    "-vf scale=out_color_matrix=bt709:out_range=tv,"
    "setparams=range=tv:colorspace=bt709:color_primaries=bt709:color_trc=bt709 -colorspace bt709 "
    "-color_primaries bt709 -color_trc bt709 -color_range tv";

// H.264 at a quality where the eye sees no loss. In a file the index comes first, so that a page can start
// playing early. Of the curtain and the breaking cloth this takes a quarter less time than `veryfast`, for
// films an eighth larger and as near to their pictures (SSIM 0.9913 for 0.9917, and 0.9959 for 0.9962); plain
// `superfast`, which spreads its bits without looking ahead, makes them three times as large. More of them
// than usual go to what is nearly even (aq-strength): else the noise that keeps a sky from showing bands is
// taken for nothing, and the bands are there. That is a quarter more bytes, and no more time.
constexpr std::string_view h264 =
    "-c:v libx264 -preset superfast -x264-params mbtree=1:rc-lookahead=10:aq-mode=3:aq-strength=1.2 -crf 18 "
    "-pix_fmt yuv420p";

// The same with aq-mode, for a quarter more bytes.
constexpr std::string_view vp9 =
    "-c:v libvpx-vp9 -crf 24 -b:v 0 -deadline good -cpu-used 5 -row-mt 1 -aq-mode 1 -pix_fmt yuv420p";
constexpr std::string_view vp9_with_opacity =
    "-c:v libvpx-vp9 -crf 24 -b:v 0 -deadline good -cpu-used 5 -row-mt 1 -aq-mode 1 -pix_fmt yuva420p";

// A palette a frame: one for the whole film would have to hold all frames in memory first.
constexpr std::string_view gif =
    "-vf split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=bayer:bayer_scale=3 "
    "-loop 0";

// Every frame whole: libwebp_anim keeps blocks that it takes for unchanged, and what has moved away leaves
// ghosts. Of the breaking cloth at 640×360 that is half as much again in bytes.
constexpr std::string_view webp = "-c:v libwebp -quality 75 -compression_level 4 -loop 0";

constexpr std::string_view index_in_front = "-movflags +faststart";
constexpr std::string_view in_fragments = "-movflags +frag_keyframe+empty_moov+default_base_moof";

// What programs for cutting films take: every frame whole, 10 bits of colour at every pixel, 16 of opacity,
// which is straight.
constexpr std::string_view prores =
    "-c:v prores_ks -profile:v 4444 -vendor apl0 -alpha_bits 0 -pix_fmt yuv444p10le";
constexpr std::string_view prores_clear =
    "-c:v prores_ks -profile:v 4444 -vendor apl0 -alpha_bits 16 -pix_fmt yuva444p10le";

// More frames a second than any screen shows; what --fps takes.
constexpr double any_rate = 1000.0;
// Viewers take a shorter time than two hundredths of a second for ten.
constexpr double fastest_gif = 50.0;

constexpr std::array<FilmFormat, 5> formats{{
    {".mp4", true, false, true, 16384, any_rate, false, bt709, h264, {}, index_in_front, in_fragments},
    {".webm", true, true, true, 16384, any_rate, false, bt709, vp9, vp9_with_opacity, {}, {}},
    {".gif", false, false, true, 16384, fastest_gif, true, {}, gif, {}, {}, {}},
    {".webp", false, true, false, 16383, any_rate, true, {}, webp, webp, {}, {}},
    {".mov",
     false,
     true,
     false,
     16384,
     any_rate,
     false,
     bt709_stated,
     prores,
     prores_clear,
     index_in_front,
     {}},
}};

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

const FilmFormat* format_of(std::string_view ending) {
  const auto found = std::ranges::find(formats, ending, &FilmFormat::ending);
  return found == formats.end() ? nullptr : &*found;
}

// Whether there is something of that name that is neither a file nor a folder.
bool is_stream(const std::filesystem::path& name) {
  std::error_code error;
  const auto status = std::filesystem::status(name, error);
  return name == "-" || std::filesystem::is_fifo(status) || std::filesystem::is_character_file(status) ||
         std::filesystem::is_socket(status);
}

}  // namespace

std::span<const FilmFormat> film_formats() {
  return formats;
}

FilmTarget film_target(const std::filesystem::path& name) {
  const std::string text = name.string();
  const std::size_t colon = text.find(':');
  const FilmFormat* const named =
      colon == std::string::npos ? nullptr : format_of(std::string(".").append(text, 0, colon));
  FilmTarget target{named != nullptr ? std::filesystem::path(text.substr(colon + 1)) : name, false, named};
  target.stream = is_stream(target.file);
  // Only in front of a pipe: a file has an ending, and its name may have a colon in it.
  if (!target.stream && named != nullptr) target = {name, is_stream(name), nullptr};
  if (target.format == nullptr) target.format = format_of(lower_case(target.file.extension().string()));
  if (target.format == nullptr && target.stream) target.format = &formats.front();
  return target;
}

}  // namespace taut
