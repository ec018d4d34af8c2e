#include "meshes/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/diagnostic.h"
#include "base/failure.h"

namespace taut {
namespace {

// Takes a text apart, a row at a time.
class TableParser {
 public:
  explicit TableParser(std::string_view text) : text_(text) {
    if (text_.starts_with("\xef\xbb\xbf")) at_ = 3;  // a mark of the byte order
  }

  bool at_end() const { return at_ >= text_.size(); }

  // What is wrong, and where, when it is.
  struct Wrong {
    TableField at;
    std::string message;
  };

  std::vector<TableField> row(std::optional<Wrong>& wrong) {
    std::vector<TableField> fields;
    do fields.push_back(field(wrong));
    while (!wrong && take(','));
    take('\r');
    if (!wrong && !at_end() && !take('\n'))
      wrong = Wrong{{"", line_, column_}, "a field in quotes ends at its quote"};
    return fields;
  }

 private:
  char here() const { return text_[at_]; }
  bool is(std::string_view any) const { return !at_end() && any.find(here()) != std::string_view::npos; }
  void step() {
    const bool continues = (static_cast<unsigned char>(here()) & 0xc0U) == 0x80U;  // of a character of UTF-8
    if (here() == '\n') {
      ++line_;
      column_ = 1;
    } else if (!continues) {
      ++column_;
    }
    ++at_;
  }
  bool take(char letter) {
    if (at_end() || here() != letter) return false;
    step();
    return true;
  }

  TableField field(std::optional<Wrong>& wrong) {
    TableField made{"", line_, column_};
    if (!take('"')) {
      for (; !at_end() && !is(",\r\n"); step()) made.text += here();
      return made;
    }
    for (;;) {
      if (at_end()) {
        wrong = Wrong{made, "the quote that opens here is never closed"};
        return made;
      }
      if (take('"') && !is("\"")) return made;
      made.text += here();
      step();
    }
  }

  std::string_view text_;
  std::size_t at_ = 0, line_ = 1, column_ = 1;
};

std::string without_blanks(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(" \t") + 1 - begin);
}

}  // namespace

Table::Table(std::string_view text, std::string called) : called_(std::move(called)) {
  TableParser parser(text);
  std::optional<TableParser::Wrong> wrong;
  while (!parser.at_end()) {
    std::vector<TableField> row = parser.row(wrong);
    if (wrong) fail(wrong->at, wrong->message);
    for (TableField& field : row) field.text = without_blanks(field.text);
    if (row.size() == 1 && row[0].text.empty()) continue;  // an empty line
    if (headings_.empty()) {
      headings_ = std::move(row);
      for (std::size_t i = 0; i < headings_.size(); ++i)
        if (column(headings_[i].text) != i)
          fail(headings_[i], fmt::format("the heading {} is there twice", in_quotes(headings_[i].text)));
      continue;
    }
    if (row.size() != headings_.size())
      fail(row.back(),
           fmt::format("the row has {} fields, and there are {} headings", row.size(), headings_.size()));
    rows_.push_back(std::move(row));
  }
  if (headings_.empty()) throw BadRequest(fmt::format("{}: the file is empty", called_));
}

std::size_t Table::column(std::string_view heading) const {
  const auto found = std::ranges::find(headings_, heading, &TableField::text);
  return found == headings_.end() ? no_column : static_cast<std::size_t>(found - headings_.begin());
}

std::optional<double> Table::number(std::size_t row, std::size_t column) const {
  if (column == no_column) return std::nullopt;
  const TableField& from = field(row, column);
  std::string_view digits = from.text;
  if (digits.empty()) return std::nullopt;
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double value = 0.0;
  const auto [end, code] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (code != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value))
    fail(from, fmt::format("{} must be a number, not {}", headings_[column].text, in_quotes(from.text)));
  return value;
}

void Table::fail(const TableField& at, std::string_view message) const {
  throw BadRequest(fmt::format("{}:{}:{}: {}", called_, at.line, at.column, message));
}

}  // namespace taut
