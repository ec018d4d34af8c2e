#pragma once

#include <vector>

#include "model/model.h"
#include "parameters.h"

namespace taut {

/// Decides how many passes a relaxation method makes in a step.
///
/// Where motion is smooth, one pass a step is enough: what it leaves of the links' lengths is of second order
/// in the step, and the next steps put it right. Where a stop or a solid pushes, velocities may jump, and a
/// pass leaves v h: spread over the steps to come, that jump would end as another one, however short they
/// are. So passes then go on until no rigid link is further off than twice what the worst was at the start of
/// the step, or than twice what gravity moves a mass by in it: the jump is answered by all links at once, but
/// for an error of the order of h in velocities. What merely lies or leans stays below that with the ordinary
/// passes. Links with stiffness need none of this: in short steps their answer is a force, not a jump.
class PassControl {
 public:
  PassControl(const Model& model, PassCounts counts) : model_(model), counts_(counts) {}

  /// The links that are solved.
  void links_changed(const std::vector<Index>& links);

  /// Whether another pass is due after so many. `may_jump`: something has pushed in this step; `start` and
  /// `position` are those at its start and now.
  bool another(int made, bool may_jump, const Vectors& start, const Vectors& position, double h) const {
    if (made < counts_.ordinary) return true;
    return made < counts_.impact && may_jump && jump_remains(start, position, h);
  }

 private:
  bool jump_remains(const Vectors& start, const Vectors& position, double h) const;
  double farthest_off(const Vectors& position) const;

  const Model& model_;
  PassCounts counts_;
  std::vector<Index> rigid_;
};

}  // namespace taut
