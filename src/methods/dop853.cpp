// DOP853 at acceleration level: an explicit Runge–Kutta method of order 8 with step control (Hairer, Nørsett
// and Wanner, Solving Ordinary Differential Equations I, 1993, section II.10) of the equations of motion with
// the links' tensions in them (Equations), each step's end projected back onto the links (Hairer, Lubich and
// Wanner, Geometric Numerical Integration, 2006, section IV.4). It ends its steps exactly where a link breaks
// and where a stop on an angle is met or left (HighOrderStepper).
//
// Its error is proportional to its tolerance, and its steps to the eighth root of that: ten digits cost four
// times what two do. Links with stiffness are forces, and a stiff one makes its steps short.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "base/vector_operations.h"
#include "direct/solve_memory.h"
#include "high_order/stepper.h"
#include "methods/method.h"

namespace taut {
namespace {

constexpr std::array dop853_params{
    Param{"tolerance",
          "m",
          1e-6,
          1e-14,
          1.0,
          false,
          {},
          "error of a position that a step may make; of a velocity ten times that a second"},
};

std::unique_ptr<Stepper> make_dop853(const Model& model, const Settings& settings,
                                     const Execution& execution) {
  return std::make_unique<HighOrderStepper>(model, settings.number("tolerance"), execution.workers);
}

std::string dop853_refusal(const Model& model, const State& start, const Settings& settings) {
  const double farthest = largest_coordinate(start.position);
  const double least = 4.0 * std::numeric_limits<double>::epsilon() * farthest;
  if (settings.number("tolerance") < least)
    return fmt::format(
        "method dop853 can't tell positions of up to {:.3g} m apart within a tolerance below {:.1e} m",
        farthest, least);
  if (const Index link = redundant_link(model, start); link != no_link)
    return fmt::format(
        "the link {} says nothing that other rigid links do not say already: its tension is not to be known, "
        "and method dop853 needs it. Leave the link out or give it stiffness, or use xpbd or newton",
        link_name(model, link));
  return {};
}

}  // namespace

Method dop853_method() {
  Capabilities can;
  can.family = Family::acceleration;
  can.stiffness = true;
  can.limits = true;
  can.one_sided = true;
  can.bending = true;
  can.most_limits = most_limits_solved_together;
  can.break_stretch = true;
  can.break_tension = true;
  can.tension_order = 2;
  can.chooses_steps = true;
  can.keeps.energy = Keeping::within_tolerance;
  return {"dop853",
          "order 8 with step control: the accurate end, and the exact moment of breaks and stops",
          "Hairer, Nørsett and Wanner, Solving Ordinary Differential Equations I (1993)",
          dop853_params,
          can,
          {0.0, 10.0, 75.0, 1.8, 1500.0},
          make_dop853,
          dop853_refusal,
          bytes_of_rigid_links_factor};
}

}  // namespace taut
