#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace taut {

/// One thing wrong with an input, and where.
struct Diagnostic {
  std::string origin;      ///< what the input is called: a file, or a flag such as `--set world.drag=x`
  std::size_t line = 0;    ///< from 1; 0: no place within the origin
  std::size_t column = 0;  ///< in characters (code points), from 1
  std::string message;     ///< one sentence without full stop
  std::string hint;        ///< a line below the caret, such as `did you mean "drag"?`; may be empty
  std::string key{};       ///< which key of the input, as a dotted path; may be empty
};

/// One diagnostic as text without a final newline: `origin:line:column: message`, then, when it has a line,
/// that line of `text` and a caret under the column, then the hint. Characters that would move the cursor or
/// colour the terminal are replaced, and long lines cut to what lies around the caret.
std::string to_text(const Diagnostic& diagnostic, std::string_view text);

/// One diagnostic as one line, `origin:line:column: message`, without the line of the text and the hint.
std::string one_line(const Diagnostic& diagnostic);

/// Those with a line first, in the order of lines and columns.
std::vector<Diagnostic> in_order(std::vector<Diagnostic> diagnostics);

/// All of them, in_order(). After `most` of them follows a
/// count of the others and of `left_out` more that the caller did not keep.
std::string to_text(std::vector<Diagnostic> diagnostics, std::string_view text, std::size_t most,
                    std::size_t left_out = 0);

/// A name between double quotes, fit for a one-line message: control characters replaced, long ones cut.
std::string in_quotes(std::string_view name);

/// `did you mean "name" (unit)?`, without the brackets when there is no unit; empty when there is no name.
std::string did_you_mean(std::string_view name, std::string_view unit = {});

}  // namespace taut
