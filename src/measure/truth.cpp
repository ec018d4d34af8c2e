#include "measure/truth.h"

#include <algorithm>
#include <cmath>

#include "model/measures.h"
#include "model/parts.h"

namespace taut {
namespace {

double rigid_strain(const Model& model, const State& state) {
  double largest = 0.0;
  for (std::size_t i = 0; i < model.links.size(); ++i)
    if (model.links.rigid(i) && !state.broken(i))
      largest = std::max(largest, std::abs(model.links.strain(i, link_distance(model, state.position, i))));
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

// A number at a time against what it should be there, the largest difference over all times.
template <class Number>
double largest_difference(std::span<const State> states, std::span<const State> truth, const Number& number) {
  double largest = 0.0;
  for (std::size_t i = 0; i < states.size(); ++i)
    largest = std::max(largest, std::abs(number(states[i]) - number(truth[i])));
  return largest;
}

double strain_error(const Model& model, std::span<const State> states, std::span<const State> truth) {
  double error = 0.0;
  for (std::size_t i = 0; i < states.size(); ++i)
    error = std::max(error, has_rigid_links(model) ? rigid_strain(model, states[i])
                                                   : strain_difference(model, states[i], truth[i]));
  return error;
}

// What summaries can judge.
double error_of_summaries(const Model& model, const State& start, const Truth& truth, ErrorKind kind,
                          const std::vector<State>& states) {
  if (kind == ErrorKind::strain && has_rigid_links(model)) return strain_error(model, states, {});
  double error = 0.0;
  for (std::size_t i = 0; i < states.size(); ++i)
    error =
        std::max(error, *difference(model, start, summary_of(model, states[i]), truth.summaries[i])[kind]);
  return error;
}

}  // namespace

Summary summary_of(const Model& model, const State& state) {
  return {sag(model, state), energy(model, state).total(), link_strain(model, state).largest};
}

Errors difference(const Model& model, const State& start, const Summary& a, const Summary& b) {
  Errors errors;
  errors[ErrorKind::sag] = std::abs(a.sag - b.sag) / scene_size(model, start);
  errors[ErrorKind::energy] = std::abs(a.energy - b.energy) / energy_scale(model, start);
  errors[ErrorKind::strain] = std::abs(a.strain - b.strain);
  return errors;
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
  truth.certified = true;
  for (const State& state : truth.states) truth.summaries.push_back(summary_of(model, state));
  truth.how = reference.how;
  const double smallest = 100.0 * reference.uncertainty / scene_size(model, start);
  truth.smallest[ErrorKind::strain] = has_rigid_links(model) ? exact_length_limit : smallest;
  for (const ErrorKind kind : {ErrorKind::trajectory, ErrorKind::energy, ErrorKind::sag})
    truth.smallest[kind] = smallest;
  return truth;
}

double error_against(const Model& model, const State& start, ErrorKind kind, std::span<const State> states,
                     std::span<const State> truth) {
  switch (kind) {
    case ErrorKind::trajectory: {
      double distance = 0.0;
      for (std::size_t i = 0; i < states.size(); ++i)
        distance = std::max(distance, position_error(states[i], truth[i]));
      return distance / scene_size(model, start);
    }
    case ErrorKind::strain:
      return strain_error(model, states, truth);
    case ErrorKind::energy:
      return largest_difference(states, truth,
                                [&](const State& state) { return energy(model, state).total(); }) /
             energy_scale(model, start);
    case ErrorKind::sag:
      return largest_difference(states, truth, [&](const State& state) { return sag(model, state); }) /
             scene_size(model, start);
  }
  return infinity;
}

Errors judge(const Model& model, const State& start, const Truth& truth, const std::vector<State>& states) {
  Errors errors;
  for (const ErrorKind kind : all_error_kinds)
    if (truth.smallest[kind])
      errors[kind] = truth.states.empty() ? error_of_summaries(model, start, truth, kind, states)
                                          : error_against(model, start, kind, states, truth.states);
  return errors;
}

}  // namespace taut
