#pragma once

#include <vector>

#include "relax/relaxation.h"

namespace taut {

/// What a pass along the directions at the start of a step found.
struct AlongStart {
  double worst = 0.0;         ///< largest ||d|² − l²|/l² that it met; 0 unless asked for
  Index lost_link = no_link;  ///< a link that has turned by 90° or more, or is not finite …
  double lost_along = 0.0;    ///< … and its d·d₀ (m²)
  bool finite = true;         ///< whether the masses are, looked at in the last pass
  bool lost() const { return lost_link != no_link; }
};

/// Relaxation of rigid links along their directions at the start of the step: what shake does.
class AlongRelaxation final : public Relaxation<double> {
 public:
  AlongRelaxation(const Model& model, const Execution& execution)
      : Relaxation<double>(model, execution, Visits::rigid) {}

  /// One pass along the directions d₀ at `start`, the step's (SHAKE):
  ///   q = (|d|² − l²) / (2 (w_a + w_b) d·d₀),  x_a ← x_a − w_a q d₀,  x_b ← x_b + w_b q d₀,  λ ← λ + q
  /// `judged`: the result says how good lengths were. `motion`: as in pass().
  AlongStart pass_along(const Masses& start, Masses& position, PassPlace place, bool judged,
                        const FreeMotion<double>* motion = nullptr);

  /// These keep the multipliers of two steps before the present one, so that take_back() leaves those of a
  /// last step and of the one before it.
  void links_changed(const State& state);
  void begin_step(double h, double answer);
  void take_back();

  /// With T = scale·λ·l of the last step and T' the same of the step before: 2 T − T' of a link that is
  /// visited, and both 2 T − T' and T of all of them.
  double continued(Index link, double scale) const;
  void give_continued(double scale, std::vector<double>& continued, std::vector<double>& last) const;

 private:
  std::vector<AlongFound> found_;                                 // by each section
  AlignedVector<double> multiplier_before_, multiplier_earlier_;  // of the steps before
};

}  // namespace taut
