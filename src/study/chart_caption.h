#pragma once

#include <string>

#include "study/chart.h"

namespace taut {

/// What the y axis of a chart counts.
enum class ChartCost { seconds, link_solves };

/// What a chart says of itself below its picture, in one line.
std::string short_note(const Chart& chart);

/// The caption of a chart, a paragraph a line: what is shown and how to read it, what it was judged by, what
/// diverged or was left out, and what times were measured on. `stem` is the name of the picture's files.
std::string chart_caption(const Chart& chart, ErrorKind kind, ChartCost cost, const std::string& stem);

}  // namespace taut
