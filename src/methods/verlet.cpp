// Störmer–Verlet with mass-weighted relaxation (Jakobsen, Advanced Character Physics, 2001).
//
// In its own terms the method keeps the current and the previous position instead of a velocity,
//   x_{n+1} = 2 x_n − x_{n−1} + h² a,
// and then moves the ends of each link along it, d = x_a − x_b, until it has its length:
//   x_a ← x_a − w_a s d,  x_b ← x_b + w_b s d,   s = (|d| − l) / ((w_a + w_b) |d|).
// The same sequence of positions is had from position and velocity at the same time by half a kick, the
// drift, the relaxation, v = Δx/h, and half a kick:  x_{n+1} − x_n = (x_n − x_{n−1}) + h (h/2) a + h (h/2) a.
// That is how it stands here, so that a State means the same for every method. The velocity at the end still
// holds the last half kick, which the links have not answered yet: a mass at rest shows h·g/2. The tension is
// Σ s |d| over h (h/2 + that kick): h² but for the first step and where h has changed. Where a stop or a
// solid pushes, more passes may follow (pass_control.h).

#include <array>

#include "methods/method.h"
#include "parameters.h"
#include "relax/relaxation_stepper.h"

namespace taut {
namespace {

constexpr std::array verlet_params{steps_per_second_param(600.0), passes_param(1.0), impact_passes_param()};

std::unique_ptr<Stepper> make_verlet(const Model& model, const Settings& settings,
                                     const Execution& execution) {
  return make_relaxation_stepper(model, pass_counts(settings), Kicks::halves, execution);
}

}  // namespace

Method verlet_method() {
  Capabilities can;
  can.keeps = {Keeping::kept, Keeping::lost_with_step, Keeping::lost_with_step};
  can.half_kicked = true;
  can.ground = true;
  can.limits = true;
  can.one_sided = true;
  can.joints = true;
  can.colliders = true;
  can.faces = true;
  can.break_stretch = true;
  can.break_tension = true;
  return {"verlet",
          "Störmer–Verlet with mass-weighted relaxation",
          "Jakobsen, Advanced Character Physics (2001)",
          verlet_params,
          can,
          {2.0, 2.5, 2.5},
          make_verlet};
}

}  // namespace taut
