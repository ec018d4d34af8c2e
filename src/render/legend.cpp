#include "legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

// Lengths (pixels): in proportion to the picture; in small ones larger, to be read, as far as there is room.
struct Layout {
  double unit;
  double text_size = 19.0 * unit, margin = 22.0 * unit, padding = 14.0 * unit, gap = 9.0 * unit;
  int bar_width = std::max(static_cast<int>(std::round(240.0 * unit)), 1);
  int bar_height = std::max(static_cast<int>(std::round(12.0 * unit)), 1);

  explicit Layout(Size size) : unit(std::min(std::max(size.height / 720.0, 0.6), size.width / 480.0)) {}
};

// Behind the bar's end: larger values have its last colour.
void draw_arrow(Image& image, const LegendBar& bar, const Colour& colour) {
  const int length = std::max(bar.height / 2, 2);
  for (int i = 0; i < length; ++i) {
    const double inset = 0.5 * bar.height * (i + 0.5) / length;
    fill_rectangle(image, {1.0 * bar.left + bar.width + i, bar.top + inset, 1.0, bar.height - 2.0 * inset},
                   {colour, 1.0});
  }
}

}  // namespace

LegendBar draw_legend(Image& image, const Font& font, ColourBy by, const ColourScale& scale) {
  const Wording words = wording(by);
  const bool dark = scale.theme == Theme::dark;
  const Paint ink{dark ? Colour{0.88, 0.90, 0.93} : Colour{0.16, 0.18, 0.22}, 1.0};
  const Paint panel{dark ? Colour{0.08, 0.09, 0.11} : Colour{1.0, 1.0, 1.0}, 0.62};

  const Layout layout(image.size);
  const double line = font.capital_height(layout.text_size);
  const double width = layout.bar_width + 2.0 * layout.padding;
  const double height = 2.0 * layout.padding + 2.0 * line + 2.0 * layout.gap + layout.bar_height;
  const double left = layout.margin, top = image.size.height - layout.margin - height;

  fill_rectangle(image, {left, top, width, height}, panel);
  font.draw(image, {left + layout.padding, top + layout.padding + line},
            fmt::format("{} ({})", words.title, words.unit), layout.text_size, ink);
  // On whole pixels, each of one value's colour: between pixels the panel would show through.
  const LegendBar bar{static_cast<int>(std::round(left + layout.padding)),
                      static_cast<int>(std::round(top + layout.padding + line + layout.gap)),
                      layout.bar_width, layout.bar_height};
  for (int i = 0; i < bar.width; ++i)
    fill_rectangle(image, {1.0 * bar.left + i, 1.0 * bar.top, 1.0, 1.0 * bar.height},
                   {scale.at(scale.value_at((i + 0.5) / bar.width)), 1.0});
  if (scale.open) draw_arrow(image, bar, scale.at(scale.top));
  const double baseline = bar.top + bar.height + layout.gap + line;
  for (const double share : {0.0, 0.5, 1.0}) {
    const double value = scale.value_at(share) * words.factor;
    const std::string number =
        scale.steps == ColourSteps::log ? fmt::format("{:.2g}", value) : fmt::format("{:.4g}", value);
    // The outer numbers end flush with the bar.
    const double at = bar.left + share * (bar.width - font.width(number, layout.text_size));
    font.draw(image, {at, baseline}, number, layout.text_size, ink);
  }
  return bar;
}

}  // namespace taut
