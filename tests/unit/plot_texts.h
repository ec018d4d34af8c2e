#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

#include "output/gnuplot.h"
#include "output/label_layout.h"
#include "temporary_folder.h"

namespace taut::testing {

/// A text of an SVG that gnuplot has written.
struct PlotTextShown {
  std::string text;
  LabelBox box;        ///< pixels, y from the upper edge downwards
  std::string colour;  ///< #rrggbb
};

/// The SVG of a plot.
inline std::string svg_of(const PlotScript& plot) {
  const TemporaryFolder folder;
  write_plot(plot, folder / "plot");
  return read_file(folder / "plot.svg");
}

/// What a group's fill says: "rgb( 51, 51, 51)", or black.
inline std::string colour_in(const std::string& fill) {
  static const std::regex parts(R"(rgb\(\s*(\d+),\s*(\d+),\s*(\d+)\))");
  std::smatch found;
  if (!std::regex_search(fill, found, parts)) return "#000000";
  return fmt::format("#{:02x}{:02x}{:02x}", std::stoi(found[1]), std::stoi(found[2]), std::stoi(found[3]));
}

/// All texts of an SVG, as wide as their letters make them.
inline std::vector<PlotTextShown> texts_of(const std::string& svg) {
  static const std::regex group(
      R"re(<g transform="translate\(([-\d.]+),([-\d.]+)\)( rotate\([-\d.]+\))?" stroke="none" fill="([^"]*)"[^>]*font-size="([\d.]+)"\s+text-anchor="(\w+)">\s*<text>(.*?)</text>)re");
  static const std::regex tag("<[^>]*>");
  std::vector<PlotTextShown> texts;
  for (std::sregex_iterator at(svg.begin(), svg.end(), group), end; at != end; ++at) {
    const std::smatch& found = *at;
    PlotTextShown shown;
    shown.text = std::regex_replace(found[7].str(), tag, "");
    shown.colour = colour_in(found[4]);
    const double x = std::stod(found[1]), y = std::stod(found[2]), size = std::stod(found[5]);
    const double width = text_width(shown.text, 3) * size / 4.0;  // letters of 3 are 4 pixels large
    const std::string anchor = found[6];
    const double before = anchor == "start" ? 0.0 : anchor == "middle" ? 0.5 * width : width;
    if (found[3].matched)  // upwards
      shown.box = {x - 0.8 * size, x + 0.2 * size, y + before - width, y + before};
    else
      shown.box = {x - before, x - before + width, y - 0.8 * size, y + 0.2 * size};
    if (!shown.text.empty()) texts.push_back(shown);
  }
  return texts;
}

/// Expects that all texts lie within the picture, and none over another.
inline void expect_texts_apart(const std::vector<PlotTextShown>& texts, Size size) {
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const LabelBox& box = texts[i].box;
    EXPECT_GE(box.left, 0.0) << texts[i].text;
    EXPECT_LE(box.right, size.width) << texts[i].text;
    EXPECT_GE(box.low, 0.0) << texts[i].text;
    EXPECT_LE(box.high, size.height) << texts[i].text;
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(box.meets(texts[j].box)) << texts[i].text << " over " << texts[j].text;
  }
}

}  // namespace taut::testing
