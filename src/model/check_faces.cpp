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

// Where faces start, and what of it is wrong: at most one report of each kind for a sheet.
class FaceStart {
 public:
  FaceStart(const Builder& builder, const Description& description)
      : model_(builder.model),
        description_(description),
        position_(builder.start.position),
        mesh_(builder.model),
        whole_(whole_faces(mesh_, builder.model, builder.start.broken_at)) {
    mesh_.places(position_, places_);
  }

  void report(std::vector<Problem>& problems) const {
    const std::size_t before = problems.size();
    report_tangles(problems);
    report_solids(problems);
    if (problems.size() == before) report_near(problems);
  }

 private:
  // What is wrong with a sheet, as it is found: the first place, and how many.
  struct Finding {
    std::string first;
    std::size_t count = 0;
  };

  static void put(const std::vector<Finding>& findings, const Model& model, std::vector<Problem>& problems) {
    for (std::size_t i = 0; i < findings.size(); ++i)
      if (findings[i].count > 0)
        problems.push_back(
            {"sheet", model.faces[i].sheet, "faces",
             findings[i].first +
                 (findings[i].count > 1 ? fmt::format("; there are {} such places", findings[i].count) : ""),
             ""});
  }

  void note(std::vector<Finding>& findings, std::uint32_t node, const std::string& text) const {
    Finding& finding = findings[mesh_.group[node]];
    if (finding.count++ == 0) finding.first = text;
  }

  // A sheet's node by its mass, a solid's by its section.
  std::string name_of(std::uint32_t node) const {
    if (!mesh_.of_solid(node)) return fmt::format("\"{}\"", model_.masses.name[mesh_.mass[node]]);
    return solid_name(mesh_.group[node] - model_.faces.size());
  }

  std::string solid_name(std::size_t collider) const {
    std::size_t index = collider;
    const auto in = [&](std::string_view section, std::size_t count) -> std::string {
      if (index < count) return fmt::format("the [[{}]] number {}", section, index + 1);
      index -= count;
      return {};
    };
    for (const auto& [section, count] :
         {std::pair{"plane", description_.planes.size()}, std::pair{"sphere", description_.spheres.size()},
          std::pair{"capsule", description_.capsules.size()}, std::pair{"box", description_.boxes.size()}})
      if (std::string name = in(section, count); !name.empty()) return name;
    return "a solid";
  }

  template <std::size_t count>
  std::string names_of(const std::array<std::uint32_t, count>& nodes) const {
    if (mesh_.of_solid(nodes[0])) return name_of(nodes[0]);
    std::string names;
    for (std::size_t k = 0; k < count; ++k)
      names += (k == 0 ? "" : k + 1 < count ? ", " : " and ") + name_of(nodes[k]);
    return (count == 2 ? "the edge of " : count == 3 ? "the face of " : "") + names;
  }

  void report_tangles(std::vector<Problem>& problems) const {
    std::vector<Finding> findings(model_.faces.size());
    for (const Tangle& tangle : find_tangles(mesh_, whole_, places_, most_near_pairs)) {
      const std::uint32_t node = mesh_.of_solid(tangle.edge[0]) ? tangle.triangle[0] : tangle.edge[0];
      note(findings, node,
           fmt::format("faces must not start through each other or through a solid: {} goes through {}",
                       names_of(tangle.edge), names_of(tangle.triangle)));
    }
    put(findings, model_, problems);
  }

  void report_solids(std::vector<Problem>& problems) const {
    std::vector<Finding> findings(model_.faces.size());
    for (const std::uint32_t triangle : whole_.triangles) {
      const auto& nodes = mesh_.triangles[triangle];
      if (mesh_.of_solid(nodes[0])) continue;
      const std::array corners{places_[nodes[0]], places_[nodes[1]], places_[nodes[2]]};
      const double half = mesh_.radius[nodes[0]];
      for (std::size_t i = 0; i < model_.colliders.size(); ++i) {
        if (!may_be_within(half, model_.colliders[i].shape, corners)) continue;
        const double distance = least_distance(model_.colliders[i].shape, corners);
        if (!(distance < half * (1.0 - rounding))) continue;
        note(findings, nodes[0],
             distance < 0.0
                 ? fmt::format("{} starts inside {}", names_of(nodes), solid_name(i))
                 : fmt::format("{} starts {:.4g} m from {}, nearer than half its thickness, {:.4g} m",
                               names_of(nodes), distance, solid_name(i), half));
      }
    }
    put(findings, model_, problems);
  }

  void report_near(std::vector<Problem>& problems) const {
    std::vector<Finding> findings(model_.faces.size());
    std::vector<FacePair> pairs;
    find_face_pairs(mesh_, whole_, places_, std::vector<double>(mesh_.size(), 0.0), most_near_pairs, pairs);
    for (const FacePair& pair : pairs) {
      if (mesh_.of_solid(pair.nodes[0]) || mesh_.of_solid(pair.nodes[3])) continue;
      const double distance = nearest_gap(pair, places_).distance, apart = kept_apart(mesh_, pair);
      if (!(distance < apart * (1.0 - rounding))) continue;
      const auto [a, b, c, d] = pair.nodes;
      const std::string one = pair.edges ? names_of(std::array{a, b}) : name_of(a);
      const std::string other = pair.edges ? names_of(std::array{c, d}) : names_of(std::array{b, c, d});
      note(findings, a,
           fmt::format(
               "faces must start at least their thickness apart, {:.4g} m: {} and {} are {:.4g} m apart",
               apart, one, other, distance));
    }
    put(findings, model_, problems);
  }

  const Model& model_;
  const Description& description_;
  const Vectors& position_;
  FaceMesh mesh_;
  WholeFaces whole_;
  std::vector<Vec3> places_;
};

}  // namespace

void find_face_problems(const Builder& builder, const Description& description,
                        std::vector<Problem>& problems) {
  if (builder.model.faces.empty() || !problems.empty()) return;
  FaceStart(builder, description).report(problems);
}

}  // namespace taut
