#pragma once

// Whether triangles go through each other, decided exactly: doubles are taken as the fractions they are
// (GMP). Nothing in it is shared with what it judges, and every edge is tried with every triangle whose box
// it meets.

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

/// How many of some edges go through some triangles of which `may(edge, triangle)`, by their numbers, says
/// yes.
template <class May>
std::size_t exact_passes(const std::vector<PlacedEdge>& edges, const std::vector<PlacedTriangle>& triangles,
                         const May& may) {
  // In order of their least x, so that an edge has to be tried with a stretch of them alone.
  struct Reach {
    double low, high;
    std::size_t triangle;
  };
  std::vector<Reach> reaches;
  double widest = 0.0;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto [low, high] = std::minmax({triangles[i][0].x(), triangles[i][1].x(), triangles[i][2].x()});
    reaches.push_back({low, high, i});
    widest = std::max(widest, high - low);
  }
  std::ranges::sort(reaches, {}, &Reach::low);
  std::size_t count = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto [low, high] = std::minmax(edges[i][0].x(), edges[i][1].x());
    const double from = low - widest - 1e-9 * (std::abs(low) + widest);
    for (auto reach = std::ranges::lower_bound(reaches, from, {}, &Reach::low);
         reach != reaches.end() && reach->low <= high; ++reach)
      if (reach->high >= low && boxes_meet(edges[i], triangles[reach->triangle]) && may(i, reach->triangle) &&
          goes_through(edges[i][0], edges[i][1], triangles[reach->triangle]))
        ++count;
  }
  return count;
}

/// The triangles of a model's sheets that no broken link is an edge of.
inline std::vector<const Triangle*> whole_triangles(const Model& model, const State& state) {
  std::vector<const Triangle*> whole;
  for (const Triangle& triangle : model.triangles) {
    const bool torn = std::ranges::any_of(triangle.links,
                                          [&](Index link) { return link != no_link && state.broken(link); });
    if (!torn) whole.push_back(&triangle);
  }
  return whole;
}

inline PlacedTriangle placed(const Triangle& triangle, const State& state) {
  return {state.position.at(triangle.masses[0]), state.position.at(triangle.masses[1]),
          state.position.at(triangle.masses[2])};
}

/// How many edges of whole triangles go through whole triangles that they have no mass in common with.
inline std::size_t exact_tangles(const Model& model, const State& state) {
  const std::vector<const Triangle*> whole = whole_triangles(model, state);
  std::vector<std::pair<Index, Index>> ends;
  std::vector<PlacedTriangle> triangles;
  for (const Triangle* triangle : whole) {
    triangles.push_back(placed(*triangle, state));
    for (std::size_t k = 0; k < 3; ++k)
      ends.push_back(std::minmax(triangle->masses[k], triangle->masses[(k + 1) % 3]));
  }
  std::ranges::sort(ends);
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<PlacedEdge> edges;
  for (const auto& [a, b] : ends) edges.push_back({state.position.at(a), state.position.at(b)});
  return exact_passes(edges, triangles, [&](std::size_t edge, std::size_t triangle) {
    const auto& masses = whole[triangle]->masses;
    return std::ranges::count(masses, ends[edge].first) + std::ranges::count(masses, ends[edge].second) == 0;
  });
}

}  // namespace taut::test
