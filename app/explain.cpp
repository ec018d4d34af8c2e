#include "explain.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "measure/pace.h"
#include "methods/registry.h"

namespace taut {
namespace {

std::string time_text(double seconds) {
  if (seconds >= 1e-3) return fmt::format("{:.3g} ms", seconds * 1e3);
  return fmt::format("{:.3g} µs", seconds * 1e6);
}

}  // namespace

nlohmann::ordered_json explanation_to_json(const Explanation& explanation) {
  nlohmann::ordered_json json{{"masses", explanation.masses},
                              {"pins", explanation.pins},
                              {"links", explanation.links},
                              {"links_between_pins", explanation.links_between_pins},
                              {"in_plane", explanation.in_plane},
                              {"step_seconds", explanation.step_seconds},
                              {"modelled", nlohmann::ordered_json::array()},
                              {"left_out", nlohmann::ordered_json::array()}};
  for (const PartCost& part : explanation.parts) {
    if (part.extent.empty())
      json["left_out"].push_back(part.name);
    else
      json["modelled"].push_back({{"name", part.name}, {"extent", part.extent}, {"seconds", part.seconds}});
  }
  return json;
}

std::string explanation_text(const Scene& scene, const Explanation& explanation) {
  const Settings& settings = scene.settings;
  std::string text;
  const auto say = [&](const std::string& line) { text += "  " + line + "\n"; };
  say(fmt::format(
      "method: {}, {}; {}", settings.method, find_method(settings.method)->title,
      scene.solve_given ? "chosen by the scene or the command line" : "the scene leaves it open"));
  say(fmt::format("a step takes {} here, a second of the scene {}", time_text(explanation.step_seconds),
                  time_text(explanation.step_seconds * pace_of(scene.model, settings))));
  say(fmt::format("{} masses are pinned, {} links are solved, {} lie between two pins and are not",
                  explanation.pins, explanation.links - explanation.links_between_pins,
                  explanation.links_between_pins));
  say(explanation.in_plane ? "all motion is in one plane, z = constant" : "motion is in three dimensions");
  std::vector<std::string> modelled, left_out;
  for (const PartCost& part : explanation.parts) {
    if (part.extent.empty()) {
      left_out.push_back(part.name);
      continue;
    }
    const double share = 100.0 * part.seconds / explanation.step_seconds;
    modelled.push_back(fmt::format(
        "  {:<16} {:<30} {}", part.name, part.extent,
        share < 1.0 ? "below 1 %" : fmt::format("{} ({:.0f} %)", time_text(part.seconds), share)));
  }
  if (!modelled.empty()) say("modelled, and what it costs a step (with it, less without it):");
  for (const std::string& line : modelled) say(line);
  if (!left_out.empty()) say(fmt::format("left out, at no cost: {}", fmt::join(left_out, ", ")));
  return text;
}

std::string reasons_text(const Plan& plan) {
  std::string text = "  how that was planned, from what theory and a few short runs say:\n";
  for (const std::string& reason : plan.reasons) text += "    " + reason + "\n";
  return text;
}

}  // namespace taut
