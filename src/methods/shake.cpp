// SHAKE by Gauss–Seidel passes (Ryckaert, Ciccotti and Berendsen, Numerical integration of the Cartesian
// equations of motion of a system with constraints, 1977): Verlet with relaxation along the link directions
// of the start of the step.
//
//   v½ = v + (h/2) a(x),  x₁ = x + h v½        gravity, loads, drag, wind, and links with stiffness as forces
//   `passes` times, for each rigid link, d = x_a − x_b, d₀ the same at the start of the step:
//     q = (|d|² − l²) / (2 (w_a + w_b) d·d₀),  x_a ← x_a − w_a q d₀,  x_b ← x_b + w_b q d₀
//   v ← (x₁ − x)/h + (h/2) a(x₁)
//
// Limits on angles follow the links in every pass, along their gradients at the start of the step; where one
// pushes, more passes may follow (pass_control.h).
//
// That one change of direction makes the relaxation of second order: one pass per small step is within 5e-4 m
// on a 2 m chain where relaxation along the new direction is at 1e-2 m for the same price. It shares RATTLE's
// limit, h below about √(m l/T). The tension is Σ q |d₀|/h². The velocity at the end still holds the last
// half kick, as with verlet. Damping and wind, which depend on velocity, meet one without it: the links'
// answer to that half kick is half a step of their last tension.

#include <array>
#include <cmath>

#include "contact/joint_resistance.h"
#include "direct/link_system.h"
#include "forces/forces.h"
#include "forces/half_kicks.h"
#include "methods/method.h"
#include "parameters.h"
#include "relax/limit_solver.h"
#include "relax/link_order.h"
#include "relax/pass_control.h"
#include "solve_guard.h"

namespace taut {
namespace {

class ShakeStepper final : public Stepper {
 public:
  ShakeStepper(const Model& model, PassCounts passes, double tolerance, double steps_per_second)
      : model_(model),
        passes_(model, passes),
        tolerance_(tolerance),
        kicks_(model, "shake", 1.0 / steps_per_second, 2.0),
        limits_(model),
        watch_(model),
        joints_(model) {}

  void links_changed(const State& state) override {
    std::vector<Index> rigid;
    for (const Index link : coloured_order(model_, state).links)
      if (model_.links.rigid(link)) rigid.push_back(link);
    links_ = gather(model_, rigid);
    passes_.links_changed(rigid);
    kicks_.links_changed(state);
  }

  StepReport step(State& state, double h) override {
    const double end_time = state.time + h, half = 0.5 * h;
    velocity_ = state.velocity;
    position_ = state.position;
    tension_ = state.tension;
    link_vectors(links_, state.position, start_direction_);
    answer_half_kick(state, half);
    kicks_.start(state, state.time, half, state.position, state.velocity, met_velocity_, kicked_);
    joints_.act(state, h, 1.0, kicked_);
    drift(h, state.position, kicked_, position_);
    place_pins(model_, end_time, position_, velocity_);

    StepReport report;
    report.link_solves = kicks_.solves();
    limits_.begin_step();
    if (!relax(state.position, h, report)) return report;

    difference_quotient(h, state.position, position_, velocity_);
    place_pins(model_, end_time, position_, velocity_);
    kicks_.end(state, end_time, half, position_, kicked_, velocity_, tension_);
    for (std::size_t i = 0; i < links_.size(); ++i)
      tension_[links_.link[i]] = multipliers_[i] * start_direction_.at(i).norm() / (h * h);
    watch_.take_over(state, position_, velocity_, tension_, h, report);
    if (report.status == StepStatus::done) joints_.keep(position_, state);
    return report;
  }

  void watch_energy(bool on) override { watch_.set(on); }

 private:
  // The velocities at the start of a step as the links would have them.
  void answer_half_kick(const State& state, double half) {
    met_velocity_ = state.velocity;
    if (!kicks_.meet_velocity()) return;
    answer_.resize(links_.size());
    for (std::size_t i = 0; i < links_.size(); ++i)
      answer_[i] = -half * state.tension[links_.link[i]] / start_direction_.at(i).norm();
    apply_impulses(links_, start_direction_, answer_, met_velocity_);
  }

  bool relax(const Vectors& start, double h, StepReport& report) {
    multipliers_.assign(links_.size(), 0.0);
    for (int made = 0; passes_.another(made, limits_.pushed(), start, position_, h); ++made) {
      double worst = 0.0;
      for (std::size_t i = 0; i < links_.size(); ++i) {
        const Index a = links_.a[i], b = links_.b[i];
        const double squared = links_.length[i] * links_.length[i];
        const Vec3 direction = start_direction_.at(i);
        const Vec3 difference = position_.at(a) - position_.at(b);
        const double along = difference.dot(direction);
        if (!(along > 0.0)) {
          report.status = std::isfinite(along) ? StepStatus::direction_lost : StepStatus::not_finite;
          report.worst_link = links_.link[i];
          return false;
        }
        const double excess = difference.squaredNorm() - squared;
        worst = std::max(worst, std::abs(excess) / squared);
        const double q = excess / (2.0 * (links_.weight_a[i] + links_.weight_b[i]) * along);
        multipliers_[i] += q;
        position_.add(a, (-links_.weight_a[i] * q) * direction);
        position_.add(b, (links_.weight_b[i] * q) * direction);
      }
      limits_.solve_along(start, position_, h, 1.0);
      ++report.rounds;
      report.link_solves += static_cast<std::int64_t>(links_.size()) + limits_.size();
      if (worst <= tolerance_) break;
    }
    return true;
  }

  const Model& model_;
  PassControl passes_;
  double tolerance_;
  HalfKicks kicks_;
  LimitSolver limits_;
  EnergyWatch watch_;
  JointResistance joints_;
  SystemLinks links_;
  Vectors position_, velocity_, kicked_, met_velocity_, start_direction_;
  std::vector<double> multipliers_, tension_, answer_;
};

constexpr std::array params{
    steps_per_second_param(2400.0),
    passes_param(1.0),
    impact_passes_param(),
    Param{"tolerance",
          "",
          0.0,
          0.0,
          1.0,
          false,
          {},
          "passes end early once every squared length was within this share of its own"},
};

std::unique_ptr<Stepper> make(const Model& model, const Settings& settings) {
  return std::make_unique<ShakeStepper>(model, pass_counts(settings), settings.number("tolerance"),
                                        settings.steps_per_second());
}

}  // namespace

Method shake_method() {
  Capabilities can;
  can.half_kicked = true;
  can.limit = StepLimit::sideways_vibration;
  can.stiffness = true;
  can.limits = true;
  can.break_stretch = true;
  can.break_tension = true;
  return {"shake",
          "relaxation along the directions of the start of the step, second order",
          "Ryckaert, Ciccotti and Berendsen (1977)",
          params,
          can,
          make};
}

}  // namespace taut
