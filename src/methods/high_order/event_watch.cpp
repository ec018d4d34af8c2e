#include "high_order/event_watch.h"

#include <algorithm>

#include "model/parts.h"

namespace taut {
namespace {

constexpr double at_once = 1e-9;  // of a threshold: links so near to it break together
// How far beyond its end an angle is where its stop counts as met, and how far inside where a soft one counts
// as left (rad): more than rounding, far less than anyone can tell.
constexpr double met = 1e-12;
// What a held stop may pull with before it is left, as a share of the torque of all weight at a link's end:
// what rounding leaves of a stop that pushes with nothing.
constexpr double no_pull = 1e-12;

}  // namespace

EventWatch::EventWatch(const Model& model)
    : model_(model),
      slack_(no_pull * free_mass(model) * std::max(1.0, model.gravity.norm()) *
             std::max(1.0, total_link_length(model)) /
             std::max<double>(1.0, static_cast<double>(model.links.size()))) {}

void EventWatch::begin(const State& state) {
  links_.clear();
  for (const Index link : model_.breakable_links)
    if (!state.broken(link)) links_.push_back(link);
  held_ = state.own_steps.held;
  let_go_.clear();
  for (const Limit& limit : model_.limits) let_go_.push_back(let_go(limit, state));
}

double EventWatch::past_break(const Vectors& position, Index link) const {
  const double by_tension = tension_[link] / model_.links.break_tension[link] - 1.0;
  const double longest = model_.links.break_stretch[link] * model_.links.length[link];
  if (longest == infinity) return by_tension;
  return std::max(by_tension, link_distance(model_, position, link) / longest - 1.0);
}

double EventWatch::past_limit(const Vectors& position, std::size_t index) const {
  const Limit& limit = model_.limits[index];
  const double angle = limit_angle(limit, position);
  double past = -infinity;
  for (const double sign : {1.0, -1.0}) {
    if (!has_stop(limit, sign)) continue;
    const bool held = std::ranges::find(held_, HeldStop{static_cast<Index>(index), sign}) != held_.end();
    const double excess = excess_at(limit, angle, sign);
    if (!held)
      past = std::max(past, excess - met);
    else if (limit.compliance > 0.0)
      past = std::max(past, -excess - met);
  }
  return past;
}

double EventWatch::past(const Vectors& position, const Equations& equations) {
  double past = -infinity;
  if (!links_.empty()) equations.write_tensions(tension_);
  for (const Index link : links_) past = std::max(past, past_break(position, link));
  for (std::size_t i = 0; i < model_.limits.size(); ++i)
    if (!let_go_[i]) past = std::max(past, past_limit(position, i));
  for (const double push : equations.pushes()) past = std::max(past, -push - slack_);
  return past;
}

std::vector<Index> EventWatch::breaking(const Vectors& position, const Equations& equations) {
  std::vector<Index> links;
  if (links_.empty()) return links;
  equations.write_tensions(tension_);
  std::ranges::copy_if(links_, std::back_inserter(links),
                       [&](Index link) { return past_break(position, link) > -at_once; });
  return links;
}

}  // namespace taut
