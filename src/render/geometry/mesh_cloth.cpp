#include "geometry/mesh_cloth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "geometry/view_matrices.h"
#include "model/limits.h"
#include "render/appearance.h"

namespace taut {
namespace {

constexpr float no_border_near = 100.0F;  // hem widths

using Edge = std::pair<Index, Index>;

// A mesh at the start, in the world's axes.
class MeshAtStart {
 public:
  MeshAtStart(const Model& model, const Sheet& sheet, const State& start) : model_(model), sheet_(sheet) {
    places_.reserve(sheet.mass_count);
    for (Index i = 0; i < sheet.mass_count; ++i)
      places_.push_back(to_glm(start.position.at(sheet.first_mass + i)));
    normals_.resize(sheet.mass_count, glm::vec3(0.0F));
    for (Index i = 0; i < sheet.triangle_count; ++i) measure(triangle(i));
    find_borders();
  }

  const Triangle& triangle(Index i) const { return model_.triangles[sheet_.first_triangle + i]; }
  const glm::vec3& place(Index mass) const { return places_[mass - sheet_.first_mass]; }
  const std::vector<glm::vec3>& normals() const { return normals_; }
  float area() const { return area_; }
  float mean_side() const { return side_sum_ / static_cast<float>(3 * sheet_.triangle_count); }

  // How far (m) the corners of a triangle are from a border: of a side of it, or else from the line through a
  // corner that the border runs through. Of two at most.
  std::array<glm::vec2, 3> from_borders(const Triangle& triangle) const {
    std::array<glm::vec2, 3> distances;
    distances.fill(glm::vec2(1e9F));
    int found = 0;
    for (std::size_t k = 0; k < 3 && found < 2; ++k) {
      const Index a = triangle.masses[k], b = triangle.masses[(k + 1) % 3], c = triangle.masses[(k + 2) % 3];
      if (sides_.at(std::minmax(a, b)) != 1) continue;
      const glm::vec3 along = place(b) - place(a);
      const float height = glm::length(glm::cross(along, place(c) - place(a))) / glm::length(along);
      distances[k][found] = distances[(k + 1) % 3][found] = 0.0F;
      distances[(k + 2) % 3][found++] = height;
    }
    for (std::size_t k = 0; k < 3 && found < 2; ++k) {
      const Index a = triangle.masses[k];
      const glm::vec3& inwards = inwards_[a - sheet_.first_mass];
      if (glm::length(inwards) == 0.0F || distances[k][0] == 0.0F) continue;
      for (std::size_t i = 0; i < 3; ++i)
        distances[i][found] =
            std::max(0.0F, glm::dot(glm::normalize(inwards), place(triangle.masses[i]) - place(a)));
      ++found;
    }
    return distances;
  }

 private:
  void measure(const Triangle& triangle) {
    const auto [a, b, c] = triangle.masses;
    const glm::vec3 normal = glm::cross(place(b) - place(a), place(c) - place(a));
    area_ += 0.5F * glm::length(normal);
    for (std::size_t k = 0; k < 3; ++k) {
      const Index from = triangle.masses[k], to = triangle.masses[(k + 1) % 3];
      normals_[from - sheet_.first_mass] += normal;
      ++sides_[std::minmax(from, to)];
      side_sum_ += glm::length(place(to) - place(from));
    }
  }

  // At each mass of a border, away from it and along the cloth: the mean of its two sides'.
  void find_borders() {
    inwards_.resize(places_.size(), glm::vec3(0.0F));
    for (Index i = 0; i < sheet_.triangle_count; ++i) {
      const Triangle& each = triangle(i);
      for (std::size_t k = 0; k < 3; ++k) {
        const Index a = each.masses[k], b = each.masses[(k + 1) % 3], c = each.masses[(k + 2) % 3];
        if (sides_.at(std::minmax(a, b)) != 1) continue;
        const glm::vec3 along = glm::normalize(place(b) - place(a)), up = place(c) - place(a);
        const glm::vec3 in = glm::normalize(up - along * glm::dot(along, up));
        inwards_[a - sheet_.first_mass] += in;
        inwards_[b - sheet_.first_mass] += in;
      }
    }
    for (glm::vec3& normal : normals_) {
      const float length = glm::length(normal);
      normal = length > 0.0F ? normal / length : glm::vec3(0, 1, 0);
    }
  }

  const Model& model_;
  const Sheet& sheet_;
  std::vector<glm::vec3> places_, normals_, inwards_;
  std::map<Edge, int> sides_;  // how many triangles have each
  float area_ = 0.0F, side_sum_ = 0.0F;
};

// Where a triangle lies in a pattern that is laid on the mesh at the start along the two axes that it faces
// across most.
std::array<glm::vec2, 3> pattern_of(const MeshAtStart& mesh, const Triangle& triangle, float unit) {
  const auto [a, b, c] = triangle.masses;
  const glm::vec3 facing = glm::abs(glm::cross(mesh.place(b) - mesh.place(a), mesh.place(c) - mesh.place(a)));
  const bool along_x = facing.x >= facing.y && facing.x >= facing.z, along_y = facing.y >= facing.z;
  std::array<glm::vec2, 3> pattern;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::vec3& at = mesh.place(triangle.masses[k]);
    pattern[k] = (along_x   ? glm::vec2(at.z, at.y)
                  : along_y ? glm::vec2(at.x, at.z)
                            : glm::vec2(at.x, at.y)) /
                 unit;
  }
  return pattern;
}

// How long (m) a unit of the pattern is, as for sheets: fourteen squares of a checker, eighty threads.
float pattern_unit(const MeshAtStart& mesh, const Look& look) {
  const float across = std::sqrt(mesh.area());
  if (look.pattern == Pattern::checker) return std::max(across / 14.0F, mesh.mean_side());
  return std::max(look.thread_pitch > 0.0 ? static_cast<float>(look.thread_pitch) : across / 80.0F, 1e-9F);
}

// A quad's triangles follow each other: the second is the other half of the first.
void pair_up(std::vector<MeshTriangle>& triangles, MeshTriangle& made) {
  if (triangles.empty()) return;
  MeshTriangle& before = triangles.back();
  const auto number = static_cast<Index>(triangles.size());
  const bool open =
      before.other_half == number - 1 && std::ranges::find(before.links, no_link) != before.links.end();
  if (!open) return;
  before.other_half = number;
  made.other_half = number - 1;
}

void add_mesh_triangles(MeshCloth& cloth, const Model& model, const MeshAtStart& mesh, const Sheet& sheet,
                        const Look& look, Index number) {
  const float unit = pattern_unit(mesh, look);
  const float hem = look.hem_width ? static_cast<float>(*look.hem_width) : 0.018F * std::sqrt(mesh.area());
  for (Index i = 0; i < sheet.triangle_count; ++i) {
    const Triangle& from = mesh.triangle(i);
    MeshTriangle made{from.masses, from.links, {}, pattern_of(mesh, from, unit), {}, number};
    made.other_half = static_cast<Index>(cloth.triangles.size());
    for (Index& link : made.links)
      if (link != no_link && model.links.family[link] != LinkFamily::structural) link = no_link;
    if (std::ranges::find(made.links, no_link) != made.links.end()) pair_up(cloth.triangles, made);
    made.borders.fill(glm::vec2(no_border_near));
    if (hem > 0.0F) made.borders = mesh.from_borders(from);
    for (glm::vec2& border : made.borders)
      if (hem > 0.0F) border = glm::min(border / hem, no_border_near);
    cloth.triangles.push_back(made);
  }
}

// In as many parts as keep edges smooth, and no more vertices than can be told apart.
Index parts_for(std::size_t triangles, float side_in_pixels) {
  constexpr std::size_t most = 400'000, few = 5'000;   // vertices
  constexpr float worth = 18.0F, worth_if_few = 8.0F;  // pixels
  const auto vertices = [&](Index parts) { return triangles * (parts + 1) * (parts + 2) / 2; };
  Index parts = parts_of(side_in_pixels, worth_if_few);
  if (vertices(parts) > few) parts = parts_of(side_in_pixels, worth);
  while (parts > 1 && vertices(parts) > most) parts /= 2;
  return parts;
}

}  // namespace

MeshCloth mesh_cloth(const Model& model, const State& start, const Look& look, const std::vector<bool>& drawn,
                     float pixels_a_metre) {
  MeshCloth cloth;
  float sides = 0.0F;
  for (std::size_t i = 0; i < model.sheets.size(); ++i) {
    const Sheet& sheet = model.sheets[i];
    if (!sheet.is_mesh() || !drawn[i]) continue;
    const MeshAtStart mesh(model, sheet, start);
    cloth.normals.resize(model.masses.size(), glm::vec3(0, 1, 0));
    std::ranges::copy(mesh.normals(), cloth.normals.begin() + sheet.first_mass);
    const auto number = static_cast<Index>(cloth.tints.size());
    const ClothColours colours = cloth_colours(look, model, i);
    cloth.tints.push_back({opaque(colours.front), opaque(colours.back)});
    add_mesh_triangles(cloth, model, mesh, sheet, look, number);
    sides += mesh.mean_side() * static_cast<float>(sheet.triangle_count);
  }
  if (cloth.empty()) return cloth;
  const float side = sides / static_cast<float>(cloth.triangles.size());
  cloth.parts = parts_for(cloth.triangles.size(), side * pixels_a_metre);
  cloth.part_length = side / static_cast<float>(cloth.parts);
  if (!has_own_cloth_colours(look)) cloth.tints.clear();
  return cloth;
}

}  // namespace taut
