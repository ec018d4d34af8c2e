#pragma once

// Whether triangles of cloth go into solids: exactly (exact_faces.h) where those have edges and triangles,
// and for round ones by distances of its own. Nothing in it is shared with what it judges but where solids
// are at a time. What is wholly inside a solid out of a mesh is not seen: it was through its surface before.

#include "exact_faces.h"
#include "model/colliders.h"
#include "model/solid_mesh.h"

namespace taut::test {

/// A solid's surface, or the whole triangles of a state.
struct Surfaces {
  std::vector<PlacedTriangle> triangles;
  std::vector<PlacedEdge> edges;  ///< of each triangle, some of them twice

  void add(const PlacedTriangle& triangle) {
    triangles.push_back(triangle);
    for (std::size_t k = 0; k < 3; ++k) edges.push_back({triangle[k], triangle[(k + 1) % 3]});
  }
};

inline Surfaces cloth_of(const Model& model, const State& state) {
  Surfaces cloth;
  for (const Triangle* triangle : whole_triangles(model, state)) cloth.add(placed(*triangle, state));
  return cloth;
}

inline Surfaces surface_of(const Box& box) {
  const auto corner = [&](std::size_t k) -> Vec3 {
    const Vec3 local(k & 1U ? box.half_size.x() : -box.half_size.x(),
                     k & 2U ? box.half_size.y() : -box.half_size.y(),
                     k & 4U ? box.half_size.z() : -box.half_size.z());
    return box.centre + box.axes * local;
  };
  Surfaces surface;
  for (const auto& [u, v] : {std::pair(1U, 2U), std::pair(2U, 4U), std::pair(4U, 1U)})
    for (const std::size_t side : {std::size_t{0}, std::size_t{7} - u - v}) {
      surface.add({corner(side), corner(side + u), corner(side + v)});
      surface.add({corner(side + u + v), corner(side + v), corner(side + u)});
    }
  return surface;
}

inline Surfaces surface_of(const MeshSolid& solid) {
  Surfaces surface;
  for (Index i = 0; i < solid.mesh->triangles().size(); ++i) {
    const auto corners = solid.mesh->corners_of(i);
    surface.add({solid.place(corners[0]), solid.place(corners[1]), solid.place(corners[2])});
  }
  return surface;
}

/// How many edges of either go through triangles of the other; of two triangles an edge counts twice.
inline std::size_t exact_passes_between(const Surfaces& one, const Surfaces& other) {
  const auto any = [](std::size_t, std::size_t) { return true; };
  return exact_passes(one.edges, other.triangles, any) + exact_passes(other.edges, one.triangles, any);
}

inline double distance_from_edge(const Vec3& point, const PlacedEdge& edge) {
  const Vec3 along = edge[1] - edge[0];
  const double share = std::clamp((point - edge[0]).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (point - edge[0] - share * along).norm();
}

inline double distance_from_triangle(const Vec3& point, const PlacedTriangle& triangle) {
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).normalized();
  double nearest = infinity;
  bool above = true;  // of its inside
  for (std::size_t k = 0; k < 3; ++k) {
    const PlacedEdge edge{triangle[k], triangle[(k + 1) % 3]};
    above = above && normal.cross(edge[1] - edge[0]).dot(point - edge[0]) >= 0.0;
    nearest = std::min(nearest, distance_from_edge(point, edge));
  }
  return above ? std::min(nearest, std::abs(normal.dot(point - triangle[0]))) : nearest;
}

/// At an end of one of them, or on the line at right angles to both.
inline double distance_between_edges(const PlacedEdge& one, const PlacedEdge& other) {
  const Vec3 u = one[1] - one[0], v = other[1] - other[0], apart = other[0] - one[0], normal = u.cross(v);
  const double square = normal.squaredNorm();
  const double on_one = apart.cross(v).dot(normal), on_other = apart.cross(u).dot(normal);
  if (std::min(on_one, on_other) > 0.0 && std::max(on_one, on_other) < square)
    return std::abs(apart.dot(normal)) / std::sqrt(square);
  return std::min({distance_from_edge(one[0], other), distance_from_edge(one[1], other),
                   distance_from_edge(other[0], one), distance_from_edge(other[1], one)});
}

inline bool goes_into(const HalfSpace& solid, const PlacedTriangle& triangle) {
  return std::ranges::any_of(
      triangle, [&](const Vec3& corner) { return (corner - solid.point).dot(solid.normal) < 0.0; });
}

inline bool goes_into(const Sphere& solid, const PlacedTriangle& triangle) {
  return distance_from_triangle(solid.centre, triangle) < solid.radius;
}

inline bool goes_into(const Capsule& solid, const PlacedTriangle& triangle) {
  const PlacedEdge axis{solid.a, solid.b};
  for (int k = 0; k < 3; ++k) {  // most are far off
    const auto [low, high] = std::minmax({triangle[0][k], triangle[1][k], triangle[2][k]});
    if (std::max(solid.a[k], solid.b[k]) + solid.radius < low ||
        std::min(solid.a[k], solid.b[k]) - solid.radius > high)
      return false;
  }
  if (goes_through(solid.a, solid.b, triangle)) return true;
  double nearest =
      std::min(distance_from_triangle(solid.a, triangle), distance_from_triangle(solid.b, triangle));
  for (std::size_t k = 0; k < 3; ++k)
    nearest = std::min(nearest, distance_between_edges(axis, {triangle[k], triangle[(k + 1) % 3]}));
  return nearest < solid.radius;
}

inline bool has_inside(const Box& box, const Vec3& point) {
  const Vec3 local = box.axes.transpose() * (point - box.centre);
  return (local.cwiseAbs() - box.half_size).maxCoeff() < 0.0;
}

template <class Solid>
std::size_t passes_into(const Solid& solid, const Surfaces& cloth) {
  return static_cast<std::size_t>(std::ranges::count_if(
      cloth.triangles, [&](const PlacedTriangle& triangle) { return goes_into(solid, triangle); }));
}
inline std::size_t passes_into(const Box& solid, const Surfaces& cloth) {
  const auto inside = std::ranges::count_if(
      cloth.triangles, [&](const PlacedTriangle& triangle) { return has_inside(solid, triangle[0]); });
  return exact_passes_between(cloth, surface_of(solid)) + static_cast<std::size_t>(inside);
}
inline std::size_t passes_into(const MeshSolid& solid, const Surfaces& cloth) {
  return exact_passes_between(cloth, surface_of(solid));
}

inline bool rope_goes_into(const HalfSpace& solid, const PlacedEdge& link) {
  return goes_into(solid, {link[0], link[1], link[1]});
}
inline bool rope_goes_into(const Sphere& solid, const PlacedEdge& link) {
  return distance_from_edge(solid.centre, link) < solid.radius;
}
inline bool rope_goes_into(const Capsule& solid, const PlacedEdge& link) {
  return distance_between_edges({solid.a, solid.b}, link) < solid.radius;
}
template <class Solid>  // a box, or one out of a mesh
bool rope_goes_into(const Solid& solid, const PlacedEdge& link) {
  return exact_passes({link}, surface_of(solid).triangles, [](std::size_t, std::size_t) { return true; }) > 0;
}

/// How many whole links of chains go into a solid at a state's time, as lines without a radius.
inline std::size_t exact_rope_passes(const Collider& collider, const Model& model, const State& state) {
  std::size_t count = 0;
  const auto look = [&](const auto& solid) {
    for (const Chain& chain : model.chains)
      for (Index link = chain.first_link; link < chain.first_link + chain.link_count; ++link)
        if (!state.broken(link) && rope_goes_into(solid, {state.position.at(model.links.a[link]),
                                                          state.position.at(model.links.b[link])}))
          ++count;
  };
  std::visit(look, shape_at(collider, state.time));
  return count;
}

/// How many places there are where whole triangles go into a solid at a state's time.
inline std::size_t exact_solid_passes(const Collider& collider, const Model& model, const State& state) {
  const Surfaces cloth = cloth_of(model, state);
  return std::visit([&](const auto& solid) { return passes_into(solid, cloth); },
                    shape_at(collider, state.time));
}

}  // namespace taut::test
