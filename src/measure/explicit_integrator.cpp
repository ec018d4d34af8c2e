#include "measure/explicit_integrator.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "methods/acceleration.h"

namespace taut {
namespace {

constexpr std::size_t stages = 7;
constexpr std::array<double, stages> nodes{0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0};
constexpr std::array<std::array<double, 6>, stages> weights{{
    {},
    {1.0 / 5},
    {3.0 / 40, 9.0 / 40},
    {44.0 / 45, -56.0 / 15, 32.0 / 9},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
    {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
}};
// Difference between the fifth-order result (the last row above) and the embedded fourth-order one.
constexpr std::array<double, stages> error_weights{71.0 / 57600,      0.0,        -71.0 / 16695, 71.0 / 1920,
                                                   -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

// position and velocity, and at the same time their derivatives.
struct Phase {
  Vectors position, velocity;
};

void add_scaled(Vectors& to, double factor, const Vectors& from) {
  if (factor == 0.0) return;
  for (std::size_t i = 0; i < to.size(); ++i) {
    to.x[i] += factor * from.x[i];
    to.y[i] += factor * from.y[i];
    to.z[i] += factor * from.z[i];
  }
}

double largest(const Vectors& v) {
  double size = 0.0;
  for (const auto* axis : {&v.x, &v.y, &v.z})
    for (const double value : *axis) size = std::max(size, std::abs(value));
  return size;
}

class Integrator {
 public:
  Integrator(const Model& model, const State& start, double tolerance)
      : model_(model), field_(model, start), tolerance_(tolerance) {}

  // One step of h from `now`; returns the error over the tolerance, infinite where it can't be evaluated.
  double attempt(double time, double h, const Phase& now, Phase& next) {
    for (std::size_t stage = 0; stage < stages; ++stage) {
      next = now;
      for (std::size_t earlier = 0; earlier < stage; ++earlier) {
        add_scaled(next.position, h * weights[stage][earlier], slopes_[earlier].position);
        add_scaled(next.velocity, h * weights[stage][earlier], slopes_[earlier].velocity);
      }
      const double stage_time = time + nodes[stage] * h;
      place_pins(model_, stage_time, next.position, next.velocity);
      slopes_[stage].position = next.velocity;
      if (!field_.evaluate(stage_time, next.position, next.velocity, slopes_[stage].velocity))
        return infinity;
      ++evaluations;
    }
    Phase error{now.position, now.velocity};
    add_scaled(error.position, -1.0, now.position);
    add_scaled(error.velocity, -1.0, now.velocity);
    for (std::size_t stage = 0; stage < stages; ++stage) {
      add_scaled(error.position, h * error_weights[stage], slopes_[stage].position);
      add_scaled(error.velocity, h * error_weights[stage], slopes_[stage].velocity);
    }
    const double size = std::max(largest(error.position), 0.1 * largest(error.velocity)) / tolerance_;
    return std::isfinite(size) ? size : infinity;
  }

  std::vector<double> tensions() const { return field_.tensions(); }
  long evaluations = 0;

 private:
  const Model& model_;
  AccelerationField field_;
  double tolerance_;
  std::array<Phase, stages> slopes_;
};

}  // namespace

std::vector<State> integrate_explicitly(const Model& model, const State& start,
                                        const std::vector<double>& times, double tolerance,
                                        long most_evaluations) {
  Integrator integrator(model, start, tolerance);
  Phase now{start.position, start.velocity}, next;
  double time = start.time, h = 1e-4;
  std::vector<State> states;
  for (const double target : times) {
    while (time < target) {
      const bool last = time + h >= target;
      const double step = last ? target - time : h;
      const double error = integrator.attempt(time, step, now, next);
      if (integrator.evaluations > most_evaluations || step < 1e-12) return states;
      // The usual controller of order 5: aim for 0.9 of the tolerance, change the step by at most five times.
      const double factor =
          error == infinity ? 0.2 : std::clamp(0.9 * std::pow(error + 1e-12, -0.2), 0.2, 5.0);
      if (error <= 1.0) {
        std::swap(now, next);
        time = last ? target : time + step;
        if (!last || factor < 1.0) h = step * factor;
      } else {
        h = step * factor;
      }
    }
    State state = start;
    state.time = target;
    state.position = now.position;
    state.velocity = now.velocity;
    state.tension = integrator.tensions();
    states.push_back(std::move(state));
  }
  return states;
}

}  // namespace taut
