#include "motion/work_ledger.h"

#include <algorithm>
#include <cmath>

namespace taut {

WorkLedger::WorkLedger(const Model& model, const State& state, const Work& before)
    : model_(&model), work_(before) {
  std::vector<bool> driven(model.masses.size(), false);
  for (const DrivenPin& pin : model.driven_pins) driven[pin.mass] = true;
  for (const Index link : links_with_a_free_end(model)) {
    const Index a = model.links.a[link], b = model.links.b[link];
    if (driven[a] || driven[b])
      pin_links_.push_back({link, driven[a] ? a : b, driven[a] ? b : a, Vec3::Zero()});
  }
  breakable_springs_ =
      std::ranges::any_of(model.breakable_links, [&](Index link) { return !model.links.rigid(link); });
  look(state);
}

Watched WorkLedger::watched() const {
  Watched watched;
  for (const DrivenPin& pin : model_->driven_pins) watched.masses.push_back(pin.mass);
  for (const PinLink& link : pin_links_) {
    watched.masses.push_back(link.pin);
    watched.masses.push_back(link.other);
    watched.links.push_back(link.link);
  }
  for (const Load& load : model_->loads)
    watched.masses.insert(watched.masses.end(), load.masses.begin(), load.masses.end());
  return watched;
}

Vec3 WorkLedger::pull_of(const PinLink& pin_link, const State& state) const {
  if (state.broken(pin_link.link)) return Vec3::Zero();
  const Vec3 towards_pin = state.position.at(pin_link.pin) - state.position.at(pin_link.other);
  return towards_pin.normalized() * state.tension[pin_link.link];
}

Work WorkLedger::until(const State& state) const {
  Work work = work_;
  const auto add = [&](double& sum, double done) {
    sum += done;
    work.throughput += std::abs(done);
  };
  for (const DrivenPin& pin : model_->driven_pins)
    work.fastest_pin = std::max(work.fastest_pin, state.velocity.at(pin.mass).norm());
  // The pin moves the mass at the other end by its pull; the mean pull over the step along the pin's way.
  for (std::size_t i = 0; i < pin_links_.size(); ++i) {
    const Vec3 pull = pull_of(pin_links_[i], state);
    const Vec3 way = state.position.at(pin_links_[i].pin) - last_pin_position_[i];
    add(work.pins, 0.5 * (pull + pin_links_[i].pull).dot(way));
  }
  for (std::size_t i = 0; i < model_->loads.size(); ++i) {
    const Load& load = model_->loads[i];
    const Vec3 force = load.force * load.share(0.5 * (last_time_ + state.time));
    for (std::size_t j = 0; j < load.masses.size(); ++j)
      if (!model_->masses.pinned(load.masses[j]))
        add(work.loads, force.dot(state.position.at(load.masses[j]) - last_load_position_[i][j]));
  }
  for (std::size_t i = 0; i < was_broken_.size(); ++i) {
    const Index link = model_->breakable_links[i];
    if (was_broken_[i] || !state.broken(link) || model_->links.rigid(link)) continue;
    const double stretch = model_->links.stretch(link, link_distance(*model_, state.position, link));
    add(work.broken, 0.5 * model_->links.stiffness[link] * stretch * stretch);
  }
  return work;
}

void WorkLedger::record(const State& state) {
  work_ = until(state);
  look(state);
}

void WorkLedger::record(const std::vector<State>& states) {
  std::vector<Work> sums;  // from one long part to many short ones
  for (std::size_t stride = states.size(); stride > 0; stride /= 2) {
    WorkLedger ledger = *this;
    for (std::size_t i = stride; i <= states.size(); i += stride) ledger.record(states[i - 1]);
    sums.push_back(ledger.work_);
  }
  const auto extrapolate = [&](double Work::*part) {
    for (std::size_t level = 1; level < sums.size(); ++level)
      for (std::size_t i = sums.size() - 1; i >= level; --i)
        sums[i].*part +=
            (sums[i].*part - sums[i - 1].*part) / (std::pow(4.0, static_cast<double>(level)) - 1.0);
  };
  extrapolate(&Work::pins);
  extrapolate(&Work::loads);
  work_ = sums.back();
  look(states.back());
}

void WorkLedger::add_contacts(double work) {
  work_.contacts += work;
  work_.throughput += std::abs(work);
}

// Remembers what the next step's work is reckoned from.
void WorkLedger::look(const State& state) {
  last_pin_position_.clear();
  for (PinLink& pin_link : pin_links_) {
    pin_link.pull = pull_of(pin_link, state);
    last_pin_position_.push_back(state.position.at(pin_link.pin));
  }
  last_load_position_.resize(model_->loads.size());
  for (std::size_t i = 0; i < model_->loads.size(); ++i) {
    last_load_position_[i].clear();
    for (const Index mass : model_->loads[i].masses)
      last_load_position_[i].push_back(state.position.at(mass));
  }
  was_broken_.clear();
  for (const Index link : model_->breakable_links) was_broken_.push_back(state.broken(link));
  last_time_ = state.time;
}

}  // namespace taut
