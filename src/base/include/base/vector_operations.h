#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "base/vectors.h"

namespace taut {

/// Calls visit with the x arrays of all of them, then with the y arrays, then with the z arrays.
template <class Visit, class... Many>
void for_each_axis(const Visit& visit, Many&... vectors) {
  visit(vectors.x...);
  visit(vectors.y...);
  visit(vectors.z...);
}

/// The numbers [begin, begin + count) of an array, for arithmetic on several at once.
inline auto segment(std::vector<double>& values, std::size_t begin, std::size_t count) {
  return Eigen::Map<Eigen::ArrayXd>(values.data() + begin, static_cast<Eigen::Index>(count));
}
inline auto segment(const std::vector<double>& values, std::size_t begin, std::size_t count) {
  return Eigen::Map<const Eigen::ArrayXd>(values.data() + begin, static_cast<Eigen::Index>(count));
}
/// All of them.
inline auto all_of(std::vector<double>& values) {
  return segment(values, 0, values.size());
}
inline auto all_of(const std::vector<double>& values) {
  return segment(values, 0, values.size());
}

/// 1 for every mass that is free, 0 for pins, of inverse masses: for arithmetic without branches.
inline auto free_masses(const std::vector<double>& inverse_mass) {
  return (1e300 * all_of(inverse_mass)).min(1.0);
}

/// result = a + factor·b, vector by vector; all of one size. `result` may be `a` or `b`.
inline void add_scaled(const Vectors& a, double factor, const Vectors& b, Vectors& result) {
  for_each_axis(
      [factor](const auto& u, const auto& v, auto& sum) {
        for (std::size_t i = 0; i < u.size(); ++i) sum[i] = u[i] + factor * v[i];
      },
      a, b, result);
}

/// result = factor·(a − b), vector by vector; all of one size.
inline void scaled_difference(double factor, const Vectors& a, const Vectors& b, Vectors& result) {
  for_each_axis(
      [factor](const auto& u, const auto& v, auto& difference) {
        for (std::size_t i = 0; i < u.size(); ++i) difference[i] = (u[i] - v[i]) * factor;
      },
      a, b, result);
}

/// The largest |coordinate| of all; 0 of none.
inline double largest_coordinate(const Vectors& vectors) {
  double largest = 0.0;
  for (const auto* axis : {&vectors.x, &vectors.y, &vectors.z})
    if (!axis->empty()) largest = std::max(largest, all_of(*axis).abs().maxCoeff());
  return largest;
}

/// The sum of the squares of all coordinates, vector after vector.
inline double squared_norm(const Vectors& vectors) {
  double sum = 0.0;
  for (std::size_t i = 0; i < vectors.size(); ++i) sum += vectors.at(i).squaredNorm();
  return sum;
}

}  // namespace taut
