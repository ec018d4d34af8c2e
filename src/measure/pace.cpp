#include "measure/pace.h"

#include <algorithm>
#include <cmath>

#include "methods/registry.h"
#include "model/parts.h"

namespace taut {
namespace {

constexpr double order_of_chosen_steps = 8.0;

struct Scale {
  double length;  // m
  double time;    // s
};

Scale scale_of(const Model& model) {
  const double total = total_link_length(model);
  const double length = total > 0.0 ? total / static_cast<double>(model.links.size()) : 1.0;
  const double gravity = model.gravity.norm();
  return {length, gravity > 0.0 ? std::sqrt(length / gravity) : 1.0};
}

}  // namespace

double pace_of(const Model& model, const Settings& settings) {
  if (!settings.chooses_steps()) return settings.steps_per_second();
  const Scale scale = scale_of(model);
  return std::pow(scale.length / settings.number("tolerance"), 1.0 / order_of_chosen_steps) / scale.time;
}

void set_pace(const Model& model, Settings& settings, double steps_per_second) {
  if (!settings.chooses_steps()) {
    settings.values["steps_per_second"] = steps_per_second;
    return;
  }
  const Scale scale = scale_of(model);
  const Param& param = *find_param(*find_method(settings.method), "tolerance");
  settings.values["tolerance"] = std::clamp(
      scale.length * std::pow(steps_per_second * scale.time, -order_of_chosen_steps), param.min, param.max);
}

int order_in_step(const Settings& settings) {
  if (settings.chooses_steps()) return static_cast<int>(order_of_chosen_steps);
  if (settings.method != "rattle" && settings.method != "shake") return 1;
  return settings.values.contains("order") && settings.choice("order") == "4" ? 4 : 2;
}

}  // namespace taut
