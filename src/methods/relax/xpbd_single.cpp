// The scheme of xpbd.cpp in single precision, plainly written: what counts here is what rounding does. Half a
// unit in the last place of a position, ε|x|/2 with ε = 2⁻²³, is all that a step can tell: the fall by
// gravity within one step, g h², is lost in it when h is below √(ε|x|/2g), and velocities, Δx/h, carry noise
// of ε|x|/h.

#include "relax/xpbd_single.h"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "contact/ground_contacts.h"
#include "file_order_stepper.h"
#include "forces/forces.h"
#include "relax/link_order.h"
#include "relax/pass_control.h"

namespace taut {
namespace {

using Vec3f = Eigen::Vector3f;

struct SingleLink {
  Index a, b;
  float length;
  float weight_a, weight_b;  // inverse masses
  float compliance, damping;
};

std::vector<Vec3f> rounded(const Vectors& vectors) {
  std::vector<Vec3f> result(vectors.size());
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = vectors.at(i).cast<float>();
  return result;
}

void widen(const std::vector<Vec3f>& from, Vectors& to) {
  for (std::size_t i = 0; i < from.size(); ++i) to.set(i, from[i].cast<double>());
}

class SingleXpbdStepper final : public FileOrderStepper {
 public:
  SingleXpbdStepper(const Model& model, PassCounts passes)
      : model_(model), passes_(model, passes), ground_(model) {}

 private:
  void links_changed(const State& state) override {
    links_.clear();
    index_ = coloured_order(model_, state).links;
    passes_.links_changed(index_);
    for (const Index link : index_) {
      const Index a = model_.links.a[link], b = model_.links.b[link];
      links_.push_back({a, b, static_cast<float>(model_.links.length[link]),
                        static_cast<float>(model_.masses.inverse_mass[a]),
                        static_cast<float>(model_.masses.inverse_mass[b]),
                        static_cast<float>(model_.links.compliance(link)),
                        static_cast<float>(model_.links.damping[link])});
    }
  }

  StepReport make_step(State& state, double h, double end_time) override {
    State next = state;
    next.time = end_time;
    kick(model_, next.time, h, state.velocity, next.velocity);
    place_pins(model_, next.time, next.position, next.velocity);
    start_ = rounded(state.position);
    position_ = rounded(next.velocity);
    const auto step = static_cast<float>(h);
    for (std::size_t i = 0; i < position_.size(); ++i) position_[i] = start_[i] + step * position_[i];
    put_pins(next.position);
    multipliers_.assign(links_.size(), 0.0F);
    int made = 0;
    bool touched = false;
    for (; passes_.another(made, touched, state.position, next.position, h); ++made) {
      for (std::size_t i = 0; i < links_.size(); ++i) solve(i, step);
      if (!ground_.empty()) touched = keep_out(state.position, next.position) || touched;
    }
    widen(position_, next.position);
    for (std::size_t i = 0; i < position_.size(); ++i)
      next.velocity.set(i, Vec3f((position_[i] - start_[i]) / step).cast<double>());
    place_pins(model_, next.time, next.position, next.velocity);
    StepReport report;
    report.rounds = made;
    report.link_solves = static_cast<std::int64_t>(links_.size()) * made;
    if (!all_finite(next)) {
      report.status = StepStatus::not_finite;
      return report;
    }
    for (std::size_t i = 0; i < links_.size(); ++i) next.tension[index_[i]] = -multipliers_[i] / (h * h);
    state = std::move(next);
    return report;
  }

  void put_pins(const Vectors& places) {
    for (const DrivenPin& pin : model_.driven_pins) position_[pin.mass] = places.at(pin.mass).cast<float>();
  }

  bool keep_out(const Vectors& start, Vectors& work) {
    widen(position_, work);
    const bool touched = ground_.solve(start, work);
    position_ = rounded(work);
    return touched;
  }

  // Equations as in xpbd.cpp.
  void solve(std::size_t i, float h) {
    const SingleLink& link = links_[i];
    const Vec3f d = position_[link.a] - position_[link.b];
    const float distance = d.norm();
    if (distance == 0.0F) return;  // no direction to move in
    const Vec3f n = d / distance;
    const float answer = 1.0F / (1.0F + h * static_cast<float>(model_.drag));
    const float scaled = link.compliance / (h * h), gamma = link.compliance * link.damping / h;
    const float moved = n.dot(d - (start_[link.a] - start_[link.b]));
    const float weight = answer * (link.weight_a + link.weight_b);
    const float change = (link.length - distance - scaled * multipliers_[i] - gamma * moved) /
                         ((1.0F + gamma) * weight + scaled);
    multipliers_[i] += change;
    position_[link.a] += (answer * link.weight_a * change) * n;
    position_[link.b] -= (answer * link.weight_b * change) * n;
  }

  const Model& model_;
  PassControl passes_;
  GroundContacts ground_;
  std::vector<Index> index_;  // in the Model, of each link
  std::vector<SingleLink> links_;
  std::vector<Vec3f> start_, position_;
  std::vector<float> multipliers_;
};

}  // namespace

std::unique_ptr<Stepper> make_single_xpbd(const Model& model, PassCounts passes) {
  return std::make_unique<SingleXpbdStepper>(model, passes);
}

}  // namespace taut
