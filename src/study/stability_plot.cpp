#include "stability_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "base/split.h"
#include "map_cells.h"
#include "map_legend.h"
#include "map_panel.h"
#include "output/label_layout.h"
#include "output/plot_colour.h"

namespace taut {
namespace {

// Pixels of a page.
constexpr double page_left = 195.0, page_right = 75.0, head_height = 150.0;
constexpr double tic_room = 66.0, title_room = 74.0, axis_room = 70.0, panel_gap = 60.0;
constexpr std::size_t most_across = 4;

std::string_view row_title(const MapGrid& grid) {
  return grid.axes->rows == MapRows::step ? "step (s)" : "passes a step";
}

// The method's label; where it is too wide, broken at its colons.
std::vector<std::string> title_lines(const std::string& label, double width) {
  if (text_width(label, map_title_letters) <= width) return {label};
  std::vector<std::string> lines;
  for (const std::string_view part : split(label, ':')) {
    if (!lines.empty()) {
      const std::string longer = fmt::format("{}:{}", lines.back(), part);
      if (text_width(longer, map_title_letters) <= width) {
        lines.back() = longer;
        continue;
      }
      lines.back() += ":";
    }
    lines.emplace_back(part);
  }
  return lines;
}

std::string heading_commands(const MapHeading& heading, const PanelPlace& page) {
  return page_label(page, heading.title, 30.0, page.page_height - 45.0, "left", plot_letters + 6) +
         page_label(page, heading.subtitle, 30.0, page.page_height - 102.0, "left", map_title_letters - 2);
}

// Titles of the axes, once for all panels.
std::string axis_titles(const MapGrid& grid, const PanelPlace& all) {
  return page_label(all, grid.axes->title, 0.5 * (all.left + all.right),
                    all.bottom - tic_room - 0.5 * axis_room, "center", plot_letters) +
         page_label(all, row_title(grid), 40.0, 0.5 * (all.bottom + all.top), "center rotate by 90",
                    plot_letters);
}

PlotScript page_of(const StabilityMaps& maps, const MapHeading& heading, const PanelPlace& all,
                   const std::string& panels) {
  PlotScript plot;
  plot.size = {static_cast<int>(all.page_width), static_cast<int>(all.page_height)};
  plot.commands = fmt::format("set multiplot\nset border 15 lc rgb '{}' lw 1.5\n", plot_ink) +
                  heading_commands(heading, all) + axis_titles(maps.grid, all) + panels +
                  map_legend(shade_of(maps.grid), all.page_width, all.page_height) + "unset multiplot\n";
  return plot;
}

}  // namespace

PlotScript map_plot(const StabilityMaps& maps, const MethodMap& map, const MapHeading& heading) {
  constexpr double height = 760.0;
  const double bottom = legend_height + axis_room + tic_room;
  const PanelPlace place{page_left,    legend_width - page_right,    bottom, bottom + height,
                         legend_width, bottom + height + head_height};
  return page_of(maps, {fmt::format("{}: {}", map.method, heading.title), heading.subtitle}, place,
                 map_panel(maps, map, place, {}));
}

PlotScript overview_plot(const StabilityMaps& maps, const MapHeading& heading) {
  const std::size_t count = maps.maps.size();
  const std::size_t across = std::clamp<std::size_t>(count, 1, most_across),
                    down = (count + across - 1) / across;
  const double page_width =
      std::max(legend_width, page_left + page_right + 535.0 * static_cast<double>(across));
  const double pitch = (page_width - page_left - page_right + panel_gap) / static_cast<double>(across);
  const double width = pitch - panel_gap, height = std::clamp(0.85 * width, 420.0, 620.0);
  std::vector<std::vector<std::string>> titles;
  std::size_t lines = 1;
  for (const MethodMap& map : maps.maps) {
    titles.push_back(title_lines(map.method, pitch - 20.0));
    lines = std::max(lines, titles.back().size());
  }
  const double title = title_room + 0.85 * text_height(map_title_letters) * static_cast<double>(lines - 1);
  const double row_pitch = height + title + tic_room;
  const double bottom = legend_height + axis_room + tic_room;
  const double top = bottom + row_pitch * static_cast<double>(down) - title - tic_room;
  const PanelPlace all{page_left,  page_width - page_right,         bottom, top,
                       page_width, top + title + head_height - 20.0};
  std::string panels;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t column = i % across, row = i / across;
    const double left = page_left + pitch * static_cast<double>(column);
    const double upper = top - row_pitch * static_cast<double>(row);
    panels += map_panel(maps, maps.maps[i],
                        {left, left + width, upper - height, upper, all.page_width, all.page_height},
                        {titles[i], i + across >= count, column == 0});
  }
  return page_of(maps, heading, all, panels);
}

}  // namespace taut
