#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// One parameter of a method. With choices it is a word out of them, else a number in [min, max].
struct Param {
  std::string_view name;
  std::string_view unit;  ///< "" for a pure number
  double fallback = 0.0;
  double min = 0.0, max = 0.0;
  bool whole = false;                         ///< only whole numbers
  std::span<const std::string_view> choices;  ///< the first one is the default
  std::string_view help;
  std::string_view follows = {};  ///< left out, it takes the value given to this one, where there is one
};

/// What theory says about a method's longest step, or about how it fails whatever the step.
enum class StepLimit {
  none,                ///< no limit
  spring_frequency,    ///< ω_max·h < 2 for the highest frequency of the springs
  sideways_vibration,  ///< h < √(m l/T) for rigid links of length l under tension T at a light mass m, and
                       ///< ω_max·h < 2 for springs
  kept_velocities,     ///< links don't stop what gravity adds to velocities: masses that hang gain (g t)²/2
};

/// What a method can do beyond rigid links under gravity.
struct Capabilities {
  bool stiffness = false;  ///< links with stiffness and damping
  bool rigid = true;       ///< links without stiffness
  bool plane = false;      ///< a ground plane with friction
  bool limits = false;     ///< limits on angles
  bool colliders = false;  ///< solids of any shape, masses of some size, rebound, bodies that touch
  bool drag = true;
  bool break_stretch = false;
  bool break_tension = false;
  bool half_kicked =
      false;  ///< velocities hold half a kick that links have not answered; reports project them
  StepLimit limit = StepLimit::none;
  Interpolation between_steps = Interpolation::hermite;  ///< how a frame between two steps is to be found
};

/// A method's parameters, each either a number or one of its choices. Made complete by complete_settings().
struct Settings {
  std::string method;
  std::map<std::string, std::variant<double, std::string>, std::less<>> values;

  double number(std::string_view name) const;
  std::string_view choice(std::string_view name) const;
  double steps_per_second() const { return number("steps_per_second"); }
};

enum class StepStatus {
  done,
  not_converged,         ///< the rounds ran out before the links were short enough
  direction_lost,        ///< a link turned by 90° or more within the step, or vanished
  factorisation_failed,  ///< the linear system is singular
  not_finite,            ///< a position or velocity is no longer a number
  energy_jump,           ///< the step made energy out of nothing
};

/// What one step did. Counts add up over halved steps.
struct StepReport {
  StepStatus status = StepStatus::done;
  Index worst_link = no_link;    ///< where it failed, or the most strained link where the method knows it
  std::int64_t rounds = 0;       ///< passes or Newton rounds
  std::int64_t link_solves = 0;  ///< single links corrected, rows of a direct solve, or forces of springs
  std::int64_t factorisations = 0;
  std::int64_t halvings = 0;
  std::int64_t breaks = 0;  ///< links broken by the step itself

  /// Adds another step's counts, and takes over its status and worst link.
  void add(const StepReport& other);
};

/// The moving part of a method: one step at a time. A failed step leaves the State untouched.
class Stepper {
 public:
  virtual ~Stepper() = default;
  /// Moves the state on by h seconds. Does not change broken links, but for a method that breaks within the
  /// step.
  virtual StepReport step(State& state, double h) = 0;
  /// To be called once before the first step and again whenever links have broken outside step().
  virtual void links_changed(const State& state) = 0;
  /// True when step() itself tests break_stretch on the links it solves.
  virtual bool breaks_within_step() const { return false; }
  /// Whether a step that makes energy out of nothing fails, as it does until told otherwise, or is taken.
  /// Without effect on methods that never look.
  virtual void watch_energy(bool /*on*/) {}
};

/// One entry of the registry.
struct Method {
  std::string_view name;
  std::string_view title;   ///< one line, for people
  std::string_view source;  ///< paper or book
  std::span<const Param> params;
  Capabilities can;
  std::unique_ptr<Stepper> (*make)(const Model&, const Settings&);
};

}  // namespace taut
