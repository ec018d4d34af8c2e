// One implicit solve of all links together per step: fast projection (Goldenthal et al., Efficient Simulation
// of Inextensible Cloth, 2007) with compliance as in XPBD, solved directly (Deul et al., Direct
// Position-Based Solver for Stiff Rods, 2018).
//
//   v ← v + h a,  x ← x + h v                            gravity and loads; drag implicit
//   until |r_i| ≤ tolerance · l_i in every link:
//     r_i = C_i − α̃_i λ_i + γ_i n·(d − d₀),   C = |d| − l,  n = d/|d|                  (λ: pull, positive)
//     (J W Jᵀ + α̃/(1 + γ)) Δλ = r/(1 + γ),     x ← x − W Jᵀ Δλ,   λ ← λ + Δλ           (Goldenthal 2007, Alg.
//     1)
//   v ← Δx/h
//
// α̃ = α/h², γ = α c/h as in XPBD. Drag is implicit in the links' forces too: W stands for W/(1 + h·drag). In
// nets the factor is kept from round to round while the residual at least quarters each time. The tension is
// λ/h². First order in time and losing energy as h, but at home with any stiffness and any ratio of masses.

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "forces.h"
#include "link_system.h"
#include "methods/method.h"
#include "parameters.h"
#include "solve_guard.h"

namespace taut {
namespace {

constexpr int most_rounds = 30;
// A solve that is further off than this after so many rounds wanders about until the rounds run out: halving
// the step at once is cheaper (on 1000 light links with a heavy tip at 60 steps/s it saves half of all
// rounds).
constexpr int rounds_to_settle = 6;
constexpr double settled_error = 0.05;

class NewtonStepper final : public Stepper {
 public:
  explicit NewtonStepper(const Model& model) : model_(model), watch_(model) {}

  void links_changed(const State& state) override {
    std::vector<Index> whole;
    for (const Index link : solvable_links(model_))
      if (!state.broken(link)) whole.push_back(link);
    system_ = make_link_system(model_, whole);
    damping_.clear();
    inverse_length_.clear();
    compliant_ = false;
    for (const Index link : system_.links.link) {
      damping_.push_back(model_.links.damping[link]);
      inverse_length_.push_back(1.0 / model_.links.length[link]);
      compliant_ = compliant_ || !model_.links.rigid(link);
    }
    const std::size_t count = whole.size();
    distance_.resize(count);
    residual_.resize(count);
    multipliers_.resize(count);
    diagonal_.resize(count);
    scale_.resize(count);
  }

  StepReport step(State& state, double h) override {
    const double end_time = state.time + h;
    velocity_ = state.velocity;
    position_ = state.position;
    kick(model_, end_time, h, state.velocity, velocity_);
    drift(h, state.position, velocity_, position_);
    place_pins(model_, end_time, position_, velocity_);

    StepReport report;
    if (!solve(state.position, h, report)) return report;

    difference_quotient(h, state.position, position_, velocity_);
    place_pins(model_, end_time, position_, velocity_);
    tension_ = state.tension;
    for (std::size_t i = 0; i < multipliers_.size(); ++i)
      tension_[system_.links.link[i]] = multipliers_[i] / (h * h);
    watch_.take_over(state, position_, velocity_, tension_, h, report);
    return report;
  }

  void watch_energy(bool on) override { watch_.set(on); }

 private:
  bool solve(const Vectors& start, double h, StepReport& report) {
    const SystemLinks& links = system_.links;
    const double tolerance = length_tolerance(links, position_);
    const double answer = 1.0 / (1.0 + h * model_.drag);
    prepare(start, h, answer);
    bool factored = false;
    double last_worst = infinity;
    for (int round = 0; round < most_rounds; ++round) {
      const double worst = measure_residual(h, report);
      if (report.status != StepStatus::done) return false;
      if (worst <= tolerance) return true;
      if (round >= rounds_to_settle && worst > settled_error) break;
      const bool keep = factored && !system_.matrix->takes_unsymmetric() && worst <= 0.25 * last_worst;
      if (!keep) {
        ++report.factorisations;
        factored = system_.matrix->factor(direction_, direction_, diagonal_);
        if (!factored) {
          report.status = StepStatus::factorisation_failed;
          return false;
        }
      }
      last_worst = worst;
      for (std::size_t i = 0; i < residual_.size(); ++i) residual_[i] *= scale_[i];
      system_.matrix->solve(residual_);
      for (std::size_t i = 0; i < residual_.size(); ++i) {
        multipliers_[i] += residual_[i];
        residual_[i] *= -answer;
      }
      apply_impulses(links, direction_, residual_, position_);
      report.rounds += 1;
      report.link_solves += static_cast<std::int64_t>(links.size());
    }
    report.status = StepStatus::not_converged;
    return false;
  }

  // What stays the same over the rounds: the start-of-step vectors, α̃/(1 + γ) and 1/(1 + γ), both over the
  // answer to drag.
  void prepare(const Vectors& start, double h, double answer) {
    std::fill(multipliers_.begin(), multipliers_.end(), 0.0);
    std::fill(scale_.begin(), scale_.end(), 1.0 / answer);
    std::fill(diagonal_.begin(), diagonal_.end(), 0.0);
    if (!compliant_) return;
    const SystemLinks& links = system_.links;
    link_vectors(links, start, start_vector_);
    for (std::size_t i = 0; i < links.size(); ++i) {
      const double gamma = links.compliance[i] * damping_[i] / h;
      scale_[i] = 1.0 / ((1.0 + gamma) * answer);
      diagonal_[i] = links.compliance[i] / (h * h) * scale_[i];
    }
  }

  // r of every link and its unit direction; returns the largest |r|/l.
  double measure_residual(double h, StepReport& report) {
    const SystemLinks& links = system_.links;
    link_vectors(links, position_, direction_);
    const Eigen::Index count = std::ssize(residual_);
    Eigen::Map<Eigen::ArrayXd> x(direction_.x.data(), count), y(direction_.y.data(), count),
        z(direction_.z.data(), count), distance(distance_.data(), count), residual(residual_.data(), count);
    distance = (x.square() + y.square() + z.square()).sqrt();
    residual = distance - Eigen::Map<const Eigen::ArrayXd>(links.length.data(), count);
    if (compliant_) add_compliance(h);
    scale_directions();

    double worst = 0.0;
    std::size_t worst_link = 0;
    for (std::size_t i = 0; i < links.size(); ++i) {
      const double size = std::abs(residual_[i]) * inverse_length_[i];
      if (!(size <= worst)) {
        worst = size;
        worst_link = i;
      }
      if (distance_[i] == 0.0) {
        report.status = StepStatus::direction_lost;
        report.worst_link = links.link[i];
        return worst;
      }
    }
    if (links.size() > 0) report.worst_link = links.link[worst_link];
    if (!std::isfinite(worst)) report.status = StepStatus::not_finite;
    return worst;
  }

  // The part of r that a link without compliance does not have.
  void add_compliance(double h) {
    const SystemLinks& links = system_.links;
    for (std::size_t i = 0; i < links.size(); ++i) {
      if (links.compliance[i] == 0.0) continue;
      const Vec3 moved = direction_.at(i) - start_vector_.at(i);
      const double rate = direction_.at(i).dot(moved) / (distance_[i] * h);
      residual_[i] += links.compliance[i] * (damping_[i] * rate - multipliers_[i] / (h * h));
    }
  }

  void scale_directions() {
    for (std::size_t i = 0; i < distance_.size(); ++i) {
      const double inverse = 1.0 / distance_[i];
      direction_.x[i] *= inverse;
      direction_.y[i] *= inverse;
      direction_.z[i] *= inverse;
    }
  }

  const Model& model_;
  EnergyWatch watch_;
  LinkSystem system_;
  bool compliant_ = false;              // whether any link is
  std::vector<double> damping_;         // N s/m
  std::vector<double> inverse_length_;  // 1/m
  Vectors position_, velocity_, direction_, start_vector_;
  std::vector<double> distance_, residual_, multipliers_, diagonal_, scale_, tension_;
};

constexpr std::array params{steps_per_second_param(240.0)};

std::unique_ptr<Stepper> make(const Model& model, const Settings&) {
  return std::make_unique<NewtonStepper>(model);
}

}  // namespace

Method newton_method() {
  Capabilities can;
  can.stiffness = true;
  can.break_stretch = true;
  can.break_tension = true;
  return {"newton",
          "one implicit solve of all links together per step, by Newton's method",
          "Goldenthal et al. (2007); Deul et al. (2018)",
          params,
          can,
          make};
}

}  // namespace taut
