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
// pass a step without damping runs to infinity on a large sheet. With `relax` = "lines" those that follow
// each other in rows, columns, diagonals and chains are solved together, line after line (line_relaxation.h):
// where a pull has to come down a hung sheet or along a chain, one pass does what takes many link by link. So
// a tension is there in full, along n of before masses are put back: sideways vibrations of frequency ω grow
// where h² ω² > 4/3 (test LineRelaxation.SidewaysVibrationsSetTheLongestStep). Limits on angles and contacts
// with solids follow the links in every pass; where one pushes, more passes may follow (pass_control.h).

#include <array>

#include "methods/method.h"
#include "parameters.h"
#include "relax/relaxation_stepper.h"

namespace taut {
namespace {

constexpr std::array<std::string_view, 2> precisions{"double", "single"};
constexpr std::array<std::string_view, 2> relax_choices{"links", "lines"};
constexpr std::array xpbd_params{
    steps_per_second_param(600.0),
    passes_param(1.0),
    impact_passes_param(),
    Param{"precision", "", 0, 0, 0, false, precisions,
          "of positions and velocities; single is quicker, and shows what rounding does"},
    Param{"relax", "", 0, 0, 0, false, relax_choices,
          "links one after another, or lines of links that follow each other, each line exactly and at once"},
};

std::unique_ptr<Stepper> make_xpbd(const Model& model, const Settings& settings, const Execution& execution) {
  const PassCounts passes = pass_counts(settings);
  if (settings.choice("precision") == "single")
    return make_single_relaxation_stepper(model, passes, Kicks::whole, execution);
  return settings.choice("relax") == "lines"
             ? make_line_relaxation_stepper(model, passes, Kicks::whole, execution)
             : make_relaxation_stepper(model, passes, Kicks::whole, execution);
}

std::string xpbd_refusal(const Model& model, const State&, const Settings& settings) {
  const bool single = settings.choice("precision") == "single";
  if (single && settings.choice("relax") == "lines")
    return "method xpbd solves lines of links in double precision alone: use precision = \"double\" with "
           "relax = \"lines\", or relax = \"links\"";
  const bool more = !model.limits.empty() || !model.bends.empty() || !touches_only_ground(model) ||
                    !model.faces.empty() || !model.joints.empty() || model.wind;
  if (!single || !more) return {};
  return "method xpbd in single precision knows no limits on angles, no joints that resist, no solids but "
         "the "
         "ground, no touching bodies, no faces and no wind: use precision = \"double\" for this scene";
}

}  // namespace

Method xpbd_method() {
  Capabilities can;
  can.keeps = {Keeping::kept, Keeping::lost_with_step, Keeping::lost_with_step};
  can.stiffness = true;
  can.ground = true;
  can.limits = true;
  can.one_sided = true;
  can.bending = true;
  can.joints = true;
  can.colliders = true;
  can.faces = true;
  can.break_stretch = true;
  can.break_tension = true;
  return {"xpbd",
          "compliant position-based dynamics in small steps",
          "Macklin et al., XPBD (2016); Small Steps in Physics Simulation (2019)",
          xpbd_params,
          can,
          {2.0, 2.5, 2.5},
          make_xpbd,
          xpbd_refusal};
}

}  // namespace taut
