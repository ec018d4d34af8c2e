#include "geometry/loose_threads.h"

#include "geometry/view_matrices.h"

namespace taut {
namespace {

struct Thread {
  glm::vec3 start{0.0F};  // m
  glm::vec3 way{0.0F};    // unit vector
  float length = 0.0F;    // m
  float radius = 0.0F;    // m
  Rgba colour{};
  Index seed = 0;
};

glm::vec3 any_direction(Index seed, Index salt) {
  return {jitter(seed, salt), jitter(seed, salt + 1), jitter(seed, salt + 2)};
}

// The pale colour of threads between those of the cloth's sides.
Colour between(const Colour& front, const Colour& back) {
  Colour colour{};
  for (std::size_t i = 0; i < 3; ++i) colour.at(i) = 0.45 + 0.55 * 0.5 * (front.at(i) + back.at(i));
  return colour;
}

Colour shown(const Rgba& bytes) {
  return {bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0};
}

// A bow that ends hanging down, with a curl at its end.
void add_thread(std::vector<RodRecord>& rods, const Thread& thread, const glm::vec3& down, int pieces) {
  const glm::vec3 bow = 0.35F * any_direction(thread.seed, 40), curl = 0.7F * any_direction(thread.seed, 44);
  glm::vec3 at = thread.start;
  for (int piece = 0; piece < pieces; ++piece) {
    const float along = static_cast<float>(piece) / static_cast<float>(pieces - 1);
    const glm::vec3 way = glm::mix(thread.way, 0.9F * down, std::min(1.6F * along, 0.85F)) + bow * along +
                          curl * (along * along * along);
    const glm::vec3 to = at + way * (thread.length / static_cast<float>(pieces));
    rods.push_back({at, thread.radius, to, thread.colour});
    at = to;
  }
}

}  // namespace

std::vector<RodRecord> loose_threads(const Cloth& cloth, const SurfaceTopology& topology,
                                     const SurfaceMesh& mesh, const State& seen, const glm::vec3& down,
                                     const Look& look) {
  std::vector<RodRecord> rods;
  std::size_t first = 0;
  for (const glm::uvec2& sheet : cloth.spread->sheets) first += std::size_t{sheet.x} * sheet.y;
  const int pieces = cloth.fineness == Fineness{} ? 4 : 8;
  const Rgba of_look = opaque(between(look.surface_colour, look.surface_back_colour));
  for (std::size_t i = 0; i < topology.edges.size(); ++i) {
    const CutEdge& edge = topology.edges[i];
    const float chance = jitter(edge.seed, 31);
    if (chance < 0.1F) continue;
    const SurfaceVertex& cut = mesh.vertices[first + i];
    const glm::vec3 way = cut.position - to_glm(seen.position.at(edge.mass));
    const float length = glm::length(way);
    if (!(length > 0.0F)) continue;
    Thread thread;
    thread.start = cut.position;
    thread.way = way / length;
    // A few of them are long.
    thread.length = edge.length * (0.3F + 0.9F * chance + (chance > 0.85F ? 1.5F : 0.0F));
    thread.seed = edge.seed;
    thread.radius = 0.022F * edge.length;
    thread.colour =
        !mesh.colours.empty() ? mesh.colours[first + i]
        : !mesh.tints.empty()
            ? opaque(between(shown(mesh.tints[first + i].front), shown(mesh.tints[first + i].back)))
            : of_look;
    add_thread(rods, thread, down, pieces);
  }
  return rods;
}

}  // namespace taut
