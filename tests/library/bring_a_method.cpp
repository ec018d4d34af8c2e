// A method of one's own: the leapfrog for links with stiffness, run by the same loop as taut's methods, and
// judged by one of them.
//
//   v ← v + (h/2) a(x),  x ← x + h v,  v ← v + (h/2) a(x),     a = g + f/m,  f = −k (|d| − l) d/|d|
//
// Second order, energy kept without drift while ω·h < 2 (Hairer, Lubich and Wanner, Geometric Numerical
// Integration, 2006, I.1.4).
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <memory>
#include <vector>

#include "methods/method.h"
#include "model/description.h"
#include "model/measures.h"
#include "motion/simulate.h"

namespace {

using taut::Index;
using taut::Model;
using taut::State;
using taut::Vec3;

class Leapfrog final : public taut::Stepper {
 public:
  explicit Leapfrog(const Model& model) : model_(model) {}

  void load(const State& state) override { state_ = state; }
  const State& store() override { return state_; }
  void undo() override {}

  taut::StepReport step(double h, double end_time) override {
    next_ = state_;
    next_.time = end_time;
    kick(0.5 * h);
    for (std::size_t i = 0; i < model_.masses.size(); ++i)
      if (!model_.masses.pinned(i)) next_.position.add(i, h * next_.velocity.at(i));
    kick(0.5 * h);
    taut::StepReport report;
    report.link_solves = 2 * static_cast<std::int64_t>(model_.links.size());
    // A step that fails leaves what store() gives as it was.
    if (taut::all_finite(next_))
      std::swap(state_, next_);
    else
      report.status = taut::StepStatus::not_finite;
    return report;
  }

 private:
  void kick(double h) {
    for (std::size_t i = 0; i < model_.masses.size(); ++i)
      if (!model_.masses.pinned(i)) next_.velocity.add(i, h * model_.gravity);
    for (std::size_t link = 0; link < model_.links.size(); ++link) {
      const Index a = model_.links.a[link], b = model_.links.b[link];
      const Vec3 d = next_.position.at(a) - next_.position.at(b);
      next_.tension[link] = model_.links.stiffness[link] * model_.links.stretch(link, d.norm());
      const Vec3 impulse = h * next_.tension[link] * d.normalized();
      next_.velocity.add(a, -model_.masses.inverse_mass[a] * impulse);
      next_.velocity.add(b, model_.masses.inverse_mass[b] * impulse);
    }
  }

  const Model& model_;
  State state_, next_;
};

constexpr std::array parameters{
    taut::Param{"steps_per_second", "1/s", 1000.0, 1.0, 1e7, false, {}, "steps of equal length"}};

std::unique_ptr<taut::Stepper> make(const Model& model, const taut::Settings&, const taut::Execution&) {
  return std::make_unique<Leapfrog>(model);
}

// What the leapfrog can do: anything else that a scene asks for is refused before the first step.
taut::Method leapfrog() {
  taut::Capabilities can;
  can.stiffness = true;
  can.rigid = can.drag = false;
  can.tension_order = 2;
  can.family = taut::Family::stormer_verlet;
  can.limit = taut::StepLimit::spring_frequency;
  return {"leapfrog", "the leapfrog, links as springs", "Hairer, Lubich and Wanner 2006", parameters, can, {},
          make};
}

taut::Built elastic_cord() {
  taut::ChainSpec cord;
  cord.name = "cord";
  cord.from = {0.0, 0.0, 0.0};  // m
  cord.to = {1.0, 0.0, 0.0};
  cord.links = 8;
  cord.mass = 0.2;  // kg
  cord.pinned = {"first"};
  cord.properties.stiffness = 200.0;  // N/m
  taut::Description scene;
  scene.chains.push_back(cord);
  return taut::build(scene);
}

// Its largest error (m) after half a second, for so many steps a second.
double error(const taut::Built& cord, const taut::Method& method, double steps_per_second,
             const State& truth) {
  const taut::Settings settings{"", {{"steps_per_second", steps_per_second}}};
  const taut::SampledRun run =
      taut::sampled_run(taut::Run(cord.model, cord.start, method, settings), {truth.time});
  return run.failed() ? HUGE_VAL : taut::position_error(run.states.front(), truth);
}

int judge() {
  const taut::Built cord = elastic_cord();
  const taut::Settings exactly{"dop853", {{"tolerance", 1e-10}}};
  const taut::SampledRun truth = taut::sampled_run(cord.model, cord.start, exactly, {0.5});
  const taut::Method method = leapfrog();
  std::vector<double> errors;
  for (const double rate : {1000.0, 2000.0, 4000.0}) {
    errors.push_back(error(cord, method, rate, truth.states.front()));
    std::printf("%4.0f steps/s: within %.2e m\n", rate, errors.back());
  }
  const double order = std::log2(errors[1] / errors[2]);
  std::printf("order %.2f\n", order);
  return std::abs(order - 2.0) < 0.1 ? 0 : 1;
}

}  // namespace

int main() {
  try {
    return judge();
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
}
