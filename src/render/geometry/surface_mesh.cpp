#include "geometry/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "geometry/mesh_surface.h"
#include "geometry/tears.h"
#include "geometry/view_matrices.h"

namespace taut {
namespace {

/// Sums each triangle's normal, as long as twice its area, into its corners; those of meshes have theirs.
void add_normals(SurfaceMesh& mesh, const SurfaceTopology& topology) {
  const auto indices = std::span(*mesh.indices).first(topology.sheet_indices);
  for (std::size_t i = 0; i < indices.size(); i += 3) {
    SurfaceVertex& a = mesh.vertices[indices[i]];
    SurfaceVertex& b = mesh.vertices[indices[i + 1]];
    SurfaceVertex& c = mesh.vertices[indices[i + 2]];
    const glm::vec3 normal = glm::cross(b.position - a.position, c.position - a.position);
    a.normal += normal;
    b.normal += normal;
    c.normal += normal;
  }
  for (SurfaceVertex& vertex : std::span(mesh.vertices).first(topology.sheet_vertices)) {
    const float length = glm::length(vertex.normal);
    vertex.normal = length > 0.0F ? vertex.normal / length : glm::vec3(0, 1, 0);
  }
}

/// Calls visit(number of the vertex, row and column in cells) for the vertices of sheets, in their order.
template <typename Visit>
void for_each_sheet_vertex(const Cloth& cloth, const Visit& visit) {
  std::size_t vertex = 0;
  for (const SheetLattice& sheet : cloth.sheets) {
    const glm::uvec2 size = fine_size(sheet, cloth.fineness);
    for (glm::uint y = 0; y < size.y; ++y)
      for (glm::uint x = 0; x < size.x; ++x) visit(vertex++, sheet, x, y);
  }
}

/// What masses have, for each vertex: between them in proportion, along tears that of the mass they hang on.
template <typename Value>
std::vector<Value> at_vertices(const Cloth& cloth, const SurfaceTopology& topology,
                               const std::vector<Value>& of_mass) {
  std::vector<Value> values;
  values.reserve(topology.places->size());
  const Index across = cloth.fineness.across, down = cloth.fineness.down;
  for_each_sheet_vertex(cloth, [&](std::size_t, const SheetLattice& sheet, Index x, Index y) {
    const Index row = y / down, column = x / across;
    const auto right = share_as<Value>(x % across, across);
    const auto below = share_as<Value>(y % down, down);
    Value value = of_mass[sheet.mass(row, column)];
    if (x % across != 0) value += right * (of_mass[sheet.mass(row, column + 1)] - value);
    if (y % down != 0) {
      Value lower = of_mass[sheet.mass(row + 1, column)];
      if (x % across != 0) lower += right * (of_mass[sheet.mass(row + 1, column + 1)] - lower);
      value += below * (lower - value);
    }
    values.push_back(value);
  });
  for (const Index mass : masses_of_tears(topology)) values.push_back(of_mass[mass]);
  add_mesh_values(cloth.meshes, topology.meshes, of_mass, values);
  return values;
}

std::vector<glm::vec3> places_of_masses(const State& seen) {
  std::vector<glm::vec3> places;
  places.reserve(seen.position.size());
  for (std::size_t mass = 0; mass < seen.position.size(); ++mass)
    places.push_back(to_glm(seen.position.at(mass)));
  return places;
}

/// From the world's axes to a picture space's.
glm::mat3 turn_of(const PictureSpace& space) {
  return {to_glm(space.direction(Vec3::UnitX())), to_glm(space.direction(Vec3::UnitY())),
          to_glm(space.direction(Vec3::UnitZ()))};
}

void add_vertices(SurfaceMesh& mesh, const Cloth& cloth, const SurfaceTopology& topology,
                  const std::vector<glm::vec3>& masses, const PictureSpace& space) {
  mesh.vertices.reserve(topology.places->size());
  const auto add = [&mesh](const std::vector<glm::vec3>& places) {
    for (const glm::vec3& place : places) mesh.vertices.push_back({place, glm::vec3(0.0F), glm::vec2(1.0F)});
  };
  const std::span<const glm::vec3> all(masses);
  for (const SheetLattice& sheet : cloth.sheets)
    add(smooth_places(sheet, cloth.fineness, topology.broken,
                      all.subspan(sheet.first_mass, std::size_t{sheet.rows} * sheet.columns)));
  add(places_of_tears(topology, masses, turn_of(space)));
}

/// Each vertex has the colours of its sheet.
void add_tints(SurfaceMesh& mesh, const Cloth& cloth, const SurfaceTopology& topology) {
  if (cloth.tints.empty() && cloth.meshes.tints.empty()) return;
  for (std::size_t i = 0; i < cloth.sheets.size(); ++i) {
    const glm::uvec2 size = fine_size(cloth.sheets[i], cloth.fineness);
    mesh.tints.insert(mesh.tints.end(), std::size_t{size.x} * size.y, cloth.tints[i]);
  }
  for (const Index mass : masses_of_tears(topology)) {
    const auto after = std::ranges::upper_bound(cloth.sheets, mass, {}, &SheetLattice::first_mass);
    mesh.tints.push_back(cloth.tints[static_cast<std::size_t>(after - cloth.sheets.begin()) - 1]);
  }
  for (const Index triangle : topology.meshes.whole)
    mesh.tints.insert(mesh.tints.end(), cloth.meshes.vertices_a_triangle(),
                      cloth.meshes.tints[cloth.meshes.triangles[triangle].mesh]);
  for (const TornVertex& vertex : topology.meshes.torn_vertices)
    mesh.tints.push_back(
        cloth.meshes.tints[cloth.meshes.triangles[topology.meshes.torn[vertex.torn].triangle].mesh]);
}

/// `normals` has those of the masses of meshes.
void add_openness(SurfaceMesh& mesh, const Cloth& cloth, const SurfaceTopology& topology,
                  const std::vector<glm::vec3>& masses, std::vector<glm::vec3> normals,
                  const Surroundings& around) {
  const Index across = cloth.fineness.across, down = cloth.fineness.down;
  for_each_sheet_vertex(cloth, [&](std::size_t vertex, const SheetLattice& sheet, Index x, Index y) {
    if (x % across == 0 && y % down == 0)
      normals[sheet.mass(y / down, x / across)] = mesh.vertices[vertex].normal;
  });
  const std::vector<glm::vec2> open = at_vertices(
      cloth, topology,
      openness_of({topology.mass_triangles, masses, normals, cloth.groups}, around, cloth.nearby));
  for (std::size_t i = 0; i < open.size(); ++i) mesh.vertices[i].open = open[i];
}

}  // namespace

std::vector<glm::vec4> light_places(const SurfaceMesh& mesh, const glm::mat4& to_map,
                                    const glm::vec3& to_light, float texel) {
  const auto width = static_cast<std::size_t>(mesh.spread->places.width);
  std::vector<glm::vec4> places(width * static_cast<std::size_t>(mesh.spread->places.height));
  const auto place_of = [&](const SurfaceVertex& vertex) {
    const float side = glm::dot(vertex.normal, to_light) < 0.0F ? -1.0F : 1.0F;
    const glm::vec3 lifted = vertex.position + texel * (1.5F * side * vertex.normal + to_light);
    return to_map * glm::vec4(lifted, 1.0F);
  };
  std::size_t number = 0, row = 0;
  for (const glm::uvec2& sheet : mesh.spread->sheets)
    for (glm::uint y = 0; y < sheet.y; ++y, ++row)
      for (glm::uint x = 0; x < sheet.x; ++x) places[row * width + x] = place_of(mesh.vertices[number++]);
  const MeshBlocks& blocks = mesh.spread->blocks;
  std::size_t in_blocks = 0;
  for (Index block = 0; block < blocks.count; ++block) {
    const glm::uvec2 first = blocks.first_place(block);
    const auto place = [&](Index x, Index y) -> glm::vec4& {  // from the margin on
      return places[std::size_t{first.y + y - 1} * width + first.x + x - 1];
    };
    const Index last = blocks.side - 1;
    for (Index y = 1; y < last; ++y)
      for (Index x = 1; x < last; ++x)
        // Beyond its long side the triangle goes on.
        place(x, y) = x + y <= last ? place_of(mesh.vertices[(*mesh.block_vertices)[in_blocks++]])
                                    : place(x - 1, y) + place(x, y - 1) - place(x - 1, y - 1);
    for (Index x = 1; x < last; ++x) {
      place(x, 0) = 2.0F * place(x, 1) - place(x, 2);
      place(x, last) = 2.0F * place(x, last - 1) - place(x, last - 2);
    }
    for (Index y = 0; y <= last; ++y) {
      place(0, y) = 2.0F * place(1, y) - place(2, y);
      place(last, y) = 2.0F * place(last - 1, y) - place(last - 2, y);
    }
  }
  return places;
}

SurfaceMesh surface_mesh(const Cloth& cloth, const SurfaceTopology& topology, const State& seen,
                         const PictureSpace& space, const Quantity& quantity, const ColourScale& scale,
                         const Surroundings& around) {
  SurfaceMesh mesh;
  mesh.indices = topology.indices;
  mesh.places = topology.places;
  mesh.spread = cloth.spread;
  mesh.block_vertices = topology.meshes.block_vertices;
  const std::vector<glm::vec3> masses = places_of_masses(seen);
  add_vertices(mesh, cloth, topology, masses, space);
  std::vector<glm::vec3> normals(masses.size(), glm::vec3(0.0F));
  for (const SurfaceVertex& vertex :
       mesh_vertices(cloth.meshes, topology.meshes, masses, cloth.at_start, turn_of(space), normals))
    mesh.vertices.push_back(vertex);
  if (!quantity.of_mass.empty()) {
    mesh.colours.reserve(mesh.vertices.size());
    for (const double value : at_vertices(cloth, topology, quantity.of_mass))
      mesh.colours.push_back(opaque(scale.at(value)));
  }
  add_tints(mesh, cloth, topology);
  add_normals(mesh, topology);
  if (mesh.colours.empty()) add_openness(mesh, cloth, topology, masses, std::move(normals), around);
  return mesh;
}

}  // namespace taut
