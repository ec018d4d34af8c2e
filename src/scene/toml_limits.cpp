#include <fmt/format.h>

#include <algorithm>

#include "base/utf8.h"
#include "toml_text.h"

namespace taut {
namespace {

// Walks over TOML as far as needed to tell strings and comments from the rest, and counts the parts of
// dotted keys and the open brackets. Knows nothing else of the grammar: what is wrong otherwise is for the
// parser to say.
class DepthScan {
 public:
  explicit DepthScan(std::string_view text) : text_(text) {}

  std::optional<SyntaxError> run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '"' || c == '\'') {
        skip_string(c);
        line_is_blank_ = false;
      } else if (c == '#') {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else {
        if (auto error = count(c)) return error;
        ++at_;
      }
    }
    return std::nullopt;
  }

 private:
  void skip_string(char quote) {
    const std::string triple(3, quote);
    const bool long_string = text_.substr(at_, 3) == triple;
    at_ += long_string ? 3 : 1;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '\\' && quote == '"' && text_.substr(at_ + 1, 1) != "\n") {
        at_ += 2;
      } else if (!long_string && (c == quote || c == '\n')) {
        at_ += c == quote ? 1 : 0;  // a short string never passes the end of its line
        return;
      } else if (long_string && text_.substr(at_, 3) == triple) {
        at_ += 3;
        // Up to two quotes more belong to the string.
        for (int more = 0; more < 2 && text_.substr(at_, 1) == triple.substr(0, 1); ++more) ++at_;
        return;
      } else {
        ++at_;
      }
    }
  }

  std::optional<SyntaxError> count(char c) {
    if (c == '.') {
      if (++dots_ >= deepest_key)
        return error_here(fmt::format("a dotted key of more than {} parts", deepest_key));
      return std::nullopt;
    }
    if (c == ' ' || c == '\t' || c == '\r') return std::nullopt;
    if (c == '[' || c == '{') {
      header_ = header_ || (line_is_blank_ && brackets_ == 0);
      if (++brackets_ > deepest_nesting)
        return error_here(fmt::format("lists and tables nested more than {} deep", deepest_nesting));
    } else if (c == ']' || c == '}') {
      brackets_ = std::max(0, brackets_ - 1);
    } else if (c == '\n') {
      // A header ends with its line, so that many broken ones do not look like one deep list.
      if (header_) brackets_ = 0;
      header_ = false;
    }
    if (c == '\n' || c == '=' || c == ',' || c == '[' || c == ']' || c == '{' || c == '}') dots_ = 0;
    line_is_blank_ = c == '\n';
    return std::nullopt;
  }

  SyntaxError error_here(std::string message) const {
    const std::string_view before = text_.substr(0, at_);
    const auto line = static_cast<std::uint32_t>(std::ranges::count(before, '\n') + 1);
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    const auto starts_character = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
    const auto column = std::ranges::count_if(before.substr(line_start), starts_character) + 1;
    return {std::move(message), {line, static_cast<std::uint32_t>(column), -1}};
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int dots_ = 0, brackets_ = 0;
  bool line_is_blank_ = true, header_ = false;
};

}  // namespace

std::optional<SyntaxError> check_limits(std::string_view text) {
  if (text.size() > most_bytes)
    return SyntaxError{fmt::format("larger than {} MiB, the most a scene may have", most_bytes >> 20U), {}};
  const std::size_t bad = find_invalid_utf8(text);
  if (bad != std::string_view::npos)
    return SyntaxError{
        fmt::format("not UTF-8 text: byte {} is 0x{:02x}", bad + 1, static_cast<unsigned char>(text[bad])),
        {}};
  return DepthScan(text).run();
}

}  // namespace taut
