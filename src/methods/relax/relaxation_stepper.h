#pragma once

#include <memory>

#include "methods/method.h"
#include "parameters.h"

namespace taut {

/// When gravity, loads and drag act in a step: in one kick before masses drift (xpbd.cpp), links answering
/// drag as well; or in half a kick before and half a kick after (verlet.cpp).
enum class Kicks { whole, halves };

/// The steps of xpbd and verlet: kick, drift, passes over the links along their present directions, and
/// velocities from positions.
std::unique_ptr<Stepper> make_relaxation_stepper(const Model& model, PassCounts passes, Kicks kicks,
                                                 const Execution& execution);

/// The same with lines of links solved at once, line after line (line_relaxation.h).
std::unique_ptr<Stepper> make_line_relaxation_stepper(const Model& model, PassCounts passes, Kicks kicks,
                                                      const Execution& execution);

/// The same, link by link, with positions, velocities and multipliers in single precision, as engines for
/// games and graphics processors have them. Half a unit in the last place of a position, ε|x|/2 with ε =
/// 2⁻²³, is all that a step can tell: the fall by gravity within one step, g h², is lost in it when h is
/// below √(ε|x|/2g), and velocities, Δx/h, carry noise of ε|x|/h.
std::unique_ptr<Stepper> make_single_relaxation_stepper(const Model& model, PassCounts passes, Kicks kicks,
                                                        const Execution& execution);

}  // namespace taut
