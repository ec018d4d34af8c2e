#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>
#include <utility>

#include "builder.h"
#include "mesh_edges.h"

namespace taut {
namespace {

// A number of 21 bits with two free ones before each.
std::uint64_t spread_over_three(std::uint64_t number) {
  std::uint64_t bits = 0;
  for (unsigned bit = 0; bit < 21; ++bit) bits |= (number >> bit & 1U) << (3U * bit);
  return bits;
}

// Vertices along a curve that fills the box around them, Z by Z (Morton, 1966): what is near on the curve is
// near at the start.
std::vector<Index> along_space_curve(const std::vector<Vec3>& places) {
  Vec3 low = places.front(), high = low;
  for (const Vec3& place : places) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  const double cells = 2'097'151.0 / std::max((high - low).maxCoeff(), smallest_divisor);
  std::vector<std::uint64_t> where;
  where.reserve(places.size());
  for (const Vec3& place : places) {
    const Vec3 cell = (place - low) * cells;
    std::uint64_t bits = 0;
    for (int axis = 0; axis < 3; ++axis)
      bits |= spread_over_three(static_cast<std::uint64_t>(cell[axis])) << static_cast<unsigned>(axis);
    where.push_back(bits);
  }
  std::vector<Index> order(places.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::ranges::stable_sort(order, {}, [&](Index i) { return where[i]; });
  return order;
}

// What each vertex stands for (kg): a third of the triangles around it, or as much as any other.
std::vector<double> shares_of(const MeshSpec& spec) {
  const MeshData& mesh = *spec.data;
  const double count = static_cast<double>(mesh.vertices.size());
  std::vector<double> shares(mesh.vertices.size(), spec.mass / count);
  if (spec.shares == MassShares::equal) return shares;
  shares.assign(shares.size(), 0.0);
  double whole = 0.0;
  for (std::size_t face = 0; face < mesh.face_count(); ++face)
    for (const auto& [a, b, c] : triangles_of(mesh, face)) {
      const Vec3& at = mesh.vertices[a];
      const double area = 0.5 * (mesh.vertices[b] - at).cross(mesh.vertices[c] - at).norm();
      for (const Index corner : {a, b, c}) shares[corner] += area / 3.0;
      whole += area;
    }
  for (double& share : shares) share *= spec.mass / whole;
  return shares;
}

void add_mesh_masses(Builder& builder, const MeshSpec& spec) {
  const MeshData& mesh = *spec.data;
  const std::vector<double> shares = shares_of(spec);
  const std::vector<bool> pinned = pinned_vertices(spec);
  const auto first_pin = static_cast<std::size_t>(std::ranges::find(pinned, true) - pinned.begin());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Index mass =
        builder.add_mass(fmt::format("{}.{}", spec.name, i), mesh.vertices[i], Vec3::Zero(), shares[i],
                         pinned[i], spec.faces ? 0.5 * spec.faces->thickness : spec.radius);
    if (pinned[i] && spec.motion.given()) {
      MotionSpec motion = spec.motion;
      for (Knot& knot : motion.path) knot.position += mesh.vertices[i] - mesh.vertices[first_pin];
      builder.drive(mass, motion);
    }
    builder.release_at(mass, spec.release);
  }
}

// Adds the links of a mesh. Each is as long as its ends are apart at the start.
class MeshLinks {
 public:
  MeshLinks(Builder& builder, const MeshSpec& spec, Index first_mass)
      : builder_(builder),
        spec_(spec),
        mesh_(*spec.data),
        first_mass_(first_mass),
        edges_(mesh_),
        first_link_(static_cast<Index>(builder.model.links.size())) {
    for (const MeshEdges::Edge& edge : edges_.all())
      add(edge.ends[0], edge.ends[1], spec.properties, LinkFamily::structural);
    if (spec.diagonals) add_diagonals();
    if (spec.skip_one || spec.bending) pairs_ = straight_pairs(mesh_, edges_);
    if (spec.skip_one) add_skips();
  }

  Index along(Index a, Index b) const {
    const Index edge = edges_.between(a, b);
    if (edge != no_link) return first_link_ + edge;
    const auto found = diagonal_.find(std::minmax(a, b));
    return found == diagonal_.end() ? no_link : found->second;
  }

  void add_bends() {
    for (const StraightPair& pair : pairs_) {
      Bend bend{{first_mass_ + pair.before, first_mass_ + pair.middle, first_mass_ + pair.after},
                spec_.bending->stiffness,
                0.0,
                {along(pair.before, pair.middle), along(pair.middle, pair.after), no_link, no_link}};
      builder_.add_bend(bend, spec_.bending->from_start);
    }
  }

 private:
  Index add(Index a, Index b, const LinkProperties& properties, LinkFamily family) {
    const double length = (mesh_.vertices[b] - mesh_.vertices[a]).norm();
    return builder_.add_link(first_mass_ + a, first_mass_ + b, length, properties, family);
  }

  void add_diagonals() {
    for (std::size_t face = 0; face < mesh_.face_count(); ++face) {
      const auto corners = mesh_.face(face);
      if (corners.size() != 4) continue;
      for (std::size_t k = 0; k < 2; ++k)
        diagonal_[std::minmax(corners[k], corners[k + 2])] =
            add(corners[k], corners[k + 2], *spec_.diagonals, LinkFamily::diagonals);
    }
  }

  // Where both sides of an edge are triangles, between their far corners; over a mass among quads, as in
  // sheets.
  void add_skips() {
    for (const MeshEdges::Edge& edge : edges_.all()) {
      if (edge.at_border()) continue;
      const auto one = mesh_.face(edge.faces[0]), other = mesh_.face(edge.faces[1]);
      if (one.size() != 3 || other.size() != 3) continue;
      const Index from = far_corner(one, edge), to = far_corner(other, edge);
      if (from != to && edges_.between(from, to) == no_link)
        add(from, to, *spec_.skip_one, LinkFamily::skip_one);
    }
    for (const StraightPair& pair : pairs_)
      if (pair.among_quads && edges_.between(pair.before, pair.after) == no_link)
        add(pair.before, pair.after, *spec_.skip_one, LinkFamily::skip_one);
  }

  static Index far_corner(std::span<const Index> face, const MeshEdges::Edge& edge) {
    for (const Index corner : face)
      if (corner != edge.ends[0] && corner != edge.ends[1]) return corner;
    return face[0];
  }

  Builder& builder_;
  const MeshSpec& spec_;
  const MeshData& mesh_;
  Index first_mass_;
  MeshEdges edges_;
  Index first_link_;
  std::map<std::pair<Index, Index>, Index> diagonal_;
  std::vector<StraightPair> pairs_;
};

}  // namespace

std::vector<bool> pinned_vertices(const MeshSpec& spec) {
  const MeshData& mesh = *spec.data;
  std::vector<bool> pinned(mesh.vertices.size(), false);
  for (std::size_t group = 0; group < mesh.groups.size(); ++group)
    if (std::ranges::find(spec.pinned, mesh.groups[group]) != spec.pinned.end())
      for (const Index vertex : mesh.group_vertices[group]) pinned[vertex] = true;
  for (const int number : spec.pinned_masses) pinned.at(static_cast<std::size_t>(number)) = true;
  if (!spec.pinned_box) return pinned;
  const auto& [one, other] = *spec.pinned_box;
  const Vec3 low = one.cwiseMin(other), high = one.cwiseMax(other);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Vec3& place = mesh.vertices[i];
    if ((place.array() >= low.array()).all() && (place.array() <= high.array()).all()) pinned[i] = true;
  }
  return pinned;
}

// Edges of a closed or open surface of f faces and v corners are about f + v (Euler).
Counts count(const MeshSpec& spec) {
  if (!spec.data) return {};
  const auto vertices = static_cast<double>(spec.data->vertices.size());
  const auto faces = static_cast<double>(spec.data->face_count());
  const auto corners = static_cast<double>(spec.data->corners.size());
  const double edges = vertices + faces, quads = corners - 3.0 * faces;
  double links = edges;
  if (spec.diagonals) links += 2.0 * quads;
  if (spec.skip_one) links += edges;
  return {vertices, links, corners - 2.0 * faces, 0.0};
}

void add_mesh(Builder& builder, const MeshSpec& spec) {
  const MeshData& mesh = *spec.data;
  Model& model = builder.model;
  Sheet sheet;
  sheet.name = spec.name;
  sheet.first_mass = static_cast<Index>(model.masses.size());
  sheet.mass_count = static_cast<Index>(mesh.vertices.size());
  sheet.first_triangle = static_cast<Index>(model.triangles.size());
  sheet.along_curve = along_space_curve(mesh.vertices);
  builder.begin_body(spec.collides);
  add_mesh_masses(builder, spec);

  sheet.first_link = static_cast<Index>(model.links.size());
  MeshLinks links(builder, spec, sheet.first_mass);
  sheet.link_count = static_cast<Index>(model.links.size()) - sheet.first_link;
  for (std::size_t face = 0; face < mesh.face_count(); ++face)
    for (const auto& [a, b, c] : triangles_of(mesh, face))
      model.triangles.push_back({{sheet.first_mass + a, sheet.first_mass + b, sheet.first_mass + c},
                                 {links.along(a, b), links.along(b, c), links.along(c, a)}});
  sheet.triangle_count = static_cast<Index>(model.triangles.size()) - sheet.first_triangle;
  if (spec.bending) links.add_bends();
  model.sheets.push_back(std::move(sheet));
  if (spec.faces)
    model.faces.push_back({static_cast<Index>(model.sheets.size() - 1), spec.faces->thickness,
                           spec.faces->friction, spec.faces->self_collides, builder.body()});
}

}  // namespace taut
