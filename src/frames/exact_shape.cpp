#include "frames/exact_shape.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/failure.h"
#include "measure/rest_shape.h"
#include "methods/registry.h"

namespace taut {
namespace {

// To settle more links than this would take minutes.
constexpr std::size_t most_links = 3000;

std::string why_not(const Model& model, const State& start) {
  if (last_change(model) == infinity) return "a pin swings for ever";
  if (std::ranges::none_of(model.masses.inverse_mass, [](double inverse) { return inverse == 0.0; }))
    return "nothing is pinned";
  if (!model.breakable_links.empty())
    return "links may break, and where it comes to rest then depends on how";
  if (model.wind) return "the wind blows";
  if (model.links.size() > most_links)
    return fmt::format("it has {} links, and with more than {} that takes too long to find",
                       model.links.size(), most_links);
  const std::vector<std::string> problems = refusals(model, start, complete_settings({"newton", {}}));
  return problems.empty() ? "" : problems.front();
}

}  // namespace

std::string exact_problem(const Scene& scene) {
  if (!scene.look.exact) return {};
  const std::string reason = why_not(scene.model, scene.start);
  return reason.empty() ? "" : fmt::format("{} has no exact shape at rest to draw: {}", scene.name, reason);
}

void require_exact(const Scene& scene) {
  if (const std::string problem = exact_problem(scene); !problem.empty()) throw BadRequest(problem);
}

std::optional<State> exact_shape(const Scene& scene) {
  if (!scene.look.exact) return std::nullopt;
  RestShape shape = exact_rest_shape(scene.model, scene.start, {});
  if (!shape.at_rest)
    throw RunFailure(fmt::format("{} has no exact shape at rest to draw: it still moved by {:.2g} m in {} s",
                                 scene.name, shape.largest_movement, Settling{}.window));
  return std::move(shape.state);
}

}  // namespace taut
