#pragma once

#include <memory>
#include <span>
#include <vector>

#include "direct/limit_border.h"
#include "direct/link_system.h"
#include "forces/springs.h"
#include "high_order/chain_motion.h"
#include "high_order/phase_sums.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// The equations of motion at acceleration level (index reduction): with d·d̈ + |ḋ|² = 0 in every whole rigid
/// link, the second derivative of |d|² = l², the multipliers follow from
///   (J W Jᵀ) λ = J a_free + |ḋ|²,    a = a_free − W Jᵀ λ,
/// where a_free holds gravity, loads, drag, wind, links with stiffness, soft stops that are held, and the
/// driven pins' accelerations. A hard stop that is held is a row more, with θ̈ = G a + Ġ v = 0. Contacts and
/// the resistance of joints are left out.
class Equations {
 public:
  /// For the links that are whole in `state`.
  Equations(const Model& model, const State& state, const std::shared_ptr<Workers>& workers = nullptr);

  /// The stops that are held from now on.
  void hold(const std::vector<HeldStop>& stops);

  /// Accelerations (m/s²) of all masses for positions and velocities at a time; pins get those of their
  /// motion. False when the links' system is singular, or something is not finite.
  bool evaluate(double time, const Vectors& position, const Vectors& velocity, Vectors& acceleration);
  /// The same for positions and velocities that are sums, but for driven pins, which are where they belong.
  bool evaluate(double time, const PhaseSums& at, Vectors& acceleration);

  /// The multipliers of the last evaluation as tensions (N) in their links, one a link of the model; 0
  /// elsewhere.
  void write_tensions(std::vector<double>& tension) const;
  /// What the held hard stops push with (N m), in the order of hold(); negative where they would pull.
  std::span<const double> pushes() const { return pushes_; }

  /// Moves positions onto the links' lengths and the held hard stops, and then takes from velocities what
  /// those don't allow: as little as can be, in the metric of mass. What already fits stays bit for bit.
  /// False where it can't be done; worst_link() is then the one furthest off.
  bool project(Vectors& position, Vectors& velocity);

  /// Which stops are held: of those that are touched at these positions, velocities first lose what goes into
  /// a hard one (a plastic impulse, spread over all links and stops at once), and then those are held that
  /// push, and soft ones that are pressed. Those that leave with less than `slow` (rad/s) count as at rest.
  /// Calls hold() with them. False where no such set is found.
  bool settle(double time, const Vectors& position, double slow, Vectors& velocity,
              std::vector<HeldStop>& held);

  Index worst_link() const { return worst_link_; }
  std::size_t rows() const { return system_.links.size(); }

 private:
  bool freely() const { return chains_ && hard_.empty() && soft_.empty(); }
  bool factor(const Vectors& position);
  bool solve(const std::vector<LimitRow>& stops, std::vector<double>& multipliers);
  void take(const std::vector<LimitRow>& stops, Vectors& from);
  std::vector<LimitRow> hard_rows(const std::vector<HeldStop>& stops, const Vectors& position) const;
  void free_motion(double time, const Vectors& position, const Vectors& velocity, Vectors& acceleration);
  double length_residual(const Vectors& position);
  double stop_residual(const Vectors& position);
  bool project_positions(Vectors& position);
  bool project_chains(const Vectors& position, Vectors& velocity);
  bool project_velocities(const Vectors& position, Vectors& velocity);
  void write_reach(const HeldStop& stop, double push, std::vector<double>& tension) const;
  template <class Wanted>
  bool answer(const std::vector<LimitRow>& touched, const Wanted& wanted, const std::vector<double>& links,
              std::vector<bool>& pushing, Vectors& u);

  const Model& model_;
  State whole_;  // for what is broken in it
  LinkSystem system_;
  Springs springs_;
  std::unique_ptr<ChainMotion> chains_;  // null where other equations hold
  LimitBorder border_;
  std::vector<HeldStop> hard_, soft_;
  std::vector<double> no_compliance_;
  bool factored_ = false;
  Index worst_link_ = no_link;
  // Room for an evaluation.
  Phase phase_;
  Vectors direction_;
  std::vector<double> multipliers_, spring_tension_, pushes_, soft_pushes_, strength_;
  std::vector<LimitRow> rows_;
};

/// What tells that rigid links say the same twice, at the positions of a state: the first of them, in the
/// order of a factorisation, that those before it leave no say. no_link where none is.
Index redundant_link(const Model& model, const State& state);

}  // namespace taut
