#include "measure/explicit_integrator.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace taut {
namespace {

constexpr std::array<double, 7> nodes{0.0, 1.0 / 5, 3.0 / 10, 4.0 / 5, 8.0 / 9, 1.0, 1.0};
constexpr std::array<std::array<double, 6>, 7> weights{{
    {},
    {1.0 / 5},
    {3.0 / 40, 9.0 / 40},
    {44.0 / 45, -56.0 / 15, 32.0 / 9},
    {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
    {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
    {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
}};
// Difference between the fifth-order result (the last row above) and the embedded fourth-order one.
constexpr std::array<double, 7> error_weights{71.0 / 57600,      0.0,        -71.0 / 16695, 71.0 / 1920,
                                              -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

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

}  // namespace

ExplicitIntegrator::ExplicitIntegrator(const Model& model, const State& start, double tolerance)
    : model_(model),
      start_(start),
      field_(model, start),
      tolerance_(tolerance),
      time_(start.time),
      now_{start.position, start.velocity} {}

// One step of h from now_ to next_; returns the error over the tolerance, infinite where it can't be
// evaluated.
double ExplicitIntegrator::attempt(double h) {
  for (std::size_t stage = 0; stage < stages; ++stage) {
    next_ = now_;
    for (std::size_t earlier = 0; earlier < stage; ++earlier) {
      add_scaled(next_.position, h * weights[stage][earlier], slopes_[earlier].position);
      add_scaled(next_.velocity, h * weights[stage][earlier], slopes_[earlier].velocity);
    }
    const double stage_time = time_ + nodes[stage] * h;
    place_pins(model_, stage_time, next_.position, next_.velocity);
    slopes_[stage].position = next_.velocity;
    if (!field_.evaluate(stage_time, next_.position, next_.velocity, slopes_[stage].velocity))
      return infinity;
    ++evaluations_;
  }
  Phase error;
  error.position.resize(now_.position.size());
  error.velocity.resize(now_.velocity.size());
  for (std::size_t stage = 0; stage < stages; ++stage) {
    add_scaled(error.position, h * error_weights[stage], slopes_[stage].position);
    add_scaled(error.velocity, h * error_weights[stage], slopes_[stage].velocity);
  }
  const double size = std::max(largest(error.position), 0.1 * largest(error.velocity)) / tolerance_;
  return std::isfinite(size) ? size : infinity;
}

bool ExplicitIntegrator::advance_to(double time, long most_evaluations, const StopTest& stop) {
  while (time_ < time) {
    stop_if_told(stop);
    const bool last = time_ + h_ >= time;
    const double step = last ? time - time_ : h_;
    const double error = attempt(step);
    // What is left of the way may be as short as it likes.
    if (evaluations_ > most_evaluations || (!last && step < 1e-12)) return false;
    // The usual controller of order 5: aim for 0.9 of the tolerance, change the step by at most five times.
    const double factor = error == infinity ? 0.2 : std::clamp(0.9 * std::pow(error + 1e-12, -0.2), 0.2, 5.0);
    if (error <= 1.0) {
      std::swap(now_, next_);
      time_ = last ? time : time_ + step;
      if (!last || factor < 1.0) h_ = step * factor;
    } else {
      h_ = step * factor;
    }
  }
  return true;
}

State ExplicitIntegrator::state() const {
  State state = start_;
  state.time = time_;
  state.position = now_.position;
  state.velocity = now_.velocity;
  state.tension = field_.tensions();
  return state;
}

std::vector<State> integrate_explicitly(const Model& model, const State& start,
                                        const std::vector<double>& times, double tolerance,
                                        long most_evaluations) {
  ExplicitIntegrator integrator(model, start, tolerance);
  std::vector<State> states;
  for (const double time : times) {
    if (!integrator.advance_to(time, most_evaluations)) break;
    states.push_back(integrator.state());
  }
  return states;
}

}  // namespace taut
