// XPBD, extended position-based dynamics, in small steps (Macklin, Müller and Chentanez, XPBD: Position-Based
// Simulation of Compliant Constrained Dynamics, 2016; Macklin et al., Small Steps in Physics Simulation,
// 2019).
//
//   v ← v + h a,  x ← x + h v                           gravity and loads; drag implicit
//   `passes` times, for each link with C = |d| − l, unit gradient n = d/|d| at a and −n at b (2016, eq. 18
//   and 26):
//     Δλ = (−C − α̃ λ − γ n·((x_a − x_a⁰) − (x_b − x_b⁰))) / ((1 + γ)(w_a + w_b) + α̃)
//     x_a ← x_a + w_a Δλ n,  x_b ← x_b − w_b Δλ n,  λ ← λ + Δλ
//   v ← Δx/h
//
// Drag is implicit in all forces, those of the links too: a mass answers them with w/(1 + h·drag) in place of
// w. α̃ = α/h² with the compliance α = 1/k; γ = α̃ β̃/h = α c/h with the damping c (β̃ = h² c). A rigid link has
// α = 0, and so no damping. The tension of a link is −λ/h². Links go colour by colour: in file order, one
// pass a step without damping runs to infinity on a large sheet.

#include <array>
#include <cmath>
#include <utility>

#include "forces.h"
#include "link_order.h"
#include "methods/method.h"
#include "parameters.h"

namespace taut {
namespace {

// What a pass reads of each link, side by side in the order of the visits.
struct VisitedLink {
  Index a, b;
  double length;
  double weight_a, weight_b;  // inverse masses
  double compliance;          // m/N
  double damping;             // N s/m
};

class XpbdStepper final : public Stepper {
 public:
  XpbdStepper(const Model& model, int passes) : model_(model), passes_(passes) {}

  void links_changed(const State& state) override {
    order_ = coloured_order(model_, state);
    visited_.clear();
    compliant_ = damped_ = false;
    for (const Index link : order_.links) {
      const Index a = model_.links.a[link], b = model_.links.b[link];
      visited_.push_back({a, b, model_.links.length[link], model_.masses.inverse_mass[a],
                          model_.masses.inverse_mass[b], model_.links.compliance(link),
                          model_.links.damping[link]});
      compliant_ = compliant_ || !model_.links.rigid(link);
      damped_ = damped_ || model_.links.damping[link] > 0.0;
    }
    multipliers_.assign(visited_.size(), 0.0);
  }

  StepReport step(State& state, double h) override {
    const double start_time = state.time, end_time = state.time + h;
    start_ = state.position;
    velocity_ = state.velocity;
    kick(model_, end_time, h, state.velocity, velocity_);
    drift(h, start_, velocity_, state.position);
    place_pins(model_, end_time, state.position, velocity_);
    multipliers_.assign(visited_.size(), 0.0);
    for (int pass = 0; pass < passes_; ++pass) {
      solve_all(state.position, h);
      if (model_.plane) keep_out_of_plane(*model_.plane, model_.masses, start_, state.position);
    }
    StepReport report;
    report.rounds = passes_;
    report.link_solves = static_cast<std::int64_t>(visited_.size()) * passes_;
    difference_quotient(h, start_, state.position, velocity_);
    place_pins(model_, end_time, state.position, velocity_);
    std::swap(state.velocity, velocity_);
    state.time = end_time;
    if (!all_finite(state)) {
      std::swap(state.position, start_);
      std::swap(state.velocity, velocity_);
      state.time = start_time;
      report.status = StepStatus::not_finite;
      return report;
    }
    for (std::size_t i = 0; i < visited_.size(); ++i)
      state.tension[order_.links[i]] = -multipliers_[i] / (h * h);
    return report;
  }

 private:
  // The loop without what no link of the scene has.
  void solve_all(Vectors& position, double h) {
    if (damped_)
      solve<true, true>(position, h);
    else if (compliant_)
      solve<true, false>(position, h);
    else
      solve<false, false>(position, h);
  }

  template <bool compliant, bool damped>
  void solve(Vectors& position, double h) {
    const double inverse_h = 1.0 / h;
    const double answer = 1.0 / (1.0 + h * model_.drag);
    for (std::size_t i = 0; i < visited_.size(); ++i) {
      const VisitedLink& link = visited_[i];
      const Vec3 difference = position.at(link.a) - position.at(link.b);
      const double distance = difference.norm();
      if (distance == 0.0) continue;  // no direction to move in
      const Vec3 gradient = difference / distance;
      double numerator = link.length - distance;
      double denominator = answer * (link.weight_a + link.weight_b);
      if constexpr (compliant) {
        const double scaled = link.compliance * inverse_h * inverse_h;
        numerator -= scaled * multipliers_[i];
        if constexpr (damped) {
          const double gamma = link.compliance * link.damping * inverse_h;
          const Vec3 moved = difference - (start_.at(link.a) - start_.at(link.b));
          numerator -= gamma * gradient.dot(moved);
          denominator *= 1.0 + gamma;
        }
        denominator += scaled;
      }
      const double change = numerator / denominator;
      multipliers_[i] += change;
      const Vec3 shift = (answer * change) * gradient;
      position.add(link.a, link.weight_a * shift);
      position.add(link.b, -link.weight_b * shift);
    }
  }

  const Model& model_;
  int passes_;
  OrderedLinks order_;
  std::vector<VisitedLink> visited_;
  bool compliant_ = false, damped_ = false;
  std::vector<double> multipliers_;  // λ, kg m
  Vectors start_, velocity_;
};

constexpr std::array params{steps_per_second_param(600.0), passes_param(1.0)};

std::unique_ptr<Stepper> make(const Model& model, const Settings& settings) {
  return std::make_unique<XpbdStepper>(model, static_cast<int>(settings.number("passes")));
}

}  // namespace

Method xpbd_method() {
  Capabilities can;
  can.stiffness = true;
  can.plane = true;
  can.break_stretch = true;
  can.break_tension = true;
  return {"xpbd",
          "compliant position-based dynamics in small steps",
          "Macklin et al., XPBD (2016); Small Steps in Physics Simulation (2019)",
          params,
          can,
          make};
}

}  // namespace taut
