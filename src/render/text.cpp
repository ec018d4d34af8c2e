#include "render/text.h"

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <vector>

#include "base/failure.h"
#include "base/utf8.h"

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb_truetype.h>

namespace taut {

struct Font::Face {
  std::vector<unsigned char> file;
  stbtt_fontinfo info{};
};

namespace {

std::filesystem::path find_font() {
  static constexpr std::array places{
      "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/dejavu/DejaVuSans.ttf",
      "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf", "/usr/share/fonts/TTF/DejaVuSans.ttf",
      "/usr/local/share/fonts/DejaVuSans.ttf"};
  for (const char* place : places) {
    if (std::filesystem::exists(place)) return place;
  }
  throw RunFailure("text needs the font DejaVu Sans (Debian package fonts-dejavu-core), which is not there");
}

std::vector<unsigned char> read_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw RunFailure("font " + path.string() + " can't be read");
  return {std::istreambuf_iterator<char>(file), {}};
}

constexpr int replacement_character = 0xFFFD;

/// Takes the first character off UTF-8 text; a malformed byte counts as the replacement character.
int next_codepoint(std::string_view& text) {
  const std::size_t length = utf8_length(text);
  const auto lead = static_cast<unsigned char>(text.front());
  // The lead byte of n > 1 bytes carries 7 − n bits, each one after it six.
  int codepoint = length == 0 ? replacement_character : length == 1 ? lead : lead & (0x7F >> length);
  for (std::size_t i = 1; i < length; ++i) {
    codepoint = (codepoint << 6) | (static_cast<unsigned char>(text[i]) & 0x3F);
  }
  text.remove_prefix(length == 0 ? 1 : length);
  return codepoint;
}

/// Calls with each character's codepoint and pen position (pixels); returns the width of the whole.
template <typename Visit>
double for_each_character(const stbtt_fontinfo& info, std::string_view text, double scale,
                          const Visit& visit) {
  double pen = 0.0;
  int previous = 0;
  while (!text.empty()) {
    const int codepoint = next_codepoint(text);
    if (previous != 0) pen += scale * stbtt_GetCodepointKernAdvance(&info, previous, codepoint);
    visit(codepoint, pen);
    int advance = 0, bearing = 0;
    stbtt_GetCodepointHMetrics(&info, codepoint, &advance, &bearing);
    pen += scale * advance;
    previous = codepoint;
  }
  return pen;
}

void draw_character(Image& image, const stbtt_fontinfo& info, int codepoint, const Point& at, double scale,
                    const Paint& paint) {
  const double left = std::floor(at.x), top = std::floor(at.y);
  const auto size = static_cast<float>(scale);
  const auto shift_x = static_cast<float>(at.x - left), shift_y = static_cast<float>(at.y - top);
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  stbtt_GetCodepointBitmapBoxSubpixel(&info, codepoint, size, size, shift_x, shift_y, &x0, &y0, &x1, &y1);
  const int width = x1 - x0, height = y1 - y0;
  if (width <= 0 || height <= 0) return;
  std::vector<unsigned char> coverage(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  stbtt_MakeCodepointBitmapSubpixel(&info, coverage.data(), width, height, width, size, size, shift_x,
                                    shift_y, codepoint);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto share = coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                  static_cast<std::size_t>(x)];
      blend_pixel(image, static_cast<int>(left) + x0 + x, static_cast<int>(top) + y0 + y, paint,
                  share / 255.0);
    }
  }
}

double scale_of(const stbtt_fontinfo& info, double size) {
  return static_cast<double>(stbtt_ScaleForPixelHeight(&info, static_cast<float>(size)));
}

}  // namespace

Font Font::load(const std::filesystem::path& file) {
  const std::filesystem::path path = file.empty() ? find_font() : file;
  auto face = std::make_shared<Face>();
  face->file = read_bytes(path);
  const int offset = face->file.size() < 12 ? -1 : stbtt_GetFontOffsetForIndex(face->file.data(), 0);
  if (offset < 0 || stbtt_InitFont(&face->info, face->file.data(), offset) == 0) {
    throw RunFailure("font " + path.string() + " is no TrueType file");
  }
  return Font(std::move(face));
}

double Font::width(std::string_view text, double size) const {
  return for_each_character(face_->info, text, scale_of(face_->info, size), [](int, double) {});
}

double Font::capital_height(double size) const {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  stbtt_GetCodepointBox(&face_->info, 'H', &x0, &y0, &x1, &y1);
  return scale_of(face_->info, size) * y1;
}

void Font::draw(Image& image, const Point& baseline, std::string_view text, double size,
                const Paint& paint) const {
  const double scale = scale_of(face_->info, size);
  for_each_character(face_->info, text, scale, [&](int codepoint, double pen) {
    draw_character(image, face_->info, codepoint, {baseline.x + pen, baseline.y}, scale, paint);
  });
}

}  // namespace taut
