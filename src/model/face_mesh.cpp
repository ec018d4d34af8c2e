#include "model/face_mesh.h"

#include <algorithm>
#include <unordered_map>

namespace taut {
namespace {

constexpr std::uint32_t no_node = 0xffffffffU;

std::uint32_t add_solid_node(FaceMesh& mesh, const Vec3& place, double radius, std::uint32_t group) {
  mesh.solid_place.push_back(place);
  mesh.inverse_mass.push_back(0.0);
  mesh.radius.push_back(radius);
  mesh.core.push_back(radius);
  mesh.group.push_back(group);
  return mesh.size() - 1;
}

void add_solid_edge(FaceMesh& mesh, std::uint32_t a, std::uint32_t b) {
  mesh.edges.push_back({{a, b}, {FaceMesh::no_triangle, FaceMesh::no_triangle}});
}

void add_solid(FaceMesh&, const HalfSpace&, std::uint32_t) {}

void add_solid(FaceMesh& mesh, const Sphere& sphere, std::uint32_t group) {
  add_solid_node(mesh, sphere.centre, sphere.radius, group);
}

void add_solid(FaceMesh& mesh, const Capsule& capsule, std::uint32_t group) {
  const std::uint32_t a = add_solid_node(mesh, capsule.a, capsule.radius, group);
  add_solid_edge(mesh, a, add_solid_node(mesh, capsule.b, capsule.radius, group));
}

// Corner k is on the high side of axis i where bit i of k is set.
void add_solid(FaceMesh& mesh, const Box& box, std::uint32_t group) {
  const std::uint32_t first = mesh.size();
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    Vec3 local = box.half_size;
    for (int axis = 0; axis < 3; ++axis)
      if ((corner >> static_cast<unsigned>(axis) & 1U) == 0) local[axis] = -local[axis];
    add_solid_node(mesh, box.centre + box.axes * local, 0.0, group);
  }
  for (std::uint32_t corner = 0; corner < 8; ++corner)
    for (std::uint32_t bit = 1; bit < 8; bit *= 2)
      if ((corner & bit) == 0) add_solid_edge(mesh, first + corner, first + (corner | bit));
  for (std::uint32_t bit = 1; bit < 8; bit *= 2) {
    const std::uint32_t u = bit == 4 ? 1 : 2 * bit, v = 7 - bit - u;
    for (const std::uint32_t side : {0U, bit}) {
      const std::uint32_t a = first + side, b = a + u, c = a + v, d = a + u + v;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({d, c, b});
    }
  }
}

// Adds a sheet's nodes; a mass is one node however many triangles it is a corner of.
void add_sheet_nodes(FaceMesh& mesh, const Model& model, const SheetFaces& faces, std::uint32_t group) {
  const Sheet& sheet = model.sheets[faces.sheet];
  for (Index i = 0; i < sheet.rows * sheet.columns; ++i) {
    mesh.mass.push_back(sheet.first_mass + i);
    mesh.inverse_mass.push_back(model.masses.inverse_mass[sheet.first_mass + i]);
    mesh.radius.push_back(0.5 * faces.thickness);
    mesh.core.push_back(0.0);
    mesh.group.push_back(group);
  }
}

void add_sheet_triangles(FaceMesh& mesh, const Model& model, const SheetFaces& faces,
                         std::uint32_t first_node) {
  const Sheet& sheet = model.sheets[faces.sheet];
  std::unordered_map<std::uint64_t, std::size_t> known;  // edges by their nodes
  known.reserve(2 * static_cast<std::size_t>(sheet.triangle_count));
  for (Index i = 0; i < sheet.triangle_count; ++i) {
    const auto triangle = static_cast<std::uint32_t>(mesh.triangles.size());
    std::array<std::uint32_t, 3> nodes{};
    for (std::size_t k = 0; k < 3; ++k)
      nodes[k] = model.triangles[sheet.first_triangle + i].masses[k] - sheet.first_mass + first_node;
    mesh.triangles.push_back(nodes);
    mesh.model_triangle.push_back(sheet.first_triangle + i);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(nodes[k], nodes[(k + 1) % 3]);
      const auto [found, is_new] = known.try_emplace((std::uint64_t{a} << 32U) | b, mesh.edges.size());
      if (is_new)
        mesh.edges.push_back({{a, b}, {triangle, triangle}});
      else
        mesh.edges[found->second].triangles[1] = triangle;
    }
  }
}

}  // namespace

FaceMesh::FaceMesh(const Model& model) {
  if (model.faces.empty()) return;
  std::vector<std::uint32_t> first_nodes;
  for (const SheetFaces& faces : model.faces) {
    first_nodes.push_back(size());
    add_sheet_nodes(*this, model, faces, static_cast<std::uint32_t>(groups.size()));
    groups.push_back({&faces, faces.friction});
  }
  for (std::size_t i = 0; i < model.faces.size(); ++i)
    add_sheet_triangles(*this, model, model.faces[i], first_nodes[i]);
  for (const Collider& collider : model.colliders) {
    const auto solid = static_cast<std::uint32_t>(groups.size());
    groups.push_back({nullptr, collider.friction});
    std::visit([&](const auto& shape) { add_solid(*this, shape, solid); }, collider.shape);
  }
}

void FaceMesh::places(const Vectors& position, std::vector<Vec3>& out) const {
  out.resize(size());
  for (std::size_t node = 0; node < mass.size(); ++node) out[node] = position.at(mass[node]);
  std::ranges::copy(solid_place, out.begin() + static_cast<std::ptrdiff_t>(mass.size()));
}

bool FaceMesh::meet(std::uint32_t group_a, std::uint32_t group_b) const {
  const SheetFaces *a = groups[group_a].faces, *b = groups[group_b].faces;
  if (a == nullptr || b == nullptr) return a != b;
  if (a == b) return a->self_collides;
  return a->body != b->body && a->body != no_body && b->body != no_body;
}

bool FaceMesh::any_meet() const {
  for (std::uint32_t a = 0; a < groups.size(); ++a)
    for (std::uint32_t b = 0; b <= a; ++b)
      if (groups[a].faces != nullptr && groups[b].faces != nullptr && meet(a, b)) return true;
  return false;
}

WholeFaces whole_faces(const FaceMesh& mesh, const Model& model, const std::vector<double>& broken_at) {
  WholeFaces whole;
  std::vector<bool> alive(mesh.triangles.size(), true), met(mesh.size(), false);
  for (std::size_t i = 0; i < mesh.model_triangle.size(); ++i)
    for (const Index link : model.triangles[mesh.model_triangle[i]].links)
      if (link != no_link && broken_at[link] != infinity) alive[i] = false;
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!alive[i]) continue;
    whole.triangles.push_back(i);
    for (const std::uint32_t node : mesh.triangles[i]) met[node] = true;
  }
  for (std::uint32_t node = 0; node < mesh.size(); ++node)
    if (met[node] || mesh.of_solid(node)) whole.points.push_back(node);
  for (std::uint32_t i = 0; i < mesh.edges.size(); ++i) {
    const auto [one, other] = mesh.edges[i].triangles;
    if (one == FaceMesh::no_triangle || alive[one] || alive[other]) whole.edges.push_back(i);
  }
  return whole;
}

}  // namespace taut
