#include "map_legend.h"

#include <fmt/format.h>

#include <cmath>

#include "map_panel.h"
#include "output/label_layout.h"
#include "output/plot_colour.h"

namespace taut {
namespace {

constexpr double swatch_width = 52.0, swatch_height = 32.0;                               // pixels
constexpr double upper_row = 140.0, lower_row = 98.0, scale_row = 58.0, foot_row = 22.0;  // middles

// Plots in pixels of the page.
class LegendPart {
 public:
  LegendPart(double page_width, double page_height)
      : page_{0.0, page_width, 0.0, legend_height, page_width, page_height} {
    script_ = margins(page_) +
              fmt::format("set xrange [0:{}]\nset yrange [0:{}]\nunset border\nunset tics\nunset grid\n",
                          page_width, legend_height);
  }
  void text(double x, double y, std::string_view text, std::string_view how) {
    script_ += page_label(page_, text, x, y, how, map_text_letters);
  }
  void power(double x, double y, int power) {
    script_ += fmt::format("set label '10^{{{}}}' at screen {:.6f},{:.6f} center font ',{}' tc rgb '{}'\n",
                           power, x / page_.page_width, y / page_.page_height, map_tic_letters, plot_ink);
  }
  void draw(const std::string& points, std::string_view how) {
    data_ += fmt::format("$legend{} << END\n{}END\n", drawn_, points);
    plots_ += fmt::format("{} $legend{} {}", drawn_ == 0 ? "plot" : ", \\\n", drawn_, how);
    ++drawn_;
  }
  void box(double left, double middle, std::string_view how) {
    draw(fmt::format("{0} {1} {0} {2} {3} {4}\n", left, middle, left + swatch_width,
                     middle - 0.5 * swatch_height, middle + 0.5 * swatch_height),
         fmt::format("{} {}", map_cell_boxes, how));
  }
  void frame(double left, double right, double middle) {
    const double low = middle - 0.5 * swatch_height, high = middle + 0.5 * swatch_height;
    draw(fmt::format("{0} {2}\n{1} {2}\n{1} {3}\n{0} {3}\n{0} {2}\n", left, right, low, high),
         fmt::format("with lines lw 1.5 lc rgb '{}'", plot_ink));
  }
  // The shades from a paint on, from left to right; an image has two rows at least.
  void shades(double left, double middle, std::size_t first) {
    std::string cells;
    for (const double row : {-0.25, 0.25})
      for (std::size_t i = 0; i < error_shades; ++i)
        cells += image_cell(left + swatch_width * (static_cast<double>(i) + 0.5),
                            middle + row * swatch_height, map_paint(first + i));
    draw(cells, map_image);
    frame(left, left + swatch_width * static_cast<double>(error_shades), middle);
  }
  std::string script() const { return script_ + data_ + plots_ + "\nunset label\n"; }

 private:
  PanelPlace page_;
  std::string script_, data_, plots_;
  int drawn_ = 0;
};

}  // namespace

std::string map_legend(ShadeOf what, double page_width, double page_height) {
  constexpr std::string_view held = "energy held", drifted = "energy over 1 % off";
  const double left = 0.5 * (page_width - legend_width) + 45.0 + text_width(drifted, map_text_letters);
  const double width = swatch_width * static_cast<double>(error_shades);
  const double hatches = left + width + 70.0, edges = hatches + swatch_width + 200.0;
  LegendPart legend(page_width, page_height);
  legend.text(left - 12.0, upper_row, held, "right");
  legend.text(left - 12.0, lower_row, drifted, "right");
  legend.shades(left, upper_row, 0);
  legend.shades(left, lower_row, error_shades);
  const int lowest = static_cast<int>(std::lround(std::log10(least_error)));
  for (std::size_t i = 0; i <= error_shades; i += 2)
    legend.power(left + swatch_width * static_cast<double>(i), scale_row, lowest + static_cast<int>(i));
  legend.text(left + 0.5 * width, foot_row,
              what == ShadeOf::error ? "position error / length of all links" : "largest strain", "center");
  legend.box(hatches, upper_row, map_hatch_diverged);
  legend.frame(hatches, hatches + swatch_width, upper_row);
  legend.text(hatches + swatch_width + 14.0, upper_row, "diverged", "left");
  legend.box(hatches, lower_row, map_hatch_refused);
  legend.frame(hatches, hatches + swatch_width, lower_row);
  legend.text(hatches + swatch_width + 14.0, lower_row, "refused", "left");
  const std::string circle = fmt::format("{} {}\n", edges + 0.5 * swatch_width, upper_row);
  legend.draw(circle, map_edge_ring);
  legend.draw(circle, map_edge_core);
  legend.text(edges + swatch_width + 34.0, upper_row, "measured edge", "left");
  const std::string line =
      fmt::format("{0} {2}\n{1} {2}\n", edges - 18.0, edges + swatch_width + 18.0, lower_row);
  legend.draw(line, map_predicted_line);
  legend.text(edges + swatch_width + 34.0, lower_row, "theory", "left");
  return legend.script();
}

}  // namespace taut
