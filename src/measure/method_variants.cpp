#include "measure/method_variants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "measure/pace.h"
#include "methods/registry.h"
#include "model/parts.h"

namespace taut {
namespace {

// Whether it matters how many passes the method makes: not where links with stiffness are all there is, and
// the method knows them as forces.
bool relaxes(const Model& model, const Method& method) {
  const bool springs_are_forces = method.can.limit == StepLimit::sideways_vibration;
  return find_param(method, "passes") != nullptr &&
         (!springs_are_forces || has_rigid_links(model) || !model.limits.empty());
}

// How xpbd relaxes links is the scene's choice: plans leave it at one by one.
constexpr std::string_view scene_chooses = "relax";

// All combinations of a method's worded parameters, the method's default first; of what a scene chooses only
// each other choice beside the defaults of all else.
std::vector<MethodVariant> variants(const Model& model, const Method& method, std::size_t place,
                                    Choices choices) {
  MethodVariant plain;
  plain.name = method.name;
  plain.settings = complete_settings({std::string(method.name), {}});
  plain.can = method.can;
  plain.method = place;
  if (method.can.chooses_steps)
    plain.finer = {"tolerance", 1e-2, 0.1, 12};  // to 1e-13 m
  else
    plain.finer = {"steps_per_second", 60.0, 2.0, 15};  // to 983,040
  if (relaxes(model, method)) plain.passes = ChartAxis{"passes", 1.0, 4.0, 5};
  std::vector<MethodVariant> curves{plain};
  for (const Param& param : method.params) {
    if (param.choices.empty() || param.name == scene_chooses) continue;
    std::vector<MethodVariant> chosen;
    for (const MethodVariant& curve : curves)
      for (const std::string_view choice : param.choices) {
        chosen.push_back(curve);
        chosen.back().settings.values[std::string(param.name)] = std::string(choice);
        // A word says what it means; a number needs its name.
        const bool number = choice.find_first_not_of("0123456789") == std::string_view::npos;
        chosen.back().name += number ? fmt::format(" {} {}", param.name, choice) : fmt::format(" {}", choice);
      }
    curves = std::move(chosen);
  }
  if (const Param* chosen = find_param(method, scene_chooses);
      chosen != nullptr && choices == Choices::charted)
    for (const std::string_view choice : std::span(chosen->choices).subspan(1)) {
      curves.push_back(curves.front());
      curves.back().settings.values[std::string(chosen->name)] = std::string(choice);
      curves.back().name += fmt::format(" {}", choice);
    }
  return curves;
}

// Why the method refuses the model even with the finest steps; empty when it doesn't.
std::string refusal(const Model& model, const State& start, const Method& method,
                    const MethodVariant& curve) {
  const Param* steps = find_param(method, "steps_per_second");
  const std::vector<std::string> problems =
      refusals(model, start, steps == nullptr ? curve.settings : settings_at(model, curve, steps->max, 1));
  return problems.empty() ? std::string() : problems.front();
}

void require_known(const std::vector<std::string>& methods) {
  for (const std::string& name : methods) complete_settings({name, {}});
}

}  // namespace

MethodVariants variants_of(const Model& model, const State& start, const std::vector<std::string>& methods,
                           Choices choices) {
  require_known(methods);
  MethodVariants result;
  for (std::size_t place = 0; place < all_methods().size(); ++place) {
    const Method& method = all_methods()[place];
    if (!methods.empty() && std::ranges::find(methods, method.name) == methods.end()) {
      result.omissions.push_back(fmt::format("{} was not asked for", method.name));
      continue;
    }
    if (const auto problems = capability_problems(model, method); !problems.empty()) {
      // From `method "x" has no y; these have: …`
      const std::string& first = problems.front();
      const std::size_t what = std::min(first.find("has no"), first.size());
      result.omissions.push_back(
          fmt::format("{} {}", method.name, first.substr(what, first.find(';') - what)));
      continue;
    }
    for (MethodVariant& curve : variants(model, method, place, choices)) {
      if (const std::string problem = refusal(model, start, method, curve); !problem.empty())
        result.omissions.push_back(fmt::format("{}: {}", curve.name, problem));
      else
        result.variants.push_back(std::move(curve));
    }
  }
  return result;
}

Settings settings_at(const Model& model, const MethodVariant& variant, double steps_per_second, int passes) {
  Settings settings = variant.settings;
  set_pace(model, settings, steps_per_second);
  if (variant.relaxes()) settings.values["passes"] = static_cast<double>(passes);
  return settings;
}

Settings settings_at_place(const MethodVariant& variant, int fineness, int row) {
  Settings settings = variant.settings;
  settings.values[variant.finer.param] = variant.finer.value(fineness);
  if (variant.passes) settings.values[variant.passes->param] = variant.passes->value(row);
  return settings;
}

double ChartAxis::value(int place) const {
  return first * std::pow(ratio, place);
}

}  // namespace taut
