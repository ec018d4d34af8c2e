#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace taut {

/// A field of a table and where it begins.
struct TableField {
  std::string text;
  std::size_t line = 0, column = 0;  ///< from 1; columns in characters
};

/// A table of comma-separated values (RFC 4180) with a line of headings.
class Table {
 public:
  /// Throws BadRequest with line and column where a row has not as many fields as there are headings, a
  /// heading is there twice, or a quote is out of place. `called` is what messages call the file.
  Table(std::string_view text, std::string called);

  /// Which column has a heading; none: no_column.
  std::size_t column(std::string_view heading) const;
  std::size_t row_count() const { return rows_.size(); }
  /// A field by row, from 0.
  const TableField& field(std::size_t row, std::size_t column) const { return rows_[row][column]; }
  /// A field as a finite number; nothing where there is no such column, or nothing in the field. Throws
  /// BadRequest for what is no number.
  std::optional<double> number(std::size_t row, std::size_t column) const;
  const std::vector<TableField>& headings() const { return headings_; }
  [[noreturn]] void fail(const TableField& at, std::string_view message) const;

  static constexpr std::size_t no_column = static_cast<std::size_t>(-1);

 private:
  std::string called_;
  std::vector<TableField> headings_;
  std::vector<std::vector<TableField>> rows_;
};

}  // namespace taut
