#include "measure/truth.h"

#include <algorithm>
#include <cmath>

#include "measure/measures.h"

namespace taut {
namespace {

double rigid_strain(const Model& model, const State& state) {
  double largest = 0.0;
  for (std::size_t i = 0; i < model.links.size(); ++i)
    if (model.links.rigid(i) && !state.broken(i))
      largest =
          std::max(largest, std::abs(link_distance(model, state.position, i) / model.links.length[i] - 1.0));
  return largest;
}

double strain_difference(const Model& model, const State& state, const State& truth) {
  double largest = 0.0;
  for (std::size_t i = 0; i < model.links.size(); ++i)
    largest = std::max(
        largest, std::abs(link_distance(model, state.position, i) - link_distance(model, truth.position, i)) /
                     model.links.length[i]);
  return largest;
}

double strain_error(const Model& model, const Truth& truth, const std::vector<State>& states) {
  double error = 0.0;
  if (has_rigid_links(model)) {
    for (const State& state : states) error = std::max(error, rigid_strain(model, state));
  } else if (truth.states.empty()) {
    error = std::abs(link_strain(model, states.back()).largest - truth.strain);
  } else {
    for (std::size_t i = 0; i < states.size(); ++i)
      error = std::max(error, strain_difference(model, states[i], truth.states[i]));
  }
  return error;
}

double energy_difference(const Model& model, const Truth& truth, const std::vector<State>& states) {
  if (truth.states.empty()) return std::abs(energy(model, states.back()).total() - truth.energy);
  double error = 0.0;
  for (std::size_t i = 0; i < states.size(); ++i)
    error =
        std::max(error, std::abs(energy(model, states[i]).total() - energy(model, truth.states[i]).total()));
  return error;
}

}  // namespace

bool has_rigid_links(const Model& model) {
  return std::ranges::any_of(model.links.stiffness, [](double k) { return k == infinity; });
}

std::string_view name_of(ErrorKind kind) {
  constexpr std::array<std::string_view, all_error_kinds.size()> names{"trajectory", "strain", "energy",
                                                                       "sag"};
  return names[static_cast<std::size_t>(kind)];
}

Truth truth_from(const Model& model, const State& start, const Reference& reference) {
  Truth truth;
  for (const State& state : reference.states) truth.times.push_back(state.time);
  truth.states = reference.states;
  truth.sag = sag(model, truth.states.back());
  truth.energy = energy(model, truth.states.back()).total();
  truth.strain = link_strain(model, truth.states.back()).largest;
  truth.how = reference.how;
  const double smallest = 100.0 * reference.uncertainty / scene_size(model, start);
  truth.smallest[ErrorKind::strain] = has_rigid_links(model) ? exact_length_limit : smallest;
  for (const ErrorKind kind : {ErrorKind::trajectory, ErrorKind::energy, ErrorKind::sag})
    truth.smallest[kind] = smallest;
  return truth;
}

Errors judge(const Model& model, const State& start, const Truth& truth, const std::vector<State>& states) {
  const double size = scene_size(model, start);
  Errors errors;
  if (truth.smallest[ErrorKind::trajectory]) {
    double distance = 0.0;
    for (std::size_t i = 0; i < states.size(); ++i)
      distance = std::max(distance, position_error(states[i], truth.states[i]));
    errors[ErrorKind::trajectory] = distance / size;
  }
  if (truth.smallest[ErrorKind::strain]) errors[ErrorKind::strain] = strain_error(model, truth, states);
  if (truth.smallest[ErrorKind::energy])
    errors[ErrorKind::energy] = energy_difference(model, truth, states) / energy_scale(model, start);
  if (truth.smallest[ErrorKind::sag])
    errors[ErrorKind::sag] = std::abs(sag(model, states.back()) - truth.sag) / size;
  return errors;
}

}  // namespace taut
