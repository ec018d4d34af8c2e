#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/stop.h"
#include "study/chart.h"

namespace taut {

/// A chart as JSON text: everything, with every raw time.
std::string chart_json(const Chart& chart);

/// A chart from that text, whatever build has written it: all that is drawn or tabled of it, not what it
/// would take to go on. `file` is for the message. Throws BadRequest where the text is none.
Chart chart_from_json(const std::string& text, const std::string& file);

/// The same as a table, a line a case: curve, method, steps_per_second or tolerance, passes, errors, link
/// solves, least times.
std::string chart_csv(const Chart& chart);

/// Writes <scene>.json and <scene>.csv into a folder, and its pictures. Throws RunFailure, and
/// Interrupted.
void write_chart(const Chart& chart, const std::filesystem::path& folder, const StopTest& stop = {});

/// Draws a chart for every kind of error: <scene>-<error>.png and .svg (time) and <scene>-<error>-solves.png
/// and .svg (link solves) into a folder, each with its caption beside it, as .txt. Throws
/// RunFailure, and Interrupted.
void draw_chart(const Chart& chart, const std::filesystem::path& folder, const StopTest& stop = {});

/// Writes a text that is of several charts into their folder. Throws RunFailure.
void write_chart_text(const std::string& name, const std::string& text, const std::filesystem::path& folder);

/// Writes chart.html, one page with all charts in it. Throws RunFailure.
void write_chart_page(const std::vector<Chart>& charts, const std::filesystem::path& folder);

}  // namespace taut
