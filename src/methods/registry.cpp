#include "methods/registry.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/failure.h"
#include "base/memory.h"
#include "base/nearest.h"

namespace taut {

// One file and two lines here for each method: its declaration, and its place in the list.
Method euler_method();
Method verlet_method();
Method xpbd_method();
Method shake_method();
Method rattle_method();
Method dop853_method();
Method newton_method();
Method spring_explicit_method();
Method spring_implicit_method();

std::span<const Method> all_methods() {
  static const std::array methods{
      euler_method(),  verlet_method(),          xpbd_method(),
      shake_method(),  rattle_method(),          dop853_method(),
      newton_method(), spring_explicit_method(), spring_implicit_method(),
  };
  return methods;
}

const Method* find_method(std::string_view name) {
  for (const Method& method : all_methods())
    if (method.name == name) return &method;
  return nullptr;
}

const Param* find_param(const Method& method, std::string_view name) {
  for (const Param& param : method.params)
    if (param.name == name) return &param;
  return nullptr;
}

std::string param_problem(const Param& param, const std::variant<double, std::string>& value) {
  if (!param.choices.empty()) {
    const auto* word = std::get_if<std::string>(&value);
    for (const std::string_view choice : param.choices)
      if (word != nullptr && *word == choice) return {};
    return fmt::format("{} must be one of {}", param.name, fmt::join(param.choices, ", "));
  }
  const auto* number = std::get_if<double>(&value);
  if (number == nullptr) return fmt::format("{} must be a number", param.name);
  if (!(*number >= param.min && *number <= param.max))
    return fmt::format("{} must be from {} to {}{}{}, not {}", param.name, param.min, param.max,
                       param.unit.empty() ? "" : " ", param.unit, *number);
  if (param.whole && *number != std::floor(*number))
    return fmt::format("{} must be a whole number, not {}", param.name, *number);
  return {};
}

namespace {

template <typename Range>
std::string did_you_mean(std::string_view word, const Range& entries) {
  std::vector<std::string_view> names;
  for (const auto& entry : entries) names.push_back(entry.name);
  const std::string_view nearest = nearest_name(word, names);
  return nearest.empty() ? fmt::format("; there are {}", fmt::join(names, ", "))
                         : fmt::format("; did you mean \"{}\"?", nearest);
}

// The names of the methods that have a capability, for an error that helps on.
template <typename Can>
std::string methods_that(Can can) {
  std::vector<std::string_view> names;
  for (const Method& method : all_methods())
    if (can(method.can)) names.push_back(method.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

// What a machine can't hold of what a method solves all together.
std::string memory_problem(const Model& model, const Method& method) {
  constexpr double always_there = 1e8;  // bytes
  const double bytes = memory_of_step(method, model);
  if (bytes < always_there) return {};
  const double left = memory_left();
  if (bytes < 0.8 * left) return {};
  return fmt::format(
      "method \"{}\" solves all links together, which takes about {} of memory for so large a net; of what "
      "this machine has, {} are left; use xpbd",
      method.name, format_bytes(bytes), format_bytes(left));
}

}  // namespace

const Method& method_called(std::string_view name) {
  const Method* method = find_method(name);
  if (method == nullptr)
    throw BadRequest(fmt::format("unknown method \"{}\"{}", name, did_you_mean(name, all_methods())));
  return *method;
}

Settings complete_settings(const Settings& given) {
  return complete_settings(method_called(given.method), given);
}

Settings complete_settings(const Method& method, const Settings& given) {
  for (const auto& [name, value] : given.values) {
    const Param* param = find_param(method, name);
    if (param == nullptr)
      throw BadRequest(fmt::format("method \"{}\" has no parameter \"{}\"{}", method.name, name,
                                   did_you_mean(name, method.params)));
    if (const std::string problem = param_problem(*param, value); !problem.empty()) throw BadRequest(problem);
  }
  Settings complete = given;
  complete.method = method.name;
  for (const Param& param : method.params) {
    if (const auto leader = given.values.find(param.follows); leader != given.values.end())
      complete.values.try_emplace(std::string(param.name), leader->second);
    else if (param.choices.empty())
      complete.values.try_emplace(std::string(param.name), param.fallback);
    else
      complete.values.try_emplace(std::string(param.name), std::string(param.choices.front()));
  }
  return complete;
}

double memory_of_step(const Method& method, const Model& model) {
  return method.memory == nullptr ? 0.0 : method.memory(model);
}

std::vector<std::string> capability_problems(const Model& model, const Method& method) {
  bool soft = false, rigid = false, stretch = false, tension = false;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    (model.links.rigid(i) ? rigid : soft) = true;
    stretch = stretch || model.links.break_stretch[i] < infinity;
    tension = tension || model.links.break_tension[i] < infinity;
  }
  std::vector<std::string> problems;
  const auto need = [&](bool needed, bool Capabilities::*can, std::string_view what) {
    if (needed && !(method.can.*can))
      problems.push_back(fmt::format("method \"{}\" has no {}; these have: {}", method.name, what,
                                     methods_that([can](const Capabilities& c) { return c.*can; })));
  };
  need(soft, &Capabilities::stiffness, "links with stiffness");
  need(rigid, &Capabilities::rigid, "rigid links (without stiffness)");
  const bool only_ground = touches_only_ground(model);
  need(!model.contacts.empty() && only_ground, &Capabilities::ground, "ground plane");
  need(limits_angles(model), &Capabilities::limits, "limits on angles");
  need(has_one_sided_links(model), &Capabilities::one_sided, "links that act one way only");
  need(!model.bends.empty(), &Capabilities::bending, "bending stiffness");
  if (model.limits.size() > method.can.most_limits)
    problems.push_back(fmt::format(
        "method \"{}\" solves stops and links that act one way only all together, in memory and time that "
        "grow as the square and the cube of how many there are: {}, and {} is the most; use xpbd, verlet or "
        "shake",
        method.name, model.limits.size(), method.can.most_limits));
  need(!model.joints.empty(), &Capabilities::joints, "joints with damping or friction");
  need(!only_ground, &Capabilities::colliders,
       "solids but planes that stay and have no rebound, or bodies that touch");
  need(!model.faces.empty(), &Capabilities::faces, "faces that touch");
  need(model.drag > 0.0, &Capabilities::drag, "drag");
  need(stretch, &Capabilities::break_stretch, "breaking by stretch");
  need(tension, &Capabilities::break_tension, "breaking by tension");
  return problems;
}

std::vector<std::string> refusals(const Model& model, const State& start, const Settings& settings) {
  return refusals(*find_method(settings.method), model, start, settings);
}

std::vector<std::string> refusals(const Method& method, const Model& model, const State& start,
                                  const Settings& settings) {
  std::vector<std::string> problems = capability_problems(model, method);
  if (std::string problem = memory_problem(model, method); !problem.empty())
    problems.push_back(std::move(problem));
  if (problems.empty() && method.refusal != nullptr)
    if (std::string problem = method.refusal(model, start, settings); !problem.empty())
      problems.push_back(std::move(problem));
  return problems;
}

}  // namespace taut
