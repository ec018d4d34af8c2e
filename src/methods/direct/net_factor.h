#pragma once

#include <Eigen/SparseCore>
#include <cstddef>
#include <vector>

#include "base/vectors.h"

namespace taut {

/// Sparse LDLᵀ of a symmetric matrix whose rows are in an order that fills little. The matrix is put together
/// where its factor will be: clear(), then add to its entries, then factor().
class NetFactor {
 public:
  /// For matrices of the pattern of this one, given by their upper triangle in compressed form.
  explicit NetFactor(const Eigen::SparseMatrix<double>& pattern);

  /// The place of an entry of the pattern, row ≤ column; the same as long as the factor lives.
  double* entry(std::size_t row, std::size_t column);
  /// Sets all of the matrix to 0.
  void clear();
  /// Factorises. False where a pivot is not above `least_pivot`.
  bool factor(double least_pivot);
  /// Solves in place.
  void solve(std::vector<double>& b) const;

  /// Neighbouring columns of L that have the same rows below them. Of each the values of the panel's own rows
  /// come first, then those of the rows below.
  struct Panel {
    std::size_t first, width;
    std::size_t rows_begin, rows;  ///< below, in row_
  };

 private:
  void take_pattern(const Eigen::SparseMatrix<double>& pattern);
  void find_panels();
  void update(const Panel& by, std::size_t from, std::size_t columns, const Panel& panel);
  double* column_of(const Panel& panel, std::size_t column);
  bool finish(const Panel& panel, double least_pivot);

  // L of unit diagonal by columns: where each begins, and the rows and values of its entries.
  std::vector<std::size_t> begin_;
  std::vector<Index> row_;
  std::vector<double> value_;
  std::vector<double> pivot_;  // D
  std::vector<Panel> panels_;
  std::vector<std::size_t> panel_of_;  // of each column
  std::vector<std::size_t>
      entry_;  // of each entry of the matrix, its place in value_, or behind it in pivot_
  // While it is factorised: the panels that change a panel next, as lists; the first of their rows that has
  // not done so yet; and where in the present panel a row is.
  std::vector<std::size_t> first_, next_, reached_, local_;
};

}  // namespace taut
