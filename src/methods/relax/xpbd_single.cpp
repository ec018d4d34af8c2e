// The scheme of xpbd.cpp in single precision: what counts here is what rounding does. Half a
// unit in the last place of a position, ε|x|/2 with ε = 2⁻²³, is all that a step can tell: the fall by
// gravity within one step, g h², is lost in it when h is below √(ε|x|/2g), and velocities, Δx/h, carry noise
// of ε|x|/h.

#include "relax/xpbd_single.h"

#include <utility>
#include <vector>

#include "contact/ground_contacts.h"
#include "file_order_stepper.h"
#include "forces/forces.h"
#include "relax/pass_control.h"
#include "relax/relaxation.h"

namespace taut {
namespace {

// Many three-vectors in single precision.
struct Singles {
  std::vector<float> x, y, z;
};

Coordinates<float> coordinates(Singles& singles) {
  return {singles.x.data(), singles.y.data(), singles.z.data()};
}
Coordinates<const float> coordinates(const Singles& singles) {
  return {singles.x.data(), singles.y.data(), singles.z.data()};
}

Singles rounded(const Vectors& vectors) {
  const auto round = [](const std::vector<double>& axis) {
    std::vector<float> result(axis.size());
    for (std::size_t i = 0; i < axis.size(); ++i) result[i] = static_cast<float>(axis[i]);
    return result;
  };
  return {round(vectors.x), round(vectors.y), round(vectors.z)};
}

void widen(const Singles& from, Vectors& to) {
  to.x.assign(from.x.begin(), from.x.end());
  to.y.assign(from.y.begin(), from.y.end());
  to.z.assign(from.z.begin(), from.z.end());
}

// moved = start + h·velocity, in place of the velocity.
void drift(float h, const std::vector<float>& start, std::vector<float>& velocity) {
  for (std::size_t i = 0; i < start.size(); ++i) velocity[i] = start[i] + h * velocity[i];
}

void difference_quotient(float h, const std::vector<float>& from, const std::vector<float>& to,
                         std::vector<double>& velocity) {
  for (std::size_t i = 0; i < from.size(); ++i) velocity[i] = static_cast<double>((to[i] - from[i]) / h);
}

class SingleXpbdStepper final : public FileOrderStepper {
 public:
  SingleXpbdStepper(const Model& model, PassCounts passes)
      : model_(model), passes_(model, passes), links_(model), ground_(model) {}

 private:
  void links_changed(const State& state) override {
    links_.links_changed(state);
    passes_.links_changed(links_.links());
  }

  StepReport make_step(State& state, double h, double end_time) override {
    State next = state;
    next.time = end_time;
    kick(model_, next.time, h, state.velocity, next.velocity);
    place_pins(model_, next.time, next.position, next.velocity);
    start_ = rounded(state.position);
    position_ = rounded(next.velocity);
    const auto step = static_cast<float>(h);
    drift(step, start_.x, position_.x);
    drift(step, start_.y, position_.y);
    drift(step, start_.z, position_.z);
    put_pins(next.position);
    links_.begin_step(step, static_cast<float>(1.0 / (1.0 + h * model_.drag)),
                      coordinates(std::as_const(start_)), coordinates(std::as_const(position_)));
    int made = 0;
    bool touched = false;
    for (; passes_.another(made, touched, state.position, next.position, h); ++made) {
      links_.pass();
      if (ground_.empty()) continue;
      links_.give(coordinates(position_));
      touched = keep_out(state.position, next.position) || touched;
      links_.take(coordinates(std::as_const(position_)));
    }
    links_.give(coordinates(position_));
    widen(position_, next.position);
    difference_quotient(step, start_.x, position_.x, next.velocity.x);
    difference_quotient(step, start_.y, position_.y, next.velocity.y);
    difference_quotient(step, start_.z, position_.z, next.velocity.z);
    place_pins(model_, next.time, next.position, next.velocity);
    StepReport report;
    report.rounds = made;
    report.link_solves = links_.size() * made;
    if (!all_finite(next)) {
      report.status = StepStatus::not_finite;
      return report;
    }
    links_.give_multipliers(-1.0 / (h * h), next.tension);
    state = std::move(next);
    return report;
  }

  void put_pins(const Vectors& places) {
    for (const DrivenPin& pin : model_.driven_pins) {
      position_.x[pin.mass] = static_cast<float>(places.x[pin.mass]);
      position_.y[pin.mass] = static_cast<float>(places.y[pin.mass]);
      position_.z[pin.mass] = static_cast<float>(places.z[pin.mass]);
    }
  }

  bool keep_out(const Vectors& start, Vectors& work) {
    widen(position_, work);
    const bool touched = ground_.solve(start, work);
    position_ = rounded(work);
    return touched;
  }

  const Model& model_;
  PassControl passes_;
  Relaxation<float> links_;
  GroundContacts ground_;
  Singles start_, position_;
};

}  // namespace

std::unique_ptr<Stepper> make_single_xpbd(const Model& model, PassCounts passes) {
  return std::make_unique<SingleXpbdStepper>(model, passes);
}

}  // namespace taut
