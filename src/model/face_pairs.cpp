#include "model/face_pairs.h"

#include <algorithm>
#include <limits>

#include "model/face_pair_search.h"

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
  FacePairSearch().find(mesh, whole, places, rooms, most, nullptr, pairs);
}

}  // namespace taut
