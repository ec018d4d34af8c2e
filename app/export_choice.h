#pragma once

#include <string>

#include "output/export.h"

namespace taut {

/// What the flags of `taut export` say about format and place, as they stand on the command line.
struct ExportChoice {
  std::string format, table, output;
};

/// The format that is asked for: by its name, or else by the ending of the output's name; CSV where neither
/// says. Throws BadRequest where table or output don't go with it.
const ExportFormat& chosen_format(const ExportChoice& choice);

/// The table that a text means; empty: the format's usual one. Throws BadRequest.
ExportTable parse_export_table(const std::string& text);

/// Whether the output is standard output.
bool goes_to_stdout(const ExportChoice& choice);

}  // namespace taut
