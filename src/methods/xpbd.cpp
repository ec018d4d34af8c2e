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
// pass a step without damping runs to infinity on a large sheet. Limits on angles and contacts with solids
// follow the links in every pass; where one pushes, more passes may follow (pass_control.h).

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "contact/joint_resistance.h"
#include "contact/limits_and_contacts.h"
#include "file_order_stepper.h"
#include "forces/forces.h"
#include "methods/method.h"
#include "model/parts.h"
#include "parameters.h"
#include "relax/link_order.h"
#include "relax/pass_control.h"
#include "relax/xpbd_single.h"

namespace taut {
namespace {

// What a pass reads of each link, side by side in the order of the visits.
struct WeightedLink {
  Index a, b;
  double length;
  double weight_a, weight_b;  // inverse masses
  double inverse_weight;      // 1/(w_a + w_b)
};

// The same of a link between two of many equal masses.
struct PlainLink {
  Index a, b;
  double length;
};

// The links of one colour: a stretch of the plain ones and one of the weighted ones.
struct Colour {
  std::size_t plain_end, weighted_end;
};

// What it reads of links that have it.
struct Softness {
  double compliance;  // m/N
  double damping;     // N s/m
};

// 1/m of every free mass; −1 where they differ or there is none.
double common_weight(const Model& model) {
  if (!equal_masses(model)) return -1.0;
  for (const double weight : model.masses.inverse_mass)
    if (weight > 0.0) return weight;
  return -1.0;
}

class XpbdStepper final : public FileOrderStepper {
 public:
  XpbdStepper(const Model& model, PassCounts passes)
      : model_(model),
        passes_(model, passes),
        limits_and_contacts_(model),
        joints_(model),
        equal_weight_(common_weight(model)),
        equal_inverse_weight_(0.5 / equal_weight_) {}

 private:
  void links_changed(const State& state) override {
    const OrderedLinks order = coloured_order(model_, state);
    flat_ = stays_in_plane(model_, state);
    plain_.clear();
    weighted_.clear();
    colours_.clear();
    std::vector<Index> plain, weighted;
    std::size_t next = 0;
    for (const std::size_t end : order.colour_ends) {
      for (; next < end; ++next) {
        const Index link = order.links[next];
        const Index a = model_.links.a[link], b = model_.links.b[link];
        const double weight_a = model_.masses.inverse_mass[a], weight_b = model_.masses.inverse_mass[b];
        if (weight_a == equal_weight_ && weight_b == equal_weight_) {
          plain_.push_back({a, b, model_.links.length[link]});
          plain.push_back(link);
        } else {
          weighted_.push_back(
              {a, b, model_.links.length[link], weight_a, weight_b, 1.0 / (weight_a + weight_b)});
          weighted.push_back(link);
        }
      }
      colours_.push_back({plain_.size(), weighted_.size()});
    }
    links_ = std::move(plain);
    links_.insert(links_.end(), weighted.begin(), weighted.end());
    softness_.clear();
    compliant_ = damped_ = false;
    for (const Index link : links_) {
      softness_.push_back({model_.links.compliance(link), model_.links.damping[link]});
      compliant_ = compliant_ || !model_.links.rigid(link);
      damped_ = damped_ || model_.links.damping[link] > 0.0;
    }
    multipliers_.assign(links_.size(), 0.0);
    passes_.links_changed(links_);
  }

  StepReport make_step(State& state, double h, double end_time) override {
    const double start_time = state.time;
    start_ = state.position;
    velocity_ = state.velocity;
    kick(model_, end_time, h, state.velocity, velocity_);
    blow(model_, state, state.position, state.velocity, end_time, h, velocity_);
    joints_.act(state, h, 1.0, velocity_);
    drift(h, start_, velocity_, state.position);
    place_pins(model_, end_time, state.position, velocity_);
    multipliers_.assign(links_.size(), 0.0);
    limits_and_contacts_.begin_step(start_, state);
    int made = 0;
    for (; passes_.another(made, limits_and_contacts_.may_jump(), start_, state.position, h); ++made) {
      solve_all(state.position, h);
      limits_and_contacts_.solve(h, 1.0 / (1.0 + h * model_.drag), state.position);
    }
    StepReport report;
    report.rounds = made;
    report.link_solves = (static_cast<std::int64_t>(links_.size()) + limits_and_contacts_.size()) * made;
    difference_quotient(h, start_, state.position, velocity_);
    limits_and_contacts_.rebound(h, velocity_);
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
    limits_and_contacts_.keep(state);
    joints_.keep(start_, state);
    for (std::size_t i = 0; i < links_.size(); ++i) state.tension[links_[i]] = -multipliers_[i] / (h * h);
    return report;
  }

  // The loops without what the scene does not have. What is left out would multiply by one, or add a zero:
  // the results are the same, bit for bit.
  void solve_all(Vectors& position, double h) {
    if (damped_)
      flat_ ? solve_colours<true, true, true>(position, h) : solve_colours<true, true, false>(position, h);
    else if (compliant_)
      flat_ ? solve_colours<true, false, true>(position, h) : solve_colours<true, false, false>(position, h);
    else
      flat_ ? solve_colours<false, false, true>(position, h)
            : solve_colours<false, false, false>(position, h);
  }

  template <bool compliant, bool damped, bool flat>
  void solve_colours(Vectors& position, double h) {
    Colour begin{0, 0};
    for (const Colour& end : colours_) {
      solve<compliant, damped, flat>(plain_, begin.plain_end, end.plain_end, 0, position, h);
      solve<compliant, damped, flat>(weighted_, begin.weighted_end, end.weighted_end, plain_.size(), position,
                                     h);
      begin = end;
    }
  }

  double weight_a(const PlainLink&) const { return equal_weight_; }
  double weight_b(const PlainLink&) const { return equal_weight_; }
  double inverse_weight(const PlainLink&) const { return equal_inverse_weight_; }
  static double weight_a(const WeightedLink& link) { return link.weight_a; }
  static double weight_b(const WeightedLink& link) { return link.weight_b; }
  static double inverse_weight(const WeightedLink& link) { return link.inverse_weight; }

  // Plain numbers, coordinate by coordinate: packed into vectors of three the loop takes a seventh longer.
  // The links' multipliers begin at `first`.
  template <bool compliant, bool damped, bool flat, class Link>
  void solve(const std::vector<Link>& links, std::size_t begin, std::size_t end, std::size_t first,
             Vectors& position, double h) {
    [[maybe_unused]] const double inverse_h = 1.0 / h;
    const double inverse_answer = 1.0 + h * model_.drag;
    const double answer = 1.0 / inverse_answer;
    double *const x = position.x.data(), *const y = position.y.data(), *const z = position.z.data();
    double* const multipliers = multipliers_.data() + first;
    for (std::size_t i = begin; i < end; ++i) {
      const Link& link = links[i];
      const Index a = link.a, b = link.b;
      const double dx = x[a] - x[b], dy = y[a] - y[b];
      double dz = 0.0;
      double square = dx * dx + dy * dy;
      if constexpr (!flat) {
        dz = z[a] - z[b];
        square += dz * dz;
      }
      const double distance = std::sqrt(square);
      if (distance == 0.0) continue;  // no direction to move in
      const double inverse_distance = 1.0 / distance;
      double change = link.length - distance;
      if constexpr (compliant) {
        const Softness& soft = softness_[first + i];
        const double scaled = soft.compliance * inverse_h * inverse_h;
        const double weight = answer * (weight_a(link) + weight_b(link));
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
        change *= inverse_weight(link) * inverse_answer;
      }
      multipliers[i] += change;
      const double shift = answer * change * inverse_distance;
      const double on_a = weight_a(link) * shift, on_b = weight_b(link) * shift;
      x[a] += on_a * dx;
      y[a] += on_a * dy;
      x[b] -= on_b * dx;
      y[b] -= on_b * dy;
      if constexpr (!flat) {
        z[a] += on_a * dz;
        z[b] -= on_b * dz;
      }
    }
  }

  const Model& model_;
  PassControl passes_;
  LimitsAndContacts limits_and_contacts_;
  JointResistance joints_;
  double equal_weight_, equal_inverse_weight_;  // w of all free masses, 1/(2 w); −1 where they differ
  std::vector<PlainLink> plain_;                // colour by colour
  std::vector<WeightedLink> weighted_;          // the rest of each colour: at pins, or where masses differ
  std::vector<Colour> colours_;
  std::vector<Index> links_;        // the plain ones, then the weighted ones
  std::vector<Softness> softness_;  // of each of them
  bool compliant_ = false, damped_ = false, flat_ = false;
  std::vector<double> multipliers_;  // λ of each of them, kg m
  Vectors start_, velocity_;
};

constexpr std::array<std::string_view, 2> precisions{"double", "single"};
constexpr std::array params{
    steps_per_second_param(600.0),
    passes_param(1.0),
    impact_passes_param(),
    Param{"precision", "", 0, 0, 0, false, precisions,
          "of positions and velocities; single shows what rounding does, and is no quicker here"},
};

std::unique_ptr<Stepper> make(const Model& model, const Settings& settings, const Execution&) {
  const PassCounts passes = pass_counts(settings);
  if (settings.choice("precision") == "single") return make_single_xpbd(model, passes);
  return std::make_unique<XpbdStepper>(model, passes);
}

std::string refusal(const Model& model, const State&, const Settings& settings) {
  const bool more =
      !model.limits.empty() || !touches_only_ground(model) || !model.joints.empty() || model.wind;
  if (settings.choice("precision") != "single" || !more) return {};
  return "method xpbd in single precision knows no limits on angles, no joints that resist, no solids but "
         "the "
         "ground, no touching bodies and no wind: use precision = \"double\" for this scene";
}

}  // namespace

Method xpbd_method() {
  Capabilities can;
  can.keeps = {Keeping::kept, Keeping::lost_with_step, Keeping::lost_with_step};
  can.stiffness = true;
  can.ground = true;
  can.limits = true;
  can.colliders = true;
  can.break_stretch = true;
  can.break_tension = true;
  return {"xpbd",
          "compliant position-based dynamics in small steps",
          "Macklin et al., XPBD (2016); Small Steps in Physics Simulation (2019)",
          params,
          can,
          {6.0, 6.0, 0.0},
          make,
          refusal};
}

}  // namespace taut
