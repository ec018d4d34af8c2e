#include "frames/colouring.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <vector>

#include "base/failure.h"
#include "methods/registry.h"

namespace taut {

bool tension_known(const Scene& scene, double time) {
  return find_method(scene.settings.method)->can.tension_order > 0 && time > scene.start.time;
}

std::string colour_problem(const Scene& scene) {
  if (scene.look.colour_by == ColourBy::limit && scene.model.limits.empty())
    return fmt::format("{} has no limits on angles to colour by; there are plain, strain, tension and speed",
                       scene.name);
  const Method* method = find_method(scene.settings.method);
  if (scene.look.colour_by != ColourBy::tension || method == nullptr || method->can.tension_order > 0)
    return {};
  std::vector<std::string_view> names;
  for (const Method& other : all_methods())
    if (other.can.tension_order > 0) names.push_back(other.name);
  return fmt::format(
      "{}: method \"{}\" knows no tensions to colour by; these do: {}; or colour by plain, strain or speed",
      scene.name, method->name, fmt::join(names, ", "));
}

void require_colours(const Scene& scene) {
  if (const std::string problem = colour_problem(scene); !problem.empty()) throw BadRequest(problem);
}

}  // namespace taut
