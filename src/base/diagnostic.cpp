#include "base/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "base/utf8.h"

namespace taut {
namespace {

constexpr std::string_view indent = "    ";
constexpr std::string_view ellipsis = "…";

// Line `number` of the text, from 1, without its end; empty beyond the last.
std::string_view line_of(std::string_view text, std::size_t number) {
  for (std::size_t line = 1; line < number; ++line) {
    const std::size_t end = text.find('\n');
    if (end == std::string_view::npos) return {};
    text.remove_prefix(end + 1);
  }
  text = text.substr(0, text.find('\n'));
  if (text.ends_with('\r')) text.remove_suffix(1);
  return text;
}

// Where the character that begins here ends.
std::size_t end_of_character(std::string_view line, std::size_t begin) {
  return std::min(line.size(), begin + std::max<std::size_t>(1, utf8_length(line.substr(begin))));
}

// A part of a line, and where in it the caret stands.
struct Excerpt {
  std::vector<std::string> characters;
  std::size_t caret = 0;
  bool goes_on_before = false, goes_on_after = false;
};

// The characters around a column. Of a line of megabytes no more than these are made.
Excerpt excerpt_around(std::string_view line, std::size_t column) {
  constexpr std::size_t most_before = 70, most_after = 50;
  std::size_t caret = 0;                          // characters before it
  std::array<std::size_t, most_before> begins{};  // of the last ones, by their number
  std::size_t at = 0;
  for (; caret + 1 < column && at < line.size(); ++caret) {
    begins[caret % most_before] = at;
    at = end_of_character(line, at);
  }
  Excerpt excerpt;
  excerpt.goes_on_before = caret > most_before;
  excerpt.caret = std::min(caret, most_before);
  std::size_t from = excerpt.goes_on_before ? begins[caret % most_before] : 0;
  while (from < line.size() && excerpt.characters.size() < excerpt.caret + most_after) {
    const std::size_t end = end_of_character(line, from);
    excerpt.characters.push_back(printable(line.substr(from, end - from), true));
    from = end;
  }
  excerpt.goes_on_after = from < line.size();
  return excerpt;
}

// How many columns a terminal gives a character. Only the blocks that are wide throughout: a name in Chinese,
// Japanese or Korean, or an emoji, must not push the caret off its place; combining marks take no column.
std::size_t columns_of(std::string_view c) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(c[i]); };
  if (c.size() == 2) {
    const unsigned code = (byte(0) & 0x1FU) << 6U | (byte(1) & 0x3FU);
    return code >= 0x300 && code <= 0x36F ? 0 : 1;
  }
  if (c.size() == 3) {
    const unsigned code = (byte(0) & 0x0FU) << 12U | (byte(1) & 0x3FU) << 6U | (byte(2) & 0x3FU);
    const bool wide = (code >= 0x1100 && code <= 0x115F) || (code >= 0x2E80 && code <= 0xA4CF) ||
                      (code >= 0xAC00 && code <= 0xD7A3) || (code >= 0xF900 && code <= 0xFAFF) ||
                      (code >= 0xFF00 && code <= 0xFF60);
    return wide ? 2 : 1;
  }
  if (c.size() == 4) {
    const unsigned code =
        (byte(0) & 0x07U) << 18U | (byte(1) & 0x3FU) << 12U | (byte(2) & 0x3FU) << 6U | (byte(3) & 0x3FU);
    return (code >= 0x1F300 && code <= 0x1FAFF) || (code >= 0x20000 && code <= 0x3FFFD) ? 2 : 1;
  }
  return 1;
}

// The line and below it the caret. Tabs before the caret are repeated, so it stands right at any tab width.
std::string with_caret(std::string_view line, std::size_t column) {
  const Excerpt excerpt = excerpt_around(line, column);
  std::string shown{indent}, below{indent};
  if (excerpt.goes_on_before) {
    shown += ellipsis;
    below += ' ';
  }
  for (std::size_t i = 0; i < excerpt.characters.size(); ++i) {
    const std::string& character = excerpt.characters[i];
    shown += character;
    if (i < excerpt.caret) below += character == "\t" ? "\t" : std::string(columns_of(character), ' ');
  }
  if (excerpt.goes_on_after) shown += ellipsis;
  return shown + "\n" + below + "^";
}

}  // namespace

std::string one_line(const Diagnostic& diagnostic) {
  const std::string origin = printable(diagnostic.origin);
  const std::string message = printable(diagnostic.message);
  if (diagnostic.line == 0) return fmt::format("{}: {}", origin, message);
  return fmt::format("{}:{}:{}: {}", origin, diagnostic.line, diagnostic.column, message);
}

std::string to_text(const Diagnostic& diagnostic, std::string_view text) {
  std::string out = one_line(diagnostic);
  if (diagnostic.line > 0)
    out += fmt::format("\n{}", with_caret(line_of(text, diagnostic.line), diagnostic.column));
  if (!diagnostic.hint.empty()) out += fmt::format("\n{}{}", indent, printable(diagnostic.hint));
  return out;
}

std::vector<Diagnostic> in_order(std::vector<Diagnostic> diagnostics) {
  const auto place = [](const Diagnostic& d) { return std::tuple(d.line == 0, d.line, d.column); };
  std::ranges::stable_sort(diagnostics, {}, place);
  return diagnostics;
}

std::string to_text(std::vector<Diagnostic> diagnostics, std::string_view text, std::size_t most,
                    std::size_t left_out) {
  diagnostics = in_order(std::move(diagnostics));
  std::string out;
  for (std::size_t i = 0; i < std::min(most, diagnostics.size()); ++i) {
    if (i > 0) out += '\n';
    out += to_text(diagnostics[i], text);
  }
  const std::size_t rest = diagnostics.size() - std::min(most, diagnostics.size()) + left_out;
  if (rest > 0) out += fmt::format("\n… and {} more error{}", rest, rest == 1 ? "" : "s");
  return out;
}

std::string in_quotes(std::string_view name) {
  constexpr std::size_t longest = 60;  // bytes
  if (name.size() <= longest) return fmt::format("\"{}\"", printable(name));
  std::size_t end = 0;
  while (end < longest) end += std::max<std::size_t>(1, utf8_length(name.substr(end)));
  return fmt::format("\"{}{}\"", printable(name.substr(0, end)), ellipsis);
}

std::string did_you_mean(std::string_view name, std::string_view unit) {
  if (name.empty()) return {};
  return unit.empty() ? fmt::format("did you mean {}?", in_quotes(name))
                      : fmt::format("did you mean {} ({})?", in_quotes(name), unit);
}

}  // namespace taut
