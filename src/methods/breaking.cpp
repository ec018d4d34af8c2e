#include "methods/breaking.h"

#include <algorithm>

namespace taut {
namespace {

// Links that pass within this share of a step of each other pass at once: symmetric ones differ by rounding.
constexpr double at_once = 1e-9;

// Where a quantity that goes from one value to another passes a threshold, as a share of the way; infinity
// where it does not end over it.
double passing(double before, double after, double threshold) {
  if (!(after > threshold)) return infinity;
  return before >= threshold ? 0.0 : (threshold - before) / (after - before);
}

double share_of(const Model& model, const State& before, const State& after, Index link) {
  const double by_tension =
      passing(before.tension[link], after.tension[link], model.links.break_tension[link]);
  const double longest = model.links.break_stretch[link] * model.links.length[link];
  if (longest == infinity) return by_tension;
  return std::min(by_tension, passing(link_distance(model, before.position, link),
                                      link_distance(model, after.position, link), longest));
}

}  // namespace

std::optional<FirstBreak> first_break(const Model& model, const State& before, const State& after) {
  std::vector<double> shares;
  double first = infinity;
  for (const Index link : model.breakable_links) {
    shares.push_back(after.broken(link) ? infinity : share_of(model, before, after, link));
    first = std::min(first, shares.back());
  }
  if (first == infinity) return std::nullopt;
  FirstBreak result{first, {}};
  for (std::size_t i = 0; i < shares.size(); ++i)
    if (shares[i] <= first + at_once) result.links.push_back(model.breakable_links[i]);
  return result;
}

void break_at_once(const Model& model, State& state, const std::vector<Index>& links) {
  answer_kick(model, state, state.velocity);
  state.unanswered_kick = 0.0;
  state.tension_before.clear();
  state.own_steps.settled = false;
  for (const Index link : links) {
    state.broken_at[link] = state.time;
    state.tension[link] = 0.0;
  }
}

void answer_kick(const Model& model, const State& state, Vectors& velocity) {
  if (state.unanswered_kick == 0.0) return;
  for (std::size_t link = 0; link < model.links.size(); ++link) {
    if (!model.links.rigid(link) || state.broken(link)) continue;
    const Index a = model.links.a[link], b = model.links.b[link];
    const Vec3 direction = (state.position.at(a) - state.position.at(b)).normalized();
    const Vec3 impulse = direction * (state.unanswered_kick * state.tension[link]);
    velocity.add(a, -model.masses.inverse_mass[a] * impulse);
    velocity.add(b, model.masses.inverse_mass[b] * impulse);
  }
}

}  // namespace taut
