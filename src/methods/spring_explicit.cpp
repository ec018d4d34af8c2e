// Symplectic Euler on springs, the classic that blows up:
//
//   v ← v + h (g + f(x, v)/m),  x ← x + h v,     f = −(k (|d| − l) + c d·ḋ/|d|) d/|d|;  drag implicit
//
// First order, energy bounded while ω_max·h < 2 with ω_max the highest frequency of the springs (2√(k/m) for
// a long chain), and gone to infinity beyond. Explicit damping lowers the limit. (Hairer, Lubich and Wanner,
// Geometric Numerical Integration, 2006.)

#include <array>

#include "file_order_stepper.h"
#include "forces/forces.h"
#include "forces/springs.h"
#include "methods/method.h"
#include "parameters.h"

namespace taut {
namespace {

class SpringExplicitStepper final : public SwappingStepper {
 public:
  explicit SpringExplicitStepper(const Model& model) : model_(model) {}

 private:
  void links_changed(const State& state) override {
    springs_ = gather_springs(model_, state, OneSided::taken);
  }

  StepReport make_step(State& state, double h, double end_time) override {
    copy_to_work(state);
    kick_by_springs(springs_, h, state.position, state.velocity, velocity_, spring_tension_);
    blow(model_, state, state.position, state.velocity, end_time, h, velocity_);
    kick(model_, end_time, h, velocity_, velocity_);
    drift(h, state.position, velocity_, position_);
    place_pins(model_, end_time, position_, velocity_);
    spring_tensions(springs_, position_, velocity_, spring_tension_);
    for (std::size_t i = 0; i < spring_tension_.size(); ++i)
      tension_[springs_.links.link[i]] = spring_tension_[i];

    StepReport report;
    report.rounds = 1;
    report.link_solves = static_cast<std::int64_t>(spring_tension_.size());
    take_over(state, end_time, report);
    return report;
  }

  const Model& model_;
  Springs springs_;
  std::vector<double> spring_tension_;
};

constexpr std::array spring_explicit_params{steps_per_second_param(2400.0)};

std::unique_ptr<Stepper> make_spring_explicit(const Model& model, const Settings&, const Execution&) {
  return std::make_unique<SpringExplicitStepper>(model);
}

}  // namespace

Method spring_explicit_method() {
  Capabilities can;
  can.family = Family::stormer_verlet;
  can.limit = StepLimit::spring_frequency;
  can.stiffness = true;
  can.rigid = false;
  can.one_sided = true;
  can.bending = true;
  can.break_stretch = true;
  can.break_tension = true;
  return {"spring-explicit",
          "symplectic Euler on springs; unstable beyond ω·h = 2",
          "Hairer, Lubich and Wanner, Geometric Numerical Integration (2006)",
          spring_explicit_params,
          can,
          {17.0, 0.0, 0.0},
          make_spring_explicit};
}

}  // namespace taut
