#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/stability_map.h"

namespace taut {

/// Where a panel lies on its page (pixels from the lower left), and the page's size.
struct PanelPlace {
  double left, right, bottom, top;
  double page_width, page_height;
};

/// A panel's title, of one or two lines, and which axes have texts.
struct PanelTexts {
  std::vector<std::string> title;
  bool x = true, y = true;
};

/// Sets the four margins of a plot as gnuplot commands.
std::string margins(const PanelPlace& place);

/// A text at a place of the page (pixels) as gnuplot commands; `how`: left, center, right, and what else
/// gnuplot knows of a label.
std::string page_label(const PanelPlace& page, std::string_view text, double x, double y,
                       std::string_view how, int letters);

/// One panel of a multiplot: cells as an image, hatched where runs diverged or were refused, the measured
/// edge as circles and the predicted one as a line with its formula.
std::string map_panel(const StabilityMaps& maps, const MethodMap& map, const PanelPlace& place,
                      const PanelTexts& texts);

/// How parts of panels are drawn, for legends, too.
inline constexpr std::string_view map_cell_boxes = "using 1:2:3:4:5:6 with boxxyerror";
inline constexpr std::string_view map_image = "using 1:2:3:4:5 with rgbimage";
inline constexpr std::string_view map_hatch_diverged = "fs transparent pattern 5 noborder fc rgb '#6a6a6a'";
inline constexpr std::string_view map_hatch_refused = "fs transparent pattern 1 noborder fc rgb '#9a9a9a'";
inline constexpr std::string_view map_casing_line = "with lines lw 8 lc rgb '#ffffff'";
inline constexpr std::string_view map_predicted_line = "with lines lw 4 dt (14,7) lc rgb '#000000'";
inline constexpr std::string_view map_edge_ring = "with points pt 7 ps 2.2*marker lc rgb '#000000'";
inline constexpr std::string_view map_edge_core = "with points pt 7 ps 1.5*marker lc rgb '#ffffff'";

/// A cell of an image as text: x, y, red, green, blue.
std::string image_cell(double x, double y, std::string_view colour);

/// Sizes of letters on maps.
inline constexpr int map_tic_letters = 24, map_text_letters = 24, map_title_letters = 30;

}  // namespace taut
