#include "model/face_pairs.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "model/box_tree.h"

namespace taut {
namespace {

// What of a segment from a to b is nearest to a point: 0 at a, 1 at b.
double nearest_share(const Vec3& point, const Vec3& a, const Vec3& b) {
  const Vec3 span = b - a;
  const double square = span.squaredNorm();
  return square > 0.0 ? std::clamp((point - a).dot(span) / square, 0.0, 1.0) : 0.0;
}

// Keeps the nearer one of two gaps.
void take_nearer(FaceGap& nearest, const std::array<double, 4>& weights, const Vec3& apart) {
  const double distance = apart.norm();
  if (!(distance < nearest.distance)) return;
  nearest = {weights, apart, distance};
}

// The foot of the perpendicular on the triangle's plane where it is inside, else the nearest place of an
// edge.
FaceGap point_and_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  FaceGap nearest;
  nearest.distance = std::numeric_limits<double>::infinity();
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const Vec3 normal = ab.cross(ac);
  const double square = normal.squaredNorm();
  if (square > 0.0) {
    const double v = ap.cross(ac).dot(normal) / square, w = ab.cross(ap).dot(normal) / square;
    const double u = 1.0 - v - w;
    if (u > 0.0 && v > 0.0 && w > 0.0) {
      take_nearer(nearest, {1.0, -u, -v, -w}, p - (u * a + v * b + w * c));
      return nearest;
    }
  }
  const double on_ab = nearest_share(p, a, b), on_bc = nearest_share(p, b, c), on_ca = nearest_share(p, c, a);
  take_nearer(nearest, {1.0, on_ab - 1.0, -on_ab, 0.0}, p - (a + on_ab * ab));
  take_nearer(nearest, {1.0, 0.0, on_bc - 1.0, -on_bc}, p - (b + on_bc * (c - b)));
  take_nearer(nearest, {1.0, -on_ca, 0.0, on_ca - 1.0}, p - (c + on_ca * (a - c)));
  return nearest;
}

// Between the insides of both where the common perpendicular meets both, else at an end of one. The ends are
// also looked at where edges are so nearly parallel that the perpendicular is lost in rounding.
FaceGap edge_and_edge(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  FaceGap nearest;
  nearest.distance = std::numeric_limits<double>::infinity();
  const Vec3 u = b - a, v = d - c, w = a - c;
  const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm(), uw = u.dot(w), vw = v.dot(w);
  const double determinant = uu * vv - uv * uv;
  if (determinant > 0.0) {
    const double s = (uv * vw - vv * uw) / determinant, t = (uu * vw - uv * uw) / determinant;
    if (s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0) {
      take_nearer(nearest, {1.0 - s, s, t - 1.0, -t}, a + s * u - (c + t * v));
      if (determinant > 1e-8 * uu * vv) return nearest;
    }
  }
  const double a_on = nearest_share(a, c, d), b_on = nearest_share(b, c, d);
  const double c_on = nearest_share(c, a, b), d_on = nearest_share(d, a, b);
  take_nearer(nearest, {1.0, 0.0, a_on - 1.0, -a_on}, a - (c + a_on * v));
  take_nearer(nearest, {0.0, 1.0, b_on - 1.0, -b_on}, b - (c + b_on * v));
  take_nearer(nearest, {1.0 - c_on, c_on, -1.0, 0.0}, a + c_on * u - c);
  take_nearer(nearest, {1.0 - d_on, d_on, 0.0, -1.0}, a + d_on * u - d);
  return nearest;
}

// A pair by numbers that sort by the first and then the second of it, and its distance (m).
using KeyedPair = std::pair<std::uint64_t, double>;

KeyedPair keyed(std::uint32_t a, std::uint32_t b, double distance) {
  return {(std::uint64_t{a} << 32U) | b, distance};
}
std::uint32_t first_of(const KeyedPair& pair) {
  return static_cast<std::uint32_t>(pair.first >> 32U);
}
std::uint32_t second_of(const KeyedPair& pair) {
  return static_cast<std::uint32_t>(pair.first);
}

// One search: the same arguments all the way down.
class PairSearch {
 public:
  PairSearch(const FaceMesh& mesh, const WholeFaces& whole, const std::vector<Vec3>& places,
             const std::vector<double>& rooms)
      : mesh_(mesh), whole_(whole), places_(places), rooms_(rooms) {
    for (std::uint32_t node = 0; node < mesh_.mass.size(); ++node)
      sheets_.take_in(bounds_of(std::array{node}));
  }

  void points_with_triangles(std::vector<KeyedPair>& found, std::size_t most) {
    const auto points = [](std::uint32_t point) { return std::array{point}; };
    const auto triangles = [this](std::uint32_t triangle) { return mesh_.triangles[triangle]; };
    const Parts sheet_points = parts(whole_.points, points, false),
                solid_points = parts(whole_.points, points, true),
                sheet_triangles = parts(whole_.triangles, triangles, false),
                solid_triangles = parts(whole_.triangles, triangles, true);
    const auto among = [&](const Parts& of_points, const Parts& of_triangles) {
      of_points.tree.visit_pairs(of_triangles.tree, [&](std::uint32_t i, std::uint32_t j) {
        const std::uint32_t point = of_points.numbers[i], triangle = of_triangles.numbers[j];
        const auto [a, b, c] = mesh_.triangles[triangle];
        if (point == a || point == b || point == c || found.size() > most) return;
        if (const double distance = near_enough({{point, a, b, c}, false}); distance < too_far)
          found.push_back(keyed(point, triangle, distance));
      });
    };
    among(sheet_points, sheet_triangles);
    among(sheet_points, solid_triangles);
    among(solid_points, sheet_triangles);
    std::ranges::sort(found);
  }

  void edges_with_edges(std::vector<KeyedPair>& found, std::size_t most) {
    const auto edges = [this](std::uint32_t edge) { return mesh_.edges[edge].nodes; };
    const Parts sheet_edges = parts(whole_.edges, edges, false),
                solid_edges = parts(whole_.edges, edges, true);
    const auto take = [&](std::uint32_t one, std::uint32_t other) {
      const auto [a, b] = mesh_.edges[one].nodes;
      const auto [c, d] = mesh_.edges[other].nodes;
      if (a == c || a == d || b == c || b == d || found.size() > most) return;
      if (const double distance = near_enough({{a, b, c, d}, true}); distance < too_far)
        found.push_back(keyed(one, other, distance));
    };
    sheet_edges.tree.visit_pairs(
        [&](std::uint32_t i, std::uint32_t j) { take(sheet_edges.numbers[i], sheet_edges.numbers[j]); });
    sheet_edges.tree.visit_pairs(solid_edges.tree, [&](std::uint32_t i, std::uint32_t j) {
      take(sheet_edges.numbers[i], solid_edges.numbers[j]);
    });
    std::ranges::sort(found);
  }

 private:
  // Some points, edges or triangles in a tree of the boxes around them, and which they are.
  struct Parts {
    BoxTree tree;
    std::vector<std::uint32_t> numbers;
  };

  // Those of sheets or of solids, which do not meet each other; of these only what is near sheets at all.
  template <class Nodes>
  Parts parts(const std::vector<std::uint32_t>& all, const Nodes& nodes_of, bool of_solids) {
    Parts taken;
    bounds_.clear();
    for (const std::uint32_t part : all) {
      const auto nodes = nodes_of(part);
      if (mesh_.of_solid(nodes[0]) != of_solids) continue;
      const Bounds bounds = bounds_of(nodes);
      if (of_solids && !bounds.meets(sheets_)) continue;
      bounds_.push_back(bounds);
      taken.numbers.push_back(part);
    }
    taken.tree.fill(bounds_);
    return taken;
  }

  // Around the balls of some nodes, and what is kept free around them.
  template <std::size_t count>
  Bounds bounds_of(const std::array<std::uint32_t, count>& nodes) const {
    Bounds bounds;
    for (const std::uint32_t node : nodes)
      bounds.take_in(places_[node], rooms_[node] + mesh_.radius[node] +
                                        look_ahead * (mesh_.radius[node] - mesh_.core[node]));
    return bounds;
  }

  static constexpr double too_far = std::numeric_limits<double>::infinity();

  // The distance of a pair that can come into contact, or too_far.
  double near_enough(const FacePair& pair) const {
    const auto [a, b, c, d] = pair.nodes;
    if (!mesh_.meet(mesh_.group[a], mesh_.group[d])) return too_far;
    const bool held = mesh_.inverse_mass[a] == 0.0 && mesh_.inverse_mass[b] == 0.0 &&
                      mesh_.inverse_mass[c] == 0.0 && mesh_.inverse_mass[d] == 0.0;
    if (held) return too_far;
    const double room = pair.edges ? std::max(rooms_[a], rooms_[b]) + std::max(rooms_[c], rooms_[d])
                                   : rooms_[a] + std::max({rooms_[b], rooms_[c], rooms_[d]});
    const double distance = nearest_gap(pair, places_).distance;
    return distance <= watched_apart(mesh_, pair) + room ? distance : too_far;
  }

  const FaceMesh& mesh_;
  const WholeFaces& whole_;
  const std::vector<Vec3>& places_;
  const std::vector<double>& rooms_;
  Bounds sheets_;  // around all of them
  std::vector<Bounds> bounds_;
};

}  // namespace

FaceGap nearest_gap(bool edges, const std::array<Vec3, 4>& corners) {
  const auto& [a, b, c, d] = corners;
  return edges ? edge_and_edge(a, b, c, d) : point_and_triangle(a, b, c, d);
}

FaceGap nearest_gap(const FacePair& pair, const std::vector<Vec3>& places) {
  const auto [a, b, c, d] = pair.nodes;
  return nearest_gap(pair.edges, {places[a], places[b], places[c], places[d]});
}

void find_face_pairs(const FaceMesh& mesh, const WholeFaces& whole, const std::vector<Vec3>& places,
                     const std::vector<double>& rooms, std::size_t most, std::vector<FacePair>& pairs) {
  pairs.clear();
  PairSearch search(mesh, whole, places, rooms);
  std::vector<KeyedPair> found;
  search.points_with_triangles(found, most);
  for (const KeyedPair& pair : found) {
    const auto& nodes = mesh.triangles[second_of(pair)];
    pairs.push_back({{first_of(pair), nodes[0], nodes[1], nodes[2]}, false, pair.second});
  }
  found.clear();
  search.edges_with_edges(found, most);
  for (const KeyedPair& pair : found) {
    const auto &a = mesh.edges[first_of(pair)].nodes, &b = mesh.edges[second_of(pair)].nodes;
    pairs.push_back({{a[0], a[1], b[0], b[1]}, true, pair.second});
  }
}

}  // namespace taut
