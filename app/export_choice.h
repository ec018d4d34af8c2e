#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "output/export.h"

namespace taut {

/// What the flags of `taut export` say about format and place, as they stand on the command line.
struct ExportChoice {
  std::string format, table, output;
};

/// What --format and --table may be.
std::vector<std::string_view> export_format_names();
inline constexpr std::array<std::string_view, 4> export_table_names{"masses", "links", "orientations",
                                                                    "energy"};

/// The format that is asked for: by its name, or else by the ending of the output's name; CSV where neither
/// says. Throws BadRequest where table or output don't go with it.
const ExportFormat& chosen_format(const ExportChoice& choice);

/// The table that a text means; empty: the format's usual one. Throws BadRequest.
ExportTable parse_export_table(const std::string& text);

/// Whether the output is standard output.
bool goes_to_stdout(const ExportChoice& choice);

}  // namespace taut
