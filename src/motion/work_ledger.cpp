#include "motion/work_ledger.h"

namespace taut {

WorkLedger::WorkLedger(const Model& model, const State& start) : model_(model), last_time_(start.time) {
  std::vector<bool> driven(model.masses.size(), false);
  for (const DrivenPin& pin : model.driven_pins) driven[pin.mass] = true;
  for (const Index link : solvable_links(model)) {
    const Index a = model.links.a[link], b = model.links.b[link];
    if (!driven[a] && !driven[b]) continue;
    PinLink pin_link{link, driven[a] ? a : b, driven[a] ? b : a, Vec3::Zero()};
    pin_link.pull = pull_of(pin_link, start);
    pin_links_.push_back(pin_link);
    last_pin_position_.push_back(start.position.at(pin_link.pin));
  }
  for (const Load& load : model.loads) {
    auto& places = last_load_position_.emplace_back();
    for (const Index mass : load.masses) places.push_back(start.position.at(mass));
  }
  for (const Index link : model.breakable_links) was_broken_.push_back(start.broken(link));
}

Vec3 WorkLedger::pull_of(const PinLink& pin_link, const State& state) const {
  if (state.broken(pin_link.link)) return Vec3::Zero();
  const Vec3 towards_pin = state.position.at(pin_link.pin) - state.position.at(pin_link.other);
  return towards_pin.normalized() * state.tension[pin_link.link];
}

void WorkLedger::record(const State& state) {
  // The pin moves the mass at the other end by its pull; the mean pull over the step along the pin's way.
  for (std::size_t i = 0; i < pin_links_.size(); ++i) {
    const Vec3 pull = pull_of(pin_links_[i], state);
    const Vec3 place = state.position.at(pin_links_[i].pin);
    pins_ += 0.5 * (pull + pin_links_[i].pull).dot(place - last_pin_position_[i]);
    pin_links_[i].pull = pull;
    last_pin_position_[i] = place;
  }
  for (std::size_t i = 0; i < model_.loads.size(); ++i) {
    const Load& load = model_.loads[i];
    const Vec3 force = load.force * load.share(0.5 * (last_time_ + state.time));
    for (std::size_t j = 0; j < load.masses.size(); ++j) {
      const Vec3 place = state.position.at(load.masses[j]);
      if (!model_.masses.pinned(load.masses[j])) loads_ += force.dot(place - last_load_position_[i][j]);
      last_load_position_[i][j] = place;
    }
  }
  for (std::size_t i = 0; i < was_broken_.size(); ++i) {
    const Index link = model_.breakable_links[i];
    if (was_broken_[i] || !state.broken(link)) continue;
    was_broken_[i] = true;
    if (model_.links.rigid(link)) continue;
    const double stretch = link_distance(model_, state.position, link) - model_.links.length[link];
    broken_ += 0.5 * model_.links.stiffness[link] * stretch * stretch;
  }
  last_time_ = state.time;
}

}  // namespace taut
