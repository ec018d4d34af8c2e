// RATTLE with a direct solve (Andersen, Rattle: a "velocity" version of the SHAKE algorithm, 1983), of second
// order, and its fourth-order composition (Yoshida, Construction of higher order symplectic integrators,
// 1990).
//
//   v½ = v + (h/2) a(x, v)               half_kicks.h has the forces, and what velocity they meet at the end
//   x₁ = x + h v½ − W J₀ᵀ s              with J₀ the link vectors d₀ at the start of the step, and s such
//     that g(x₁) = (|d|² − l²)/2 = 0       every rigid link has its length
//   v½ ← (x₁ − x)/h
//   v₁ = v½ + (h/2) a(x₁, v₁) − W J₁ᵀ u  with u such that d·ḋ = 0 in every rigid link
//
// Positions: Newton's method, (J W J₀ᵀ) Δs = g with J at the present x₁. Along paths and trees that
// unsymmetric matrix is eliminated directly; in nets the symmetric J₀ W J₀ᵀ stands in for it (chord Newton).
// It is the matrix of the velocities of the step before, so a net is factorised once a step. Velocities: one
// linear solve with the symmetric J₁ W J₁ᵀ.
//
// Tension: s |d₀|/(h²/2) is that at the start of the step and u |d|/(h/2) that at its end, both only to first
// order, out by as much on either side. Second order needs no more than another solve with the matrix of the
// velocities, for the multipliers at acceleration level: (J₁ W J₁ᵀ) λ = J₁ a(x₁, v₁) + |ḋ|². While stops push
// or joints resist, which are no part of that, it stays at u |d|/(h/2).
//
// Correcting along the start-of-step direction makes the map symmetric in time: second order, and no drift of
// energy. Its price is a limit: light links of mass m under tension T vibrate sideways at up to 2√(T/(m l)),
// so h must stay below about √(m l/T). A step beyond it does not converge, turns a link by 90° or makes
// energy, and is reported as such.
//
// Limits on angles that push border both systems (see ActiveLimits): in positions along their gradients at
// the start of the step, in velocities along those at its end. Hard stops are plastic. Soft ones are springs
// that only push, whatever their compliance: each half kick has of their torques at the start of the step and
// at its end (begin_half_kicks); in positions those at the end border the system, and velocities get their
// half kick before the links answer.

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/vector_operations.h"
#include "contact/joint_resistance.h"
#include "direct/active_limits.h"
#include "direct/anderson_mixing.h"
#include "direct/chain_blocks.h"
#include "direct/length_errors.h"
#include "direct/link_system.h"
#include "direct/newton_rounds.h"
#include "direct/solve_memory.h"
#include "file_order_stepper.h"
#include "forces/forces.h"
#include "forces/free_acceleration.h"
#include "forces/half_kicks.h"
#include "forces/mass_kernels.h"
#include "methods/method.h"
#include "parameters.h"

namespace taut {
namespace {

constexpr int most_rounds = 60;
// Chord Newton that has not come so much closer in so many rounds has no solution near, as where a pushed row
// buckles within the step: two halves are quicker.
constexpr int rounds_to_gain = 12;
constexpr double least_gain = 0.01;

class RattleStepper final : public SwappingStepper {
 public:
  RattleStepper(const Model& model, int order)
      : model_(model),
        order_(order),
        kicks_(model, 1.0),
        limits_(model),
        joints_(model),
        tension_of_velocities_(!limits_.none() || !model.joints.empty()) {}

 private:
  void links_changed(const State& state) override {
    const std::vector<Index> rigid = whole_rigid_links(model_, state);
    system_ = make_link_system(model_, rigid);
    no_compliance_.assign(rigid.size(), 0.0);
    errors_.links_changed(system_.links);
    shortest_ = shortest_length(system_.links);
    factored_along_.resize(0);
    kicks_.links_changed(state);
    limits_.links_changed(state);
    blocks_ = ChainBlocks(model_, system_.links);
  }

  // Whether nothing acts but gravity, loads and drag; and of those no loads, and no pins that move.
  bool only_fields() const { return kicks_.only_fields() && model_.joints.empty(); }
  bool only_falling() const { return kicks_.only_fields() && !pushed_from_outside(model_); }

  StepReport make_step(State& state, double h, double end_time) override {
    begin_work(state, blocks_.several());
    direction_known_ = goes_on_;
    StepReport report;
    if (order_ == 2)
      sub_step(state, state.time, h, end_time, state.position, state.velocity, report);
    else
      compose(state, h, end_time, report);
    if (report.status != StepStatus::done) return report;
    if (!tension_of_velocities_) solve_tensions(state, end_time, report);
    take_over(state, end_time, report);
    if (report.status == StepStatus::done) joints_.keep(position_, state);
    return report;
  }

  // Yoshida 1990: three steps of order 2 make one of order 4.
  void compose(const State& start, double h, double end_time, StepReport& report) {
    const double outer = 1.0 / (2.0 - std::cbrt(2.0)), inner = 1.0 - 2.0 * outer;
    const double first = start.time + outer * h, second = first + inner * h;
    part_position_ = start.position;
    part_velocity_ = start.velocity;
    const auto part = [&](double time, double share, double next) {
      sub_step(start, time, share * h, next, part_position_, part_velocity_, report);
      return report.status == StepStatus::done;
    };
    const auto go_on = [&] {
      std::swap(part_position_, position_);
      std::swap(part_velocity_, velocity_);
    };
    if (!part(start.time, outer, first)) return;
    go_on();
    if (!part(first, inner, second)) return;
    go_on();
    part(second, outer, end_time);
  }

  // One step of order 2 from a time to another, to position_ and velocity_.
  void sub_step(const State& start, double time, double h, double end_time, const Vectors& position,
                const Vectors& velocity, StepReport& report) {
    predict(start, time, h, end_time, position, velocity);
    report.link_solves += kicks_.solves();
    if (solve_positions(position, report)) solve_velocities(start, h, end_time, position, report);
  }

  // Where forces take the masses, and what links pulled with before, and what that leaves of the links'
  // lengths.
  void predict(const State& start, double time, double h, double end_time, const Vectors& position,
               const Vectors& velocity) {
    GrowingExtent moved;
    errors_.begin();
    farthest_ = 0.0;
    if (direction_known_) std::swap(errors_.start_direction, errors_.direction);
    blocks_.visit([&](Extent block) {
      if (!direction_known_) link_vectors(system_.links, position, errors_.start_direction, block);
      const Extent masses = blocks_.masses_among({0, block.end});
      moved.grow(masses, [&](Extent more) {
        fall_freely(start, time, h, end_time, position, velocity, more);
        if (!tension_of_velocities_) guess(start.tension, h, block, more);
        farthest_ = std::max(farthest_, largest_of(more.size(), to_read(position_, more.begin)));
      });
      measure(masses);
    });
  }

  // Half a kick at the start, and a drift.
  void fall_freely(const State& start, double time, double h, double end_time, const Vectors& position,
                   const Vectors& velocity, Extent masses) {
    const double half = 0.5 * h;
    if (only_fields()) {
      kick_and_drift(model_, time, half, h, position, velocity, velocity_, position_, DragAt::start, masses);
    } else {
      kicks_.start(start, time, half, position, velocity, velocity, half_velocity_);
      joints_.act(start, h, 0.5, half_velocity_);
      drift(h, position, half_velocity_, position_);
    }
    place_pins(model_, end_time, position_, only_fields() ? velocity_ : half_velocity_);
    limits_.begin_half_kicks(h, position, position_);
  }

  // What links pull with at the start of the step brings positions within O(h³) of where they belong.
  void guess(const std::vector<double>& tension, double h, Extent some, Extent masses) {
    const SystemLinks& links = system_.links;
    if (blocks_.several())
      some_of(errors_.residual, some) =
          some_of(tension, some) * some_of(errors_.inverse_square(), some) * some_of(links.length, some);
    else
      for (std::size_t i = 0; i < links.size(); ++i)
        errors_.residual[i] = tension[links.link[i]] * errors_.inverse_square()[i] * links.length[i];
    push(errors_.start_direction, position_, -0.5 * h * h, masses);
  }

  bool solve_positions(const Vectors& start, StepReport& report) {
    const SystemLinks& links = system_.links;
    const double tolerance = length_tolerance(shortest_, farthest_);
    mixing_.begin();
    double best = infinity, best_before = infinity;  // of these rounds, and of those before
    for (int round = 0; round < most_rounds; ++round) {
      if (!errors_.sound(links, report)) return false;
      const double beyond = limits_.look(position_, &start);
      if (errors_.worst() <= tolerance && beyond <= limit_tolerance) return direction_known_ = true;
      best = std::min(best, errors_.worst());
      if (round % rounds_to_gain == 0) {
        if (best > std::max(tolerance, least_gain * best_before)) break;
        best_before = std::exchange(best, infinity);
      }
      if (!solve_round(report)) {
        report.status = StepStatus::factorisation_failed;
        return false;
      }
      report.rounds += 1;
      report.link_solves += static_cast<std::int64_t>(links.size());
    }
    if (!errors_.sound(links, report)) return false;
    report.status = StepStatus::not_converged;
    if (links.size() > 0) report.worst_link = errors_.worst_link(links, report.status);
    return false;
  }

  void measure(Extent moved) { errors_.measure(system_.links, position_, blocks_.links_among(moved)); }

  // Solves for a round's change of the multipliers, and moves the masses by it.
  bool solve_round(StepReport& report) {
    errors_.begin();
    GrowingExtent moved;
    const auto move_masses = [&](Extent solved) {
      if (!limits_.none())
        limits_.push(system_, errors_.direction, errors_.start_direction, 1.0, errors_.residual, position_);
      else if (!system_.matrix->takes_unsymmetric())
        mixing_.mix(errors_.residual);
      const Extent masses = blocks_.masses_among(solved);
      moved.grow(masses, [&](Extent more) { push(errors_.start_direction, position_, -1.0, more); });
      measure(masses);
    };
    return factor_and_solve(errors_.start_direction, {{}, move_masses}, report);
  }

  // Factorises J W Cᵀ, or for a net C W Cᵀ unless its matrix already holds that, and solves for the residual;
  // but where limits border the system that is left to them.
  bool factor_and_solve(const Vectors& columns, const LinkVisits& visits, StepReport& report) {
    LinkMatrix& matrix = *system_.matrix;
    if (blocks_.several()) {
      ++report.factorisations;
      return matrix.factor_and_solve_by_blocks(errors_.direction, columns, no_compliance_, errors_.residual,
                                               visits);
    }
    visits.before(system_.links.all());
    const bool net = !matrix.takes_unsymmetric();
    if (!net || factored_along_ != columns) {
      ++report.factorisations;
      factored_along_.resize(0);
      const Vectors& rows = net ? columns : errors_.direction;
      const bool factored = limits_.none()
                                ? matrix.factor_and_solve(rows, columns, no_compliance_, errors_.residual)
                                : matrix.factor(rows, columns, no_compliance_);
      if (!factored) return false;
      if (net) factored_along_ = columns;
    } else if (limits_.none()) {
      matrix.solve(errors_.residual);
    }
    visits.after(system_.links.all());
    return true;
  }

  // The mean velocities of the step, half a kick at its end, and what links say to both: along
  // errors_.direction, which solve_positions() has left as that of the end of the step.
  void solve_velocities(const State& start, double h, double end_time, const Vectors& position,
                        StepReport& report) {
    const double half = 0.5 * h;
    const SystemLinks& links = system_.links;
    GrowingExtent answered, falling;
    if (blocks_.several()) energy_ = 0.0;
    const auto kick_masses = [&](Extent some) {
      end_half_kicks(start, h, end_time, position, blocks_.masses_at(some));
      along_links(links, errors_.direction, velocity_, errors_.residual, some);
    };
    const auto answer = [&](Extent solved) {
      if (!limits_.none()) limits_.stop(system_, errors_.direction, position_, errors_.residual, velocity_);
      if (tension_of_velocities_)
        for (std::size_t i = 0; i < links.size(); ++i)
          tension_[links.link[i]] = errors_.residual[i] * links.length[i] * (1.0 + half * model_.drag) / half;
      limits_.give_tensions(0.5 / (half * half), position_, tension_);
      const Extent masses = blocks_.masses_among(solved);
      answered.grow(masses, [&](Extent more) {
        push(errors_.direction, velocity_, -1.0, more);
        if (blocks_.several()) *energy_ += energy_of_some(model_, position_, velocity_, more);
      });
      if (blocks_.several())
        falling.grow(blocks_.links_among(masses), [&](Extent more) {
          measure_falling_chain(model_, errors_.direction, velocity_, errors_.residual, more);
        });
    };
    if (factor_and_solve(errors_.direction, {kick_masses, answer}, report))
      report.link_solves += static_cast<std::int64_t>(links.size());
    else
      report.status = StepStatus::factorisation_failed;
  }

  void end_half_kicks(const State& start, double h, double end_time, const Vectors& position, Extent masses) {
    const double half = 0.5 * h;
    place_pins(model_, end_time, position_, velocity_);
    if (only_fields()) {
      mean_velocity_and_kick(model_, end_time, half, h, position, position_, velocity_, masses);
    } else {
      difference_quotient(h, position, position_, velocity_);
      place_pins(model_, end_time, position_, velocity_);
      kicks_.end(start, end_time, half, position_, half_velocity_, velocity_, tension_);
    }
    limits_.kick(position_, 1.0 / (1.0 + half * model_.drag), velocity_);
    joints_.finish(0.5, position_, velocity_);
  }

  // With the matrix of the velocities, which the system still holds; what is asked of links in blocks is
  // known.
  void solve_tensions(const State& whole, double time, StepReport& report) {
    const SystemLinks& links = system_.links;
    report.link_solves += static_cast<std::int64_t>(links.size());
    if (blocks_.several()) {
      GrowingExtent known;
      const auto keep = [&](Extent solved) {
        known.grow(solved, [&](Extent more) {
          some_of(tension_, more) = some_of(errors_.residual, more) * some_of(links.length, more);
        });
      };
      system_.matrix->solve_by_blocks(errors_.residual, {{}, keep});
      return;
    }
    if (!only_falling() ||
        !along_links_falling(model_, links, errors_.direction, velocity_, errors_.residual)) {
      kicks_.accelerations(whole, time, position_, velocity_, acceleration_, tension_);
      along_links_moving(links, errors_.direction, acceleration_, velocity_, errors_.residual);
    }
    system_.matrix->solve(errors_.residual);
    for (std::size_t i = 0; i < links.size(); ++i)
      tension_[links.link[i]] = errors_.residual[i] * links.length[i];
  }

  // Adds factor·W Cᵀ times the residual to some masses.
  void push(const Vectors& columns, Vectors& target, double factor, Extent masses) const {
    blocks_.push(model_, system_.links, columns, errors_.residual, target, factor, masses);
  }

  const Model& model_;
  int order_;
  HalfKicks kicks_;
  ActiveLimits limits_;
  JointResistance joints_;
  bool tension_of_velocities_;  // what stops and joints do is no part of the tension at acceleration level
  LinkSystem system_;
  ChainBlocks blocks_;
  AndersonMixing mixing_;
  std::vector<double> no_compliance_;
  Vectors factored_along_;  // directions whose symmetric matrix a net's factor holds
  Vectors half_velocity_, acceleration_;
  Vectors part_position_, part_velocity_;  // where a part of a step of order 4 begins
  LengthErrors errors_;
  bool direction_known_ = false;  // whether errors_.direction is that of where the next part of a step begins
  double shortest_ = 1.0, farthest_ = 0.0;  // length and, at first in a step, coordinate (m)
};

constexpr std::array<std::string_view, 2> orders{"2", "4"};
constexpr std::array rattle_params{
    steps_per_second_param(600.0),
    Param{"order", "", 0, 0, 0, false, orders,
          "order of accuracy; 4 makes three steps of order 2 a step, the middle one backwards"},
};

std::unique_ptr<Stepper> make_rattle(const Model& model, const Settings& settings, const Execution&) {
  return std::make_unique<RattleStepper>(model, settings.choice("order") == "4" ? 4 : 2);
}

std::string rattle_refusal(const Model& model, const State& start, const Settings& settings) {
  bool damped = model.drag > 0.0 || model.wind || !model.breakable_links.empty();
  for (const double damping : model.links.damping) damped = damped || damping > 0.0;
  if (settings.choice("order") == "4" && (damped || !model.limits.empty() || !model.joints.empty()))
    return "method rattle of order 4 has a step that runs backwards in time, which drag, damping, wind, "
           "breaking links and stops do not: use order 2 for this scene";
  return too_stiff(model, start, settings);
}

}  // namespace

Method rattle_method() {
  Capabilities can;
  can.family = Family::stormer_verlet;
  can.limit = StepLimit::sideways_vibration;
  can.takes_steps_back = true;
  can.stiffness = true;
  can.limits = true;
  can.one_sided = true;
  can.bending = true;
  can.most_limits = most_limits_solved_together;
  can.joints = true;
  can.break_stretch = true;
  can.break_tension = true;
  can.tension_order = 2;
  return {"rattle",
          "exact link lengths and link speeds, solved directly, order 2 or 4",
          "Andersen, Rattle (1983); Yoshida (1990)",
          rattle_params,
          can,
          {3.0, 10.0, 24.0, 2.8},
          make_rattle,
          rattle_refusal,
          bytes_of_rigid_links_factor};
}

}  // namespace taut
