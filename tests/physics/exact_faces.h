#pragma once

// Whether triangles go through each other, decided exactly: doubles are taken as the fractions they are
// (GMP). Nothing in it is shared with what it judges, and every edge is tried with every triangle.

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "model/model.h"
#include "model/state.h"

namespace taut::test {

/// Doubles are whole numbers times a power of two. With the least of those powers as the unit, so that it is
/// one for all of them: value / 2^exponent.
inline mpz_class whole_number(double value, int exponent) {
  int own = 0;
  const mpz_class mantissa(std::ldexp(std::frexp(value, &own), 53));
  return value == 0.0 ? mpz_class(0) : mpz_class(mantissa << static_cast<unsigned long>(own - 53 - exponent));
}

inline int least_exponent(const Vec3& v) {
  int least = 0;
  for (int axis = 0; axis < 3; ++axis) {
    int own = 0;
    if (std::frexp(v[axis], &own) != 0.0) least = std::min(least, own - 53);
  }
  return least;
}

using WholeVector = std::array<mpz_class, 3>;

inline WholeVector exact_difference(const Vec3& a, const Vec3& b, int exponent) {
  WholeVector difference;
  for (int axis = 0; axis < 3; ++axis)
    difference[static_cast<std::size_t>(axis)] =
        whole_number(a[axis], exponent) - whole_number(b[axis], exponent);
  return difference;
}

/// The sign of the volume that a, b, c and d span.
inline int exact_side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = a - d, v = b - d, w = c - d;
  const double about = u.dot(v.cross(w)), size = u.norm() * v.norm() * w.norm();
  const double coordinates = std::max({a.norm(), b.norm(), c.norm(), d.norm()});
  // Beyond that, rounding has no say.
  if (std::abs(about) > 1e-10 * size && coordinates < 1e3 * std::min({u.norm(), v.norm(), w.norm()}))
    return about > 0.0 ? 1 : -1;
  const int unit = std::min({least_exponent(a), least_exponent(b), least_exponent(c), least_exponent(d)});
  const WholeVector p = exact_difference(a, d, unit), q = exact_difference(b, d, unit),
                    r = exact_difference(c, d, unit);
  return sgn(mpz_class(p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) +
                       p[2] * (q[0] * r[1] - q[1] * r[0])));
}

/// Whether an edge has a place in common with a triangle that it does not lie in the plane of.
inline bool goes_through(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& t) {
  const int of_p = exact_side(t[0], t[1], t[2], p), of_q = exact_side(t[0], t[1], t[2], q);
  if (of_p == of_q) return false;
  const std::array around{exact_side(p, q, t[0], t[1]), exact_side(p, q, t[1], t[2]),
                          exact_side(p, q, t[2], t[0])};
  return *std::ranges::min_element(around) >= 0 || *std::ranges::max_element(around) <= 0;
}

using PlacedTriangle = std::array<Vec3, 3>;
using PlacedEdge = std::array<Vec3, 2>;

inline bool boxes_meet(const PlacedEdge& edge, const PlacedTriangle& triangle) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax({triangle[0][axis], triangle[1][axis], triangle[2][axis]});
    if (std::max(edge[0][axis], edge[1][axis]) < low || std::min(edge[0][axis], edge[1][axis]) > high)
      return false;
  }
  return true;
}

/// How many edges of whole triangles go through whole triangles that they have no mass in common with.
inline std::size_t exact_tangles(const Model& model, const State& state) {
  std::vector<const Triangle*> whole;
  std::vector<std::pair<Index, Index>> edges;
  for (const Triangle& triangle : model.triangles) {
    const bool torn = std::ranges::any_of(triangle.links,
                                          [&](Index link) { return link != no_link && state.broken(link); });
    if (torn) continue;
    whole.push_back(&triangle);
    for (std::size_t k = 0; k < 3; ++k)
      edges.push_back(std::minmax(triangle.masses[k], triangle.masses[(k + 1) % 3]));
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  std::size_t count = 0;
  for (const Triangle* triangle : whole) {
    const auto& masses = triangle->masses;
    const PlacedTriangle placed{state.position.at(masses[0]), state.position.at(masses[1]),
                                state.position.at(masses[2])};
    for (const auto& [a, b] : edges) {
      if (std::ranges::count(masses, a) + std::ranges::count(masses, b) > 0) continue;
      const PlacedEdge edge{state.position.at(a), state.position.at(b)};
      if (boxes_meet(edge, placed) && goes_through(edge[0], edge[1], placed)) ++count;
    }
  }
  return count;
}

/// How many edges of a box go through whole triangles.
inline std::size_t exact_box_tangles(const Box& box, const Model& model, const State& state) {
  std::size_t count = 0;
  const auto corner = [&](unsigned k) -> Vec3 {
    const Vec3 local(k & 1U ? box.half_size.x() : -box.half_size.x(),
                     k & 2U ? box.half_size.y() : -box.half_size.y(),
                     k & 4U ? box.half_size.z() : -box.half_size.z());
    return box.centre + box.axes * local;
  };
  for (const Triangle& triangle : model.triangles) {
    const PlacedTriangle placed{state.position.at(triangle.masses[0]), state.position.at(triangle.masses[1]),
                                state.position.at(triangle.masses[2])};
    for (unsigned k = 0; k < 8; ++k)
      for (unsigned bit = 1; bit < 8; bit *= 2)
        if ((k & bit) == 0 && goes_through(corner(k), corner(k | bit), placed)) ++count;
  }
  return count;
}

}  // namespace taut::test
