#include "model/face_mesh.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "model/solid_mesh.h"

namespace taut {
namespace {

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

// Where the surface is bent inwards over an edge, nothing strikes it before it strikes the triangles there.
void add_solid(FaceMesh& mesh, const MeshSolid& solid, std::uint32_t group) {
  const std::uint32_t first = mesh.size();
  for (const Vec3& vertex : solid.mesh->vertices()) add_solid_node(mesh, solid.place(vertex), 0.0, group);
  for (const SolidMesh::Edge& edge : solid.mesh->edges())
    if (edge.ridge) add_solid_edge(mesh, first + edge.ends[0], first + edge.ends[1]);
  for (const auto& [a, b, c] : solid.mesh->triangles())
    mesh.triangles.push_back({first + a, first + b, first + c});
}

// A number's bits with a free one before each.
std::uint64_t spread_bits(std::uint32_t number) {
  std::uint64_t bits = number;
  for (const unsigned shift : {16U, 8U, 4U, 2U, 1U}) {
    const std::uint64_t mask = ~std::uint64_t{0} / ((std::uint64_t{1} << shift) + 1);
    bits = (bits | bits << shift) & mask;
  }
  return bits;
}

// The masses of a sheet along a curve that fills it, Z by Z: what is near on the curve is near in the sheet.
std::vector<Index> along_curve(const Sheet& sheet) {
  if (sheet.is_mesh()) return sheet.along_curve;
  std::vector<Index> order(std::size_t{sheet.rows} * sheet.columns);
  std::iota(order.begin(), order.end(), Index{0});
  const auto place = [&](Index i) {
    return spread_bits(i / sheet.columns) << 1U | spread_bits(i % sheet.columns);
  };
  std::ranges::sort(order, {}, place);
  return order;
}

// Adds a sheet's nodes; a mass is one node however many triangles it is a corner of. Gives the node of each
// of its masses.
std::vector<std::uint32_t> add_sheet_nodes(FaceMesh& mesh, const Model& model, const SheetFaces& faces,
                                           std::uint32_t group) {
  const Sheet& sheet = model.sheets[faces.sheet];
  std::vector<std::uint32_t> node_of(sheet.mass_count);
  for (const Index i : along_curve(sheet)) {
    node_of[i] = mesh.size();
    mesh.mass.push_back(sheet.first_mass + i);
    mesh.inverse_mass.push_back(model.masses.inverse_mass[sheet.first_mass + i]);
    mesh.radius.push_back(0.5 * faces.thickness);
    mesh.core.push_back(0.0);
    mesh.group.push_back(group);
  }
  return node_of;
}

// Adds a sheet's triangles and their edges, in the order of the first nodes they have.
void add_sheet_triangles(FaceMesh& mesh, const Model& model, const Sheet& sheet,
                         const std::vector<std::uint32_t>& node_of) {
  std::vector<std::pair<std::array<std::uint32_t, 3>, Index>> triangles;
  for (Index i = sheet.first_triangle; i < sheet.first_triangle + sheet.triangle_count; ++i) {
    std::array<std::uint32_t, 3> nodes{};
    for (std::size_t k = 0; k < 3; ++k) nodes[k] = node_of[model.triangles[i].masses[k] - sheet.first_mass];
    std::rotate(nodes.begin(), std::ranges::min_element(nodes), nodes.end());
    triangles.emplace_back(nodes, i);
  }
  std::ranges::sort(triangles);
  std::vector<FaceMesh::Edge> edges;
  for (const auto& [nodes, of_model] : triangles) {
    const auto triangle = static_cast<std::uint32_t>(mesh.triangles.size());
    mesh.triangles.push_back(nodes);
    mesh.model_triangle.push_back(of_model);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(nodes[k], nodes[(k + 1) % 3]);
      edges.push_back({{a, b}, {triangle, triangle}});
    }
  }
  std::ranges::stable_sort(edges, {}, &FaceMesh::Edge::nodes);
  for (const FaceMesh::Edge& edge : edges)
    if (!mesh.edges.empty() && mesh.edges.back().nodes == edge.nodes)
      mesh.edges.back().triangles[1] = edge.triangles[0];
    else
      mesh.edges.push_back(edge);
}

// Adds the masses that touch sheets with faces as balls. Their groups, one a body, come after those of
// solids; gives their bodies.
std::vector<Index> add_balls(FaceMesh& mesh, const Model& model) {
  std::vector<Index> bodies;
  const bool any =
      std::ranges::any_of(model.faces, [](const SheetFaces& faces) { return faces.body != no_body; });
  if (!any) return bodies;
  const std::size_t first_group = mesh.groups.size() + model.colliders.size();
  for (const ContactPoint& point : model.contacts) {
    if (!is_ball(point)) continue;
    auto body = std::ranges::find(bodies, point.body);
    if (body == bodies.end()) body = bodies.insert(bodies.end(), point.body);
    mesh.mass.push_back(point.masses[0]);
    mesh.inverse_mass.push_back(model.masses.inverse_mass[point.masses[0]]);
    mesh.radius.push_back(point.radius);
    mesh.core.push_back(0.0);
    mesh.group.push_back(
        static_cast<std::uint32_t>(first_group + static_cast<std::size_t>(body - bodies.begin())));
  }
  return bodies;
}

// By the links of balls.
void join_balls(FaceMesh& mesh, const Model& model) {
  if (mesh.sheet_nodes == mesh.mass.size()) return;
  constexpr std::uint32_t none = 0xffffffffU;
  std::vector<std::uint32_t> node_of(model.masses.size(), none);
  for (std::uint32_t node = 0; node < mesh.mass.size(); ++node) node_of[mesh.mass[node]] = node;
  for (std::size_t link = 0; link < model.links.size(); ++link) {
    const auto [sheet, ball] = std::minmax(node_of[model.links.a[link]], node_of[model.links.b[link]]);
    if (ball != none && sheet < mesh.sheet_nodes && ball >= mesh.sheet_nodes)
      mesh.joined.emplace_back(ball, sheet);
  }
  std::ranges::sort(mesh.joined);
}

}  // namespace

FaceMesh::FaceMesh(const Model& model) {
  if (model.faces.empty()) return;
  for (const SheetFaces& faces : model.faces) {
    const auto nodes = add_sheet_nodes(*this, model, faces, static_cast<std::uint32_t>(groups.size()));
    groups.push_back({&faces, nullptr, faces.friction, faces.body});
    add_sheet_triangles(*this, model, model.sheets[faces.sheet], nodes);
  }
  sheet_nodes = static_cast<std::uint32_t>(mass.size());
  const std::vector<Index> bodies = add_balls(*this, model);
  join_balls(*this, model);
  for (const Collider& collider : model.colliders) {
    const auto solid = static_cast<std::uint32_t>(groups.size());
    groups.push_back({nullptr, &collider, collider.friction, no_body});
    std::visit([&](const auto& shape) { add_solid(*this, shape, solid); }, collider.shape);
  }
  for (const Index body : bodies) groups.push_back({nullptr, nullptr, body_friction, body});
}

bool FaceMesh::joins(std::uint32_t point, const std::array<std::uint32_t, 3>& triangle) const {
  return is_ball(point) && std::ranges::any_of(triangle, [&](std::uint32_t corner) {
           return std::ranges::binary_search(joined, std::pair(point, corner));
         });
}

void FaceMesh::places(const Vectors& position, double time, std::vector<Vec3>& out) const {
  out.resize(size());
  for (std::size_t node = 0; node < mass.size(); ++node) out[node] = position.at(mass[node]);
  std::uint32_t placed = 0xffffffffU;  // the group that the placement is of
  Placement placement;
  for (std::uint32_t node = static_cast<std::uint32_t>(mass.size()); node < size(); ++node) {
    const Vec3& stands = solid_place[node - mass.size()];
    if (!rides(node)) {
      out[node] = stands;
      continue;
    }
    if (std::exchange(placed, group[node]) != group[node])
      placement = placement_at(*groups[group[node]].solid->motion, time);
    out[node] = placement.place(stands);
  }
}

bool FaceMesh::meet(std::uint32_t group_a, std::uint32_t group_b) const {
  const Group &a = groups[group_a], &b = groups[group_b];
  if (a.faces == nullptr && b.faces == nullptr) return false;
  if (a.solid != nullptr || b.solid != nullptr) return true;
  if (group_a == group_b) return a.faces->self_collides;
  return a.body != b.body && a.body != no_body && b.body != no_body;
}

bool FaceMesh::any_meet() const {
  for (std::uint32_t a = 0; a < groups.size(); ++a)
    for (std::uint32_t b = 0; b <= a; ++b)
      if (groups[a].solid == nullptr && groups[b].solid == nullptr && meet(a, b)) return true;
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
    if (met[node] || node >= mesh.sheet_nodes) whole.points.push_back(node);
  for (std::uint32_t i = 0; i < mesh.edges.size(); ++i) {
    const auto [one, other] = mesh.edges[i].triangles;
    if (one == FaceMesh::no_triangle || alive[one] || alive[other]) whole.edges.push_back(i);
  }
  return whole;
}

}  // namespace taut
