#include "frames/captions.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/utf8.h"

namespace taut {
namespace {

// On either plate all of them have a contrast of at least 4.5.
struct Inks {
  Colour plate, title, line, warning;
};

Inks inks(Theme theme) {
  if (theme == Theme::dark)
    return {{0.09, 0.10, 0.12}, {0.93, 0.94, 0.96}, {0.72, 0.75, 0.79}, {1.00, 0.62, 0.45}};
  return {{0.98, 0.98, 0.99}, {0.10, 0.12, 0.15}, {0.33, 0.36, 0.41}, {0.70, 0.18, 0.03}};
}

// Height of letters in the upper row (pixels): to be read, but never more than a third of the picture for
// all.
double letter_size(Size picture) {
  const double wanted = std::clamp(0.042 * std::min(1.0 * picture.height, 0.75 * picture.width), 11.0, 60.0);
  return std::min(wanted, picture.height / 8.0);
}

constexpr double margin = 0.7, upper_baseline = 1.15, lower_baseline = 2.15, rows_height = 2.65;  // letters
constexpr double lower_size = 0.78, smallest_size = 0.7;

// The text, or as much of it as has room, with an ellipsis.
std::string shortened(const Font& font, std::string_view text, double size, double room) {
  if (font.width(text, size) <= room) return std::string(text);
  std::string kept;
  while (!text.empty()) {
    const std::size_t length = std::max<std::size_t>(utf8_length(text), 1);
    const std::string longer = kept + std::string(text.substr(0, length));
    if (font.width(longer + "…", size) > room) break;
    kept = longer;
    text.remove_prefix(length);
  }
  return kept + "…";
}

void write_fitting(const Font& font, Image& sheet, const Point& baseline, std::string_view text, double size,
                   double room, const Colour& colour) {
  const double width = font.width(text, size);
  const double fitting = width > room ? std::max(size * room / width, smallest_size * size) : size;
  font.draw(sheet, baseline, shortened(font, text, fitting, room), fitting, {colour, 1.0});
}

}  // namespace

int caption_height(Size picture) {
  return static_cast<int>(std::ceil(rows_height * letter_size(picture)));
}

void CaptionWriter::fill(Image& sheet, const Rectangle& area) const {
  fill_rectangle(sheet, area, {inks(theme_).plate, 1.0});
}

void CaptionWriter::write(Image& sheet, const Rectangle& band, Size picture, const Caption& caption) const {
  fill(sheet, band);
  const Inks colours = inks(theme_);
  const double letters = letter_size(picture);
  const double left = band.left + margin * letters, room = band.width - 2.0 * margin * letters;
  const double upper = band.top + upper_baseline * letters, lower = band.top + lower_baseline * letters;
  const double time_width = caption.time.empty() ? 0.0 : font_.width(caption.time, letters);
  if (!caption.title.empty())
    write_fitting(font_, sheet, {left, upper}, caption.title, letters,
                  room - (time_width > 0.0 ? time_width + letters : 0.0), colours.title);
  // A time that stands alone stands where the title would.
  const double time_at = caption.title.empty() ? left : left + room - time_width;
  font_.draw(sheet, {time_at, upper}, caption.time, letters, {colours.title, 1.0});
  write_fitting(font_, sheet, {left, lower}, caption.line, lower_size * letters, room,
                caption.failed ? colours.warning : colours.line);
}

}  // namespace taut
