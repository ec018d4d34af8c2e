// Symplectic Euler on springs, the classic that blows up:
//
//   v ← v + h (g + f(x, v)/m),  x ← x + h v,     f = −(k (|d| − l) + c d·ḋ/|d|) d/|d|;  drag implicit
//
// First order, energy bounded while ω_max·h < 2 with ω_max the highest frequency of the springs (2√(k/m) for
// a long chain), and gone to infinity beyond. Explicit damping lowers the limit. (Hairer, Lubich and Wanner,
// Geometric Numerical Integration, 2006.)

#include <array>

#include "forces/forces.h"
#include "methods/method.h"
#include "parameters.h"
#include "solve_guard.h"
#include "forces/springs.h"

namespace taut {
namespace {

class SpringExplicitStepper final : public Stepper {
 public:
  explicit SpringExplicitStepper(const Model& model) : model_(model), watch_(model) {}

  void links_changed(const State& state) override { springs_ = gather_springs(model_, state); }

  StepReport step(State& state, double h) override {
    velocity_ = state.velocity;
    position_ = state.position;
    tension_ = state.tension;
    kick_by_springs(springs_, h, state.position, state.velocity, velocity_, spring_tension_);
    blow(model_, state, state.position, state.velocity, state.time + h, h, velocity_);
    kick(model_, state.time + h, h, velocity_, velocity_);
    drift(h, state.position, velocity_, position_);
    place_pins(model_, state.time + h, position_, velocity_);
    spring_tensions(springs_, position_, velocity_, spring_tension_);
    for (std::size_t i = 0; i < spring_tension_.size(); ++i)
      tension_[springs_.links.link[i]] = spring_tension_[i];

    StepReport report;
    report.rounds = 1;
    report.link_solves = static_cast<std::int64_t>(spring_tension_.size());
    watch_.take_over(state, position_, velocity_, tension_, h, report);
    return report;
  }

  void watch_energy(bool on) override { watch_.set(on); }

 private:
  const Model& model_;
  EnergyWatch watch_;
  Springs springs_;
  Vectors position_, velocity_;
  std::vector<double> tension_, spring_tension_;
};

constexpr std::array params{steps_per_second_param(2400.0)};

std::unique_ptr<Stepper> make(const Model& model, const Settings&) {
  return std::make_unique<SpringExplicitStepper>(model);
}

}  // namespace

Method spring_explicit_method() {
  Capabilities can;
  can.limit = StepLimit::spring_frequency;
  can.stiffness = true;
  can.rigid = false;
  can.break_stretch = true;
  can.break_tension = true;
  return {"spring-explicit",
          "symplectic Euler on springs; unstable beyond ω·h = 2",
          "Hairer, Lubich and Wanner, Geometric Numerical Integration (2006)",
          params,
          can,
          make};
}

}  // namespace taut
