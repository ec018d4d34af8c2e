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
  double inverse_weight;      // 1/(w_a + w_b)
};

// What it reads of links that have it.
struct Softness {
  double compliance;  // m/N
  double damping;     // N s/m
};

class XpbdStepper final : public Stepper {
 public:
  XpbdStepper(const Model& model, int passes) : model_(model), passes_(passes) {}

  void links_changed(const State& state) override {
    order_ = coloured_order(model_, state);
    visited_.clear();
    softness_.clear();
    compliant_ = damped_ = false;
    for (const Index link : order_.links) {
      const Index a = model_.links.a[link], b = model_.links.b[link];
      const double weight_a = model_.masses.inverse_mass[a], weight_b = model_.masses.inverse_mass[b];
      visited_.push_back({a, b, model_.links.length[link], weight_a, weight_b, 1.0 / (weight_a + weight_b)});
      softness_.push_back({model_.links.compliance(link), model_.links.damping[link]});
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

  // Plain numbers, coordinate by coordinate: packed into vectors of three the loop takes a seventh longer.
  template <bool compliant, bool damped>
  void solve(Vectors& position, double h) {
    [[maybe_unused]] const double inverse_h = 1.0 / h;
    const double inverse_answer = 1.0 + h * model_.drag;
    const double answer = 1.0 / inverse_answer;
    double *const x = position.x.data(), *const y = position.y.data(), *const z = position.z.data();
    double* const multipliers = multipliers_.data();
    const std::size_t count = visited_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const VisitedLink& link = visited_[i];
      const Index a = link.a, b = link.b;
      const double dx = x[a] - x[b], dy = y[a] - y[b], dz = z[a] - z[b];
      const double distance = std::sqrt(dx * dx + dy * dy + dz * dz);
      if (distance == 0.0) continue;  // no direction to move in
      const double inverse_distance = 1.0 / distance;
      double change = link.length - distance;
      if constexpr (compliant) {
        const Softness& soft = softness_[i];
        const double scaled = soft.compliance * inverse_h * inverse_h;
        const double weight = answer * (link.weight_a + link.weight_b);
        change -= scaled * multipliers[i];
        if constexpr (damped) {
          const double gamma = soft.compliance * soft.damping * inverse_h;
          const Vec3 moved = Vec3(dx, dy, dz) - (start_.at(a) - start_.at(b));
          change -= gamma * inverse_distance * moved.dot(Vec3(dx, dy, dz));
          change /= weight * (1.0 + gamma) + scaled;
        } else {
          change /= weight + scaled;
        }
      } else {
        change *= link.inverse_weight * inverse_answer;
      }
      multipliers[i] += change;
      const double shift = answer * change * inverse_distance;
      const double on_a = link.weight_a * shift, on_b = link.weight_b * shift;
      x[a] += on_a * dx;
      y[a] += on_a * dy;
      z[a] += on_a * dz;
      x[b] -= on_b * dx;
      y[b] -= on_b * dy;
      z[b] -= on_b * dz;
    }
  }

  const Model& model_;
  int passes_;
  OrderedLinks order_;
  std::vector<VisitedLink> visited_;
  std::vector<Softness> softness_;  // of each visited link
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
