#include "geometry/mesh_topology.h"

#include <algorithm>
#include <map>

#include "model/limits.h"

namespace taut {
namespace {

constexpr float stray_along_edge = 0.15F, stray_between = 0.1F;  // in edges, as tears of sheets stray

Index after(Index corner) {
  return (corner + 1) % 3;
}

// The number within a triangle of the vertex so many parts towards the second and the third corner.
Index fine_vertex(Index parts, Index to_second, Index to_third) {
  return to_third * (parts + 1) - to_third * (to_third - 1) / 2 + to_second;
}

template <class Value>
Value blend(const std::array<Value, 3>& values, const glm::vec3& share) {
  return values[0] * share.x + values[1] * share.y + values[2] * share.z;
}

class MeshCutter {
 public:
  MeshCutter(const MeshCloth& cloth, const MeshBlocks& blocks, const std::vector<bool>& broken,
             std::vector<SurfacePlace>& places, std::vector<Index>& indices)
      : cloth_(cloth), blocks_(blocks), broken_(broken), places_(places), indices_(indices) {}

  MeshTopology make() {
    for (Index i = 0; i < cloth_.triangles.size(); ++i) {
      const std::array torn{is_broken(i, 0), is_broken(i, 1), is_broken(i, 2)};
      if (torn == std::array{false, false, false})
        made_.whole.push_back(i);
      else
        made_.torn.push_back({i, torn});
    }
    block_vertices_.resize(cloth_.triangles.size() * cloth_.vertices_a_triangle());
    for (const Index triangle : made_.whole) add_whole(triangle);
    for (Index torn = 0; torn < made_.torn.size(); ++torn) add_torn(torn);
    if (!made_.torn.empty()) gather_torn_masses();
    made_.block_vertices = std::make_shared<const std::vector<Index>>(std::move(block_vertices_));
    return std::move(made_);
  }

 private:
  // Whether any link of a triangle is broken.
  bool has_broken_link(Index triangle) const {
    return std::ranges::any_of(cloth_.triangles[triangle].links,
                               [this](Index link) { return link != no_link && broken_[link]; });
  }

  // A quad's diagonal is parted where links on both sides of it are.
  bool is_broken(Index triangle, Index edge) const {
    const MeshTriangle& of = cloth_.triangles[triangle];
    if (of.links[edge] != no_link) return broken_[of.links[edge]];
    return of.other_half != triangle && has_broken_link(triangle) && has_broken_link(of.other_half);
  }

  // What chance along an edge goes by, the same for both triangles that have it.
  Index seed_of(Index triangle, Index edge) const {
    const MeshTriangle& of = cloth_.triangles[triangle];
    return of.links[edge] != no_link ? of.links[edge] : std::min(triangle, of.other_half) + 0x40000000U;
  }

  SurfacePlace place_at(Index triangle, const glm::vec3& share, float from_tear,
                        const glm::vec2& in_block) const {
    const MeshTriangle& of = cloth_.triangles[triangle];
    const glm::vec2 light = glm::vec2(blocks_.first_place(triangle)) + in_block;
    return {blend(of.pattern, share), glm::vec3(blend(of.borders, share), from_tear), light};
  }

  Index& block_vertex(Index triangle, Index number) {
    return block_vertices_[std::size_t{triangle} * cloth_.vertices_a_triangle() + number];
  }

  void add(Index a, Index b, Index c) { indices_.insert(indices_.end(), {a, b, c}); }

  void add_whole(Index triangle) {
    const Index parts = cloth_.parts;
    const auto first = static_cast<Index>(places_.size());
    for (Index down = 0; down <= parts; ++down)
      for (Index across = 0; across + down <= parts; ++across) {
        const glm::vec2 at(across, down);
        const glm::vec2 towards = at / static_cast<float>(parts);
        const Index number = fine_vertex(parts, across, down);
        block_vertex(triangle, number) = first + number;
        places_.push_back(
            place_at(triangle, glm::vec3(1.0F - towards.x - towards.y, towards.x, towards.y), 1.0F, at));
      }
    for (Index down = 0; down < parts; ++down)
      for (Index across = 0; across + down < parts; ++across) {
        const auto vertex = [&](Index x, Index y) {
          return first + fine_vertex(parts, across + x, down + y);
        };
        add(vertex(0, 0), vertex(1, 0), vertex(0, 1));
        if (across + down + 1 < parts) add(vertex(1, 0), vertex(1, 1), vertex(0, 1));
      }
  }

  // Every corner keeps the cloth around it, as far as the middles of the edges and of the triangle.
  void add_torn(Index torn) {
    const std::array<Index, 3> corners{add_kite(torn, 0), add_kite(torn, 1), add_kite(torn, 2)};
    const Index parts = cloth_.parts, triangle = made_.torn[torn].triangle;
    for (Index down = 0; down <= parts; ++down)
      for (Index across = 0; across + down <= parts; ++across) {
        const Index rest = parts - across - down;
        const Index nearest = across > std::max(rest, down) ? 1 : down > std::max(rest, across) ? 2 : 0;
        block_vertex(triangle, fine_vertex(parts, across, down)) = corners[nearest];
      }
  }

  // Of the edge from a corner to the next, the share that stays with that corner, the same for both triangles
  // that have it.
  float share_of_first(Index triangle, Index edge) const {
    const MeshTriangle& of = cloth_.triangles[triangle];
    const float stray = stray_along_edge * jitter(seed_of(triangle, edge), 0);
    return of.masses[edge] < of.masses[after(edge)] ? 0.5F + stray : 0.5F - stray;
  }

  // Gives the vertex at the corner.
  Index add_kite(Index torn, Index corner) {
    const Index triangle = made_.torn[torn].triangle;
    const Index next = after(corner), before = after(next);
    glm::vec3 at_corner(0.0F);
    at_corner[static_cast<int>(corner)] = 1.0F;
    const auto vertex = [&](const glm::vec3& share, float from_tear, bool middle = false) {
      const glm::vec2 in_block = static_cast<float>(cloth_.parts) * glm::vec2(at_corner.y, at_corner.z);
      places_.push_back(place_at(triangle, share, from_tear, in_block));
      made_.torn_vertices.push_back({torn, corner, share, from_tear, middle});
      return static_cast<Index>(places_.size() - 1);
    };
    const Index place = vertex(at_corner, 1.0F);
    std::vector<Index> loop, behind;
    add_side(loop, torn, corner, next, corner, vertex);
    add_side(behind, torn, corner, before, before, vertex);
    loop.push_back(vertex(glm::vec3(1.0F / 3.0F), 0.0F, true));
    loop.insert(loop.end(), behind.rbegin(), behind.rend());
    for (std::size_t i = 0; i + 1 < loop.size(); ++i) add(place, loop[i], loop[i + 1]);
    return place;
  }

  // Vertices from behind a corner to the middle of the edge to another one, and on towards the middle of the
  // triangle where the edge is broken.
  template <class Vertex>
  void add_side(std::vector<Index>& loop, Index torn, Index corner, Index to, Index edge,
                const Vertex& vertex) {
    const auto [triangle, broken] = made_.torn[torn];
    const bool cut = broken[edge];
    const float first = cut ? share_of_first(triangle, edge) : 0.5F;
    const float reach = edge == corner ? first : 1.0F - first;
    const auto along = [&](float far) {
      glm::vec3 share(0.0F);
      share[static_cast<int>(corner)] = 1.0F - far;
      share[static_cast<int>(to)] = far;
      return share;
    };
    const Index steps = std::max<Index>(cloth_.parts / 2, 1);
    for (Index i = 1; i <= steps; ++i) {
      const float share = static_cast<float>(i) / static_cast<float>(steps);
      loop.push_back(vertex(along(share * reach), cut ? 1.0F - share : 1.0F));
    }
    if (!cut) return;
    const float stray = stray_between * jitter(seed_of(triangle, edge), 1 + triangle % 7);
    glm::vec3 between = 0.5F * (along(reach) + glm::vec3(1.0F / 3.0F));
    between[static_cast<int>(edge)] += stray;
    between[static_cast<int>(after(edge))] -= stray;
    loop.push_back(vertex(between, 0.0F));
  }

  void gather_torn_masses() {
    std::map<Index, std::vector<Index>> beside;
    for (const TornTriangle& torn : made_.torn)
      for (const Index mass : cloth_.triangles[torn.triangle].masses) beside[mass];
    for (const MeshTriangle& triangle : cloth_.triangles)
      for (Index k = 0; k < 3; ++k) {
        const Index link = triangle.links[k];
        if (link == no_link || broken_[link]) continue;
        const Index a = triangle.masses[k], b = triangle.masses[after(k)];
        if (const auto found = beside.find(a); found != beside.end()) found->second.push_back(b);
        if (const auto found = beside.find(b); found != beside.end()) found->second.push_back(a);
      }
    for (auto& [mass, others] : beside) made_.torn_masses.push_back({mass, std::move(others)});
  }

  const MeshCloth& cloth_;
  const MeshBlocks& blocks_;
  const std::vector<bool>& broken_;
  std::vector<SurfacePlace>& places_;
  std::vector<Index>& indices_;
  std::vector<Index> block_vertices_;
  MeshTopology made_;
};

}  // namespace

MeshTopology mesh_topology(const MeshCloth& cloth, const MeshBlocks& blocks, const std::vector<bool>& broken,
                           std::vector<SurfacePlace>& places, std::vector<Index>& indices) {
  return MeshCutter(cloth, blocks, broken, places, indices).make();
}

}  // namespace taut
