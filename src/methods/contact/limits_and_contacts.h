#pragma once

#include "contact/body_contacts.h"
#include "contact/contact_solver.h"
#include "contact/face_contacts.h"
#include "methods/method.h"
#include "relax/bend_solver.h"
#include "relax/limit_solver.h"

namespace taut {

/// What a relaxation method solves beside its links, the same for each of them: bends, limits on angles,
/// bodies that touch, faces, solids, and the ground.
class LimitsAndContacts {
 public:
  LimitsAndContacts(const Model& model, const Execution& execution)
      : bends_(model),
        limits_(model),
        bodies_(model),
        faces_(model, execution.workers),
        contacts_(model),
        none_(model.limits.empty() && model.contacts.empty() && model.bends.empty() && model.faces.empty()) {
    for (const Collider& collider : model.colliders) rebounds_ = rebounds_ || collider.restitution > 0.0;
  }

  /// To be called before the first step and whenever links have broken.
  void links_changed(const State& state) {
    bends_.links_changed(state);
    limits_.links_changed(state);
    faces_.links_changed(state);
  }

  /// To be called once positions of the step have been predicted, in place of those of the state, whose time
  /// is that of the start; the positions at its start, which must stay where they are until keep().
  void begin_step(const Vectors& start, const State& predicted, double end_time) {
    bends_.begin_step();
    limits_.begin_step();
    bodies_.begin_step(predicted.static_friction.bodies, start, predicted.position);
    faces_.begin_step(start, predicted.position, predicted.time, end_time);
    contacts_.begin_step(predicted.static_friction.solids, start, predicted.velocity, predicted.position,
                         predicted.time, end_time);
  }

  /// Whether there are none of them: then solve() need not be called.
  bool none() const { return none_; }

  /// One pass, to follow that over the links. `answer` is what a mass moves by beside its inverse mass: 1/(1
  /// + h·drag) where drag is implicit in all forces.
  void solve(double h, double answer, Vectors& position) {
    bends_.solve(h, answer, position);
    limits_.solve(position, h, answer);
    bodies_.solve(position);
    faces_.solve(position);
    contacts_.solve(position);
  }

  /// To be called after the last pass: sees to it that no faces have passed through anything. False: that
  /// can't be had.
  bool finish(Vectors& position) { return faces_.finish(position); }

  /// Whether more bodies touch than can be solved: the step is none then.
  bool crowded() const { return bodies_.crowded(); }

  /// Whether velocities may have jumped in this step, or at the end of the one before: a stop has pushed,
  /// something has touched, or something may have rebounded.
  bool may_jump() const {
    return rebounds_ || limits_.pushed() || bodies_.touched() || faces_.touched() || contacts_.touched();
  }

  /// Once velocities have been derived from positions.
  void rebound(double h, const Vectors& position, Vectors& velocity) {
    contacts_.rebound(h, position, velocity);
  }

  /// StepReport::contact_work of a step of h seconds, once all that is done.
  double contact_work(double h) const { return bodies_.work(h) + faces_.work(h) + contacts_.work(h); }

  /// Once the step has been made.
  void keep(State& state) const {
    bodies_.keep(state.position, state.static_friction.bodies);
    contacts_.keep(state.position, state.static_friction.solids);
  }

  /// The tensions of one-sided links (N), see LimitSolver.
  void give_tensions(double scale, std::vector<double>& tension) const {
    limits_.give_tensions(scale, tension);
  }

  /// Limits and bends solved in a pass.
  std::int64_t size() const { return limits_.size() + bends_.size(); }

 private:
  BendSolver bends_;
  LimitSolver limits_;
  BodyContacts bodies_;
  FaceContacts faces_;
  ContactSolver contacts_;
  bool none_;
  bool rebounds_ = false;  // whether any solid gives something back
};

}  // namespace taut
