#pragma once

#include <stdexcept>
#include <string>

#include "methods/registry.h"
#include "model/description.h"
#include "motion/run.h"

namespace taut::bench {

inline Built build_valid(const Description& description) {
  Built built = build(description);
  if (!built.problems.empty()) throw std::runtime_error(built.problems.front().message);
  return built;
}

inline Settings settings(std::string method, double steps_per_second) {
  return {std::move(method), {{"steps_per_second", steps_per_second}}};
}

/// Makes steps that must all be solved.
inline StepReport simulate_all(const Model& model, State& state, const Settings& how, std::int64_t steps) {
  Run run(model, state, how);
  while (run.steps() < steps)
    if (!run.step()) throw std::runtime_error(run.failure());
  state = run.state();
  return run.report().counts;
}

/// A level chain of equal masses of 1 kg, first one pinned, released at rest.
inline Description level_chain(int links, double link_length, double last_mass = 0.0) {
  ChainSpec chain;
  chain.name = "rope";
  chain.to = {links * link_length, 0.0, 0.0};
  chain.links = links;
  chain.mass = links + 1.0;
  chain.last_mass = last_mass;
  chain.pinned = {"first"};
  Description description;
  description.chains = {chain};
  return description;
}

/// A chain 2 m across that hangs in an arc, and swings.
inline Description swinging_chain(int links) {
  Description description = level_chain(links, 2.0 / links);
  description.chains[0].length = 2.2;
  return description;
}

/// A net that hangs by a corner.
inline Description hung_net(int side) {
  SheetSpec sheet;
  sheet.name = "net";
  sheet.rows = sheet.columns = side;
  sheet.to = {1.0, 0.0, 0.0};
  sheet.down = {0.0, -0.7, 0.7};
  sheet.pinned = {"top-left"};
  Description description;
  description.sheets = {sheet};
  return description;
}

}  // namespace taut::bench
