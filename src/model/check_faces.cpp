#include <fmt/format.h>

#include <algorithm>

#include "builder.h"
#include "model/face_depth.h"
#include "model/face_pairs.h"
#include "model/tangles.h"

namespace taut {
namespace {

constexpr double rounding = 1e-9;                   // of a thickness
constexpr std::size_t most_near_pairs = 5'000'000;  // more than any sheet has that does not lie in itself

// Where faces start, and what of it is wrong: at most one report for a sheet.
class FaceStart {
 public:
  FaceStart(const Builder& builder, const Description& description)
      : model_(builder.model),
        description_(description),
        mesh_(builder.model),
        whole_(whole_faces(mesh_, builder.model, builder.start.broken_at)) {
    mesh_.places(builder.start.position, builder.start.time, places_);
    for (const Collider& collider : model_.colliders)
      shapes_.push_back(shape_at(collider, builder.start.time));
  }

  void report(std::vector<Problem>& problems) {
    findings_.resize(model_.faces.size());
    note_tangles();
    note_solids();
    note_near();
    for (std::size_t i = 0; i < findings_.size(); ++i) {
      const auto& [kind, first, places] = findings_[i];
      if (places == 0) continue;
      const std::string more = places > 1 ? fmt::format("; there are {} such places", places) : "";
      const auto [section, index] = sheet_entry(description_, model_.faces[i].sheet);
      problems.push_back({std::string(section), index, "faces", first + more, ""});
    }
  }

 private:
  // What is wrong with a sheet: the gravest kind alone, by its first place, and how many there are.
  enum class Kind { tangled, in_solid, near };
  struct Finding {
    Kind kind = Kind::tangled;
    std::string first;
    std::size_t places = 0;
  };

  // Of the sheets of two nodes, or of one of those and a solid, the first.
  template <class Text>
  void note(Kind kind, std::uint32_t one, std::uint32_t other, const Text& text) {
    Finding& finding = findings_[std::min(mesh_.group[one], mesh_.group[other])];
    if (finding.places > 0 && finding.kind != kind) return;
    finding.kind = kind;
    if (finding.places++ == 0) finding.first = text();
  }

  // A sheet's node by its mass, a solid's by its section.
  std::string name_of(std::uint32_t node) const {
    if (!mesh_.of_solid(node)) return fmt::format("\"{}\"", model_.masses.name[mesh_.mass[node]]);
    return solid_name(mesh_.group[node] - model_.faces.size());
  }

  std::string solid_name(std::size_t collider) const {
    const auto [section, index] = solid_entry(description_, collider);
    return fmt::format("the [[{}]] number {}", section, index + 1);
  }

  template <std::size_t count>
  std::string names_of(const std::array<std::uint32_t, count>& nodes) const {
    if (mesh_.of_solid(nodes[0])) return name_of(nodes[0]);
    std::string names;
    for (std::size_t k = 0; k < count; ++k)
      names += (k == 0 ? "" : k + 1 < count ? ", " : " and ") + name_of(nodes[k]);
    return (count == 2 ? "the edge of " : count == 3 ? "the face of " : "") + names;
  }

  void note_tangles() {
    for (const Tangle& tangle : find_tangles(mesh_, whole_, places_, most_near_pairs))
      note(Kind::tangled, tangle.edge[0], tangle.triangle[0], [&] {
        return fmt::format("faces must not start through each other or through a solid: {} goes through {}",
                           names_of(tangle.edge), names_of(tangle.triangle));
      });
  }

  void note_solids() {
    for (const std::uint32_t triangle : whole_.triangles) {
      const auto& nodes = mesh_.triangles[triangle];
      if (mesh_.of_solid(nodes[0])) continue;
      const std::array corners{places_[nodes[0]], places_[nodes[1]], places_[nodes[2]]};
      const double half = mesh_.radius[nodes[0]];
      for (std::size_t i = 0; i < shapes_.size(); ++i) {
        const Shape& shape = shapes_[i];
        if (!may_be_within(half, shape, corners)) continue;
        const double distance = least_distance(shape, corners);
        if (distance < half * (1.0 - rounding))
          note(Kind::in_solid, nodes[0], nodes[0], [&] { return in_solid(nodes, distance, half, i); });
      }
    }
  }

  std::string in_solid(const std::array<std::uint32_t, 3>& nodes, double distance, double half,
                       std::size_t collider) const {
    if (distance < 0.0) return fmt::format("{} starts inside {}", names_of(nodes), solid_name(collider));
    return fmt::format("{} starts {:.4g} m from {}, nearer than half its thickness, {:.4g} m",
                       names_of(nodes), distance, solid_name(collider), half);
  }

  void note_near() {
    std::vector<FacePair> pairs;
    find_face_pairs(mesh_, whole_, places_, std::vector<double>(mesh_.size(), 0.0), most_near_pairs, pairs);
    for (const FacePair& pair : pairs) {
      const auto& nodes = pair.nodes;
      const double apart = kept_apart(mesh_, pair);
      if (mesh_.of_solid(nodes[0]) || mesh_.of_solid(nodes[3]) || !(pair.distance < apart * (1.0 - rounding)))
        continue;
      note(Kind::near, nodes[0], nodes[3], [&] {
        const std::string one = pair.edges ? names_of(std::array{nodes[0], nodes[1]}) : name_of(nodes[0]);
        const std::string other = pair.edges ? names_of(std::array{nodes[2], nodes[3]})
                                             : names_of(std::array{nodes[1], nodes[2], nodes[3]});
        return fmt::format(
            "faces must start at least their thickness apart, {:.4g} m: {} and {} are {:.4g} m apart", apart,
            one, other, pair.distance);
      });
    }
  }

  const Model& model_;
  const Description& description_;
  FaceMesh mesh_;
  WholeFaces whole_;
  std::vector<Vec3> places_;
  std::vector<Shape> shapes_;      // of solids, at the start
  std::vector<Finding> findings_;  // of each sheet with faces
};

}  // namespace

void find_face_problems(const Builder& builder, const Description& description,
                        std::vector<Problem>& problems) {
  if (builder.model.faces.empty() || !problems.empty()) return;
  FaceStart(builder, description).report(problems);
}

}  // namespace taut
