#include "legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace taut {
namespace {

struct Wording {
  std::string_view title, unit;
  double factor;  ///< from SI to the unit shown
};

Wording wording(ColourBy by) {
  switch (by) {
    case ColourBy::tension:
      return {"tension", "N", 1.0};
    case ColourBy::speed:
      return {"speed", "m/s", 1.0};
    case ColourBy::limit:
      return {"way to the stop", "%", 100.0};
    default:
      return {"strain", "%", 100.0};
  }
}

}  // namespace

void draw_legend(Image& image, const Font& font, ColourBy by, const ColourScale& scale) {
  const Wording words = wording(by);
  const bool dark = scale.theme == Theme::dark;
  const Paint ink{dark ? Colour{0.88, 0.90, 0.93} : Colour{0.16, 0.18, 0.22}, 1.0};
  const Paint panel{dark ? Colour{0.08, 0.09, 0.11} : Colour{1.0, 1.0, 1.0}, 0.62};

  // In proportion to the picture; in small ones larger, to be read, as far as there is room.
  const double unit = std::min(std::max(image.size.height / 720.0, 0.6), image.size.width / 480.0);
  const double text_size = 19.0 * unit, margin = 22.0 * unit, padding = 14.0 * unit;
  const double bar_width = 240.0 * unit, bar_height = 12.0 * unit, gap = 9.0 * unit;
  const double line = font.capital_height(text_size);
  const double width = bar_width + 2.0 * padding;
  const double height = 2.0 * padding + 2.0 * line + 2.0 * gap + bar_height;
  const double left = margin, top = image.size.height - margin - height;

  fill_rectangle(image, {left, top, width, height}, panel);
  font.draw(image, {left + padding, top + padding + line}, fmt::format("{} ({})", words.title, words.unit),
            text_size, ink);
  const double bar_top = top + padding + line + gap;
  const int strips = std::max(static_cast<int>(bar_width), 1);
  for (int i = 0; i < strips; ++i) {
    const double share = (i + 0.5) / strips;
    fill_rectangle(image, {left + padding + i * bar_width / strips, bar_top, bar_width / strips, bar_height},
                   {scale.at(share * scale.top), 1.0});
  }
  const double baseline = bar_top + bar_height + gap + line;
  for (const double share : {0.0, 0.5, 1.0}) {
    const std::string number = fmt::format("{:.4g}", share * scale.top * words.factor);
    // The outer numbers end flush with the bar.
    const double at = left + padding + share * (bar_width - font.width(number, text_size));
    font.draw(image, {at, baseline}, number, text_size, ink);
  }
}

}  // namespace taut
