#include "model/solid_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace taut {
namespace {

constexpr std::uint32_t most_in_leaf = 4;
// Of the solid's size, nearer than which the way to the nearest place says nothing of a direction.
constexpr double no_direction = 1e-12;
constexpr double flat = 1e-9;  // sine of an angle between two triangles that are taken to be in one plane
constexpr Index unnumbered = 0xffffffffU;

double square_from(const Bounds& box, const Vec3& point) {
  return (point - point.cwiseMax(box.low).cwiseMin(box.high)).squaredNorm();
}

// The sign of how a line from p to q passes from a to b; of b and a it is the opposite to the last bit.
double turn_about(const Vec3& way, const Vec3& a, const Vec3& b) {
  return way.dot(a.cross(b));
}

int cells_for(std::size_t triangles) {
  return std::clamp(static_cast<int>(0.6 * std::sqrt(static_cast<double>(triangles))), 8, 64);
}

}  // namespace

Bounds SolidMesh::bounds_of(const Vec3& a, const Vec3& b) {
  Bounds bounds;
  bounds.take_in(a, 0.0);
  bounds.take_in(b, 0.0);
  return bounds;
}

SolidMesh::SolidMesh(const std::vector<Vec3>& vertices, const std::vector<Corners>& triangles) {
  sort_triangles(vertices, triangles);
  take_vertices(vertices, triangles);
  size_ = (bounds().high - bounds().low).norm();
  find_edges();
  find_normals();
  InsideGrid grid(bounds(), cells_for(triangles_.size()));
  for (Index i = 0; i < triangles_.size(); ++i) grid.touch(corners_of(i));
  grid.fill([this](const Vec3& point) { return nearest(point).distance < 0.0; });
  inside_ = std::move(grid);
}

// Halved at the median along the longest side, again and again.
void SolidMesh::sort_triangles(const std::vector<Vec3>& vertices, const std::vector<Corners>& triangles) {
  made_from_.resize(triangles.size());
  std::iota(made_from_.begin(), made_from_.end(), Index{0});
  std::vector<Bounds> boxes(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (const Index corner : triangles[i]) boxes[i].take_in(vertices[corner], 0.0);
  struct Stretch {
    std::uint32_t node, begin, end;
  };
  std::vector<Stretch> waiting{{0, 0, static_cast<std::uint32_t>(triangles.size())}};
  nodes_.emplace_back();
  while (!waiting.empty()) {
    const Stretch part = waiting.back();
    waiting.pop_back();
    Node& node = nodes_[part.node];
    for (std::uint32_t i = part.begin; i < part.end; ++i) node.box.take_in(boxes[made_from_[i]]);
    node.first = part.begin;
    node.count = part.end - part.begin;
    if (node.count <= most_in_leaf) continue;
    int axis = 0;
    (node.box.high - node.box.low).maxCoeff(&axis);
    const std::uint32_t middle = part.begin + node.count / 2;
    const auto twice_centre = [&](Index i) { return boxes[i].low[axis] + boxes[i].high[axis]; };
    std::nth_element(made_from_.begin() + part.begin, made_from_.begin() + middle,
                     made_from_.begin() + part.end,
                     [&](Index a, Index b) { return twice_centre(a) < twice_centre(b); });
    const auto children = static_cast<std::uint32_t>(nodes_.size());
    node.first = children;
    node.count = 0;
    nodes_.resize(nodes_.size() + 2);
    waiting.push_back({children + 1, middle, part.end});
    waiting.push_back({children, part.begin, middle});
  }
}

// In the order in which triangles come to them.
void SolidMesh::take_vertices(const std::vector<Vec3>& vertices, const std::vector<Corners>& triangles) {
  std::vector<Index> number(vertices.size(), unnumbered);
  triangles_.reserve(triangles.size());
  for (const Index from : made_from_) {
    Corners corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      Index& of = number[triangles[from][k]];
      if (of == unnumbered) {
        of = static_cast<Index>(vertices_.size());
        vertices_.push_back(vertices[triangles[from][k]]);
      }
      corners[k] = of;
    }
    triangles_.push_back(corners);
  }
}

void SolidMesh::find_edges() {
  edges_.reserve(3 * triangles_.size());
  for (Index i = 0; i < triangles_.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(triangles_[i][k], triangles_[i][(k + 1) % 3]);
      edges_.push_back({{a, b}, {i, i}, false});
    }
  std::ranges::stable_sort(edges_, {}, &Edge::ends);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges_.size(); ++i)
    if (kept > 0 && edges_[kept - 1].ends == edges_[i].ends)
      edges_[kept - 1].triangles[1] = edges_[i].triangles[0];
    else
      edges_[kept++] = edges_[i];
  edges_.resize(kept);
  edges_.shrink_to_fit();
}

void SolidMesh::find_normals() {
  corner_normals_.assign(vertices_.size(), Vec3::Zero());
  face_normals_.reserve(triangles_.size());
  for (Index i = 0; i < triangles_.size(); ++i) {
    const std::array<Vec3, 3> at = corners_of(i);
    const Vec3 normal = (at[1] - at[0]).cross(at[2] - at[0]).stableNormalized();
    face_normals_.push_back(normal);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 one = at[(k + 1) % 3] - at[k], other = at[(k + 2) % 3] - at[k];
      corner_normals_[triangles_[i][k]] += std::atan2(one.cross(other).norm(), one.dot(other)) * normal;
    }
  }
  for (Vec3& normal : corner_normals_) normal = normal.stableNormalized();
  edge_normals_.assign(triangles_.size(), {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()});
  for (Edge& edge : edges_) {
    const auto [one, other] = edge.triangles;
    const Vec3 sum = (face_normals_[one] + face_normals_[other]).stableNormalized();
    for (const Index triangle : edge.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = triangles_[triangle][k], b = triangles_[triangle][(k + 1) % 3];
        if (std::min(a, b) == edge.ends[0] && std::max(a, b) == edge.ends[1])
          edge_normals_[triangle][k] = sum;
        // The corner of the other triangle is below the plane of this one where the edge is a ridge.
        else if (triangle == other && a != edge.ends[0] && a != edge.ends[1]) {
          const Vec3 across = vertices_[a] - vertices_[edge.ends[0]];
          edge.ridge = across.dot(face_normals_[one]) < -flat * across.norm();
        }
      }
  }
}

// The nearest place of a triangle, by which of its parts that is (Ericson, Real-Time Collision Detection,
// 2005, section 5.1.5).
void SolidMesh::look(Index triangle, const Vec3& point, Found& best) const {
  const auto [a, b, c] = corners_of(triangle);
  const auto take = [&](int part, const Vec3& place) {
    const double square = (point - place).squaredNorm();
    if (square < best.square) best = {square, triangle, part, place};
  };
  const Vec3 ab = b - a, ac = c - a, ap = point - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return take(4, a);
  const Vec3 bp = point - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return take(5, b);
  const double of_c = d1 * d4 - d3 * d2;
  if (of_c <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return take(1, a + (d1 / (d1 - d3)) * ab);
  const Vec3 cp = point - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return take(6, c);
  const double of_b = d5 * d2 - d1 * d6;
  if (of_b <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return take(3, a + (d2 / (d2 - d6)) * ac);
  const double of_a = d3 * d6 - d5 * d4;
  if (of_a <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
    return take(2, b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b));
  const double sum = of_a + of_b + of_c;
  take(0, a + (of_b / sum) * ab + (of_c / sum) * ac);
}

// The nearer box first; what is farther than the nearest place so far is passed over.
void SolidMesh::search(const Vec3& point, Found& best) const {
  struct Open {
    std::uint32_t node;
    double square;
  };
  std::array<Open, 128> open{};
  std::size_t opened = 0;
  open[opened++] = {0, square_from(nodes_.front().box, point)};
  while (opened > 0) {
    const Open next = open[--opened];
    if (!(next.square < best.square)) continue;
    const Node& node = nodes_[next.node];
    if (node.count > 0) {
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) look(i, point, best);
      continue;
    }
    Open near{node.first, square_from(nodes_[node.first].box, point)},
        far{node.first + 1, square_from(nodes_[node.first + 1].box, point)};
    if (far.square < near.square) std::swap(near, far);
    open[opened++] = far;
    open[opened++] = near;
  }
}

Surface SolidMesh::surface_at(const Vec3& point, const Found& found) const {
  const Vec3 away = point - found.place;
  const double distance = std::sqrt(found.square);
  if (found.part == 0) {
    const Vec3& normal = face_normals_[found.triangle];
    return {away.dot(normal) < 0.0 ? -distance : distance, normal};
  }
  const Vec3& outward =
      found.part < 4 ? edge_normals_[found.triangle][static_cast<std::size_t>(found.part - 1)]
                     : corner_normals_[triangles_[found.triangle][static_cast<std::size_t>(found.part - 4)]];
  const bool inside = away.dot(outward) < 0.0;
  if (!(distance > no_direction * size_)) return {inside ? -distance : distance, outward};
  return {inside ? -distance : distance, (inside ? -1.0 : 1.0) / distance * away};
}

Surface SolidMesh::nearest(const Vec3& point) const {
  Found best;
  best.square = std::numeric_limits<double>::infinity();
  search(point, best);
  if (!best.any()) return {};  // of a point that is nowhere
  return surface_at(point, best);
}

std::optional<Surface> SolidMesh::within(const Vec3& point, double reach) const {
  const auto found_within = [&](double distance) {
    Found best;
    best.square = distance * distance;
    search(point, best);
    return best;
  };
  if (reach > 0.0)
    if (const Found found = found_within(reach); found.any()) return surface_at(point, found);
  const InsideGrid::Cell cell = inside_->at(point);
  if (cell == InsideGrid::Cell::outside) return std::nullopt;
  // What the cell holds of the surface is no farther away than the cell is across; nothing, if its marks
  // were too careful.
  const Found found = cell == InsideGrid::Cell::surface ? found_within(1.001 * inside_->across()) : Found{};
  const Surface surface = found.any() ? surface_at(point, found) : nearest(point);
  return surface.distance < reach ? std::optional(surface) : std::nullopt;
}

// Where the way goes through a triangle, 0 at its start and 1 at its end. Whether it passes an edge on one
// side or the other is decided alike for both triangles there, so no way goes between them.
std::optional<double> SolidMesh::crossed_at(Index triangle, const Vec3& from, const Vec3& to) const {
  const auto corners = corners_of(triangle);
  const Vec3 way = to - from;
  const Vec3 a = corners[0] - from, b = corners[1] - from, c = corners[2] - from;
  const double ab = turn_about(way, a, b), bc = turn_about(way, b, c), ca = turn_about(way, c, a);
  const bool some_left = ab > 0.0 || bc > 0.0 || ca > 0.0, some_right = ab < 0.0 || bc < 0.0 || ca < 0.0;
  if (some_left && some_right) return std::nullopt;
  const Vec3& normal = face_normals_[triangle];
  const double height = -a.dot(normal), sinks = -way.dot(normal);
  if (sinks == 0.0) return std::nullopt;
  const double at = height / sinks;
  return at >= 0.0 && at <= 1.0 ? std::optional(at) : std::nullopt;
}

SolidMesh::Crossing SolidMesh::crossing(const Vec3& from, const Vec3& to) const {
  const Vec3 way = to - from;
  double first = std::numeric_limits<double>::infinity();
  Crossing crossing;
  visit_near(bounds_of(from, to), [&](Index triangle) {
    const std::optional<double> at = crossed_at(triangle, from, to);
    if (!at) return;
    if (way.dot(face_normals_[triangle]) > 0.0) {
      crossing.leaves = true;
    } else if (*at < first) {
      first = *at;
      crossing = {true, crossing.leaves, from + first * way, face_normals_[triangle]};
    }
  });
  return crossing;
}

}  // namespace taut
