#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/workers.h"
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

/// Methods that go about links alike: what one gets wrong the others may, too.
enum class Family {
  relaxation,      ///< links one by one, as positions
  stormer_verlet,  ///< forces at the ends of a step, and rigid links at their lengths
  implicit,        ///< all links together at the end of a step
  acceleration,    ///< accelerations with the tensions in them, integrated to high order
};

/// What theory says about a method's longest step, or about how it fails whatever the step.
enum class StepLimit {
  none,                ///< no limit
  spring_frequency,    ///< ω_max·h < 2 for the highest frequency of the springs
  sideways_vibration,  ///< h < √(m l/T) for rigid links of length l under tension T at a light mass m, and
                       ///< ω_max·h < 2 for springs
  kept_velocities,     ///< links don't stop what gravity adds to velocities: masses that hang gain (g t)²/2
};

/// What becomes of a quantity that nature keeps.
enum class Keeping {
  kept,              ///< momentum to rounding; energy without drift: it swings with the step and comes back
  lost_with_step,    ///< a loss that is in proportion to the step
  within_tolerance,  ///< a change that is in proportion to the method's tolerance
  not_kept,          ///< changes whatever the step
};

/// What becomes of each in free flight, and of energy wherever nothing damps.
struct Conservation {
  Keeping linear_momentum = Keeping::kept;
  Keeping angular_momentum = Keeping::kept;
  Keeping energy = Keeping::kept;
};

/// What a method can do beyond rigid links under gravity.
struct Capabilities {
  bool stiffness = false;  ///< links with stiffness and damping
  bool rigid = true;       ///< links without stiffness
  bool ground = false;     ///< half-spaces with friction and without rebound, touched by single masses
  bool limits = false;     ///< limits on angles
  bool one_sided = false;  ///< links that only pull or only push
  std::size_t most_limits =
      std::numeric_limits<std::size_t>::max();  ///< of both, where they are solved all together
  bool bending = false;                         ///< chains and sheets that resist bending
  bool joints = false;                          ///< joints with damping or friction
  bool colliders = false;                       ///< solids of any shape, rebound, bodies that touch
  bool faces = false;                           ///< faces of sheets that touch
  bool drag = true;
  bool break_stretch = false;
  bool break_tension = false;
  int tension_order =
      1;  ///< the order in h to which State::tension is right; 0: the method knows no tensions
  bool half_kicked =
      false;  ///< velocities hold half a kick that links have not answered; reports project them
  bool breaks_within_step = false;  ///< a step itself tests break_stretch on the links it solves
  /// Solves a step to the end, or can tell that it failed: then half the step may do, and so it may where a
  /// step made energy out of nothing. A step can be taken back.
  bool takes_steps_back = false;
  /// Makes steps as long as a tolerance allows, which end where a link comes to a threshold, and knows what
  /// is between their ends (Stepper::between). Its parameter is `tolerance` instead of `steps_per_second`.
  bool chooses_steps = false;
  Conservation keeps;
  Family family = Family::relaxation;
  StepLimit limit = StepLimit::none;
  Interpolation between_steps = Interpolation::hermite;  ///< how a frame between two steps is to be found
};

/// A method's parameters, each either a number or one of its choices. Made complete by complete_settings().
struct Settings {
  std::string method;
  std::map<std::string, std::variant<double, std::string>, std::less<>> values;

  double number(std::string_view name) const;
  std::string_view choice(std::string_view name) const;
  /// Of a method that does not choose its steps.
  double steps_per_second() const { return number("steps_per_second"); }
  bool chooses_steps() const { return !values.contains("steps_per_second"); }
};

enum class StepStatus {
  done,
  not_converged,         ///< the rounds ran out before the links were short enough
  direction_lost,        ///< a link turned by 90° or more within the step, or vanished
  factorisation_failed,  ///< the linear system is singular
  not_finite,            ///< a position or velocity is no longer a number
  energy_jump,           ///< the step made energy out of nothing, as the run that it belongs to found
  pressed_through,       ///< pins or solids press faces through each other
  crowded,               ///< more bodies touch than can be solved (most_near_pairs)
  chattering,            ///< stops are met and left again without end
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
  /// J, of this step alone: what solids that move, and pins that are moved, did by pushing and rubbing what
  /// touches them.
  double contact_work = 0.0;

  /// Adds another step's counts, and takes over its status and worst link.
  void add(const StepReport& other);
};

/// What a stepper runs on. It changes no bit of what it does.
struct Execution {
  std::shared_ptr<Workers> workers;  ///< null: the calling thread alone
};

/// What of a state is looked at after every step: positions and velocities of masses, and tensions of links.
struct Watched {
  std::vector<Index> masses, links;
};

/// The moving part of a method: one step at a time. It may keep what moves in a form and an order of its own;
/// what it remembers beyond a State never changes a bit of what it does.
class Stepper {
 public:
  virtual ~Stepper() = default;
  /// Takes a state over: to be called before the first step, and whenever a state has been changed from
  /// outside (a link has broken, say).
  virtual void load(const State& state) = 0;
  /// Moves on by h seconds, to `end_time` (h after the present one, but for rounding); a method with
  /// Capabilities::chooses_steps goes no further than that. A failed step leaves what store() gives as it
  /// was. Breaks no links, but for a method with Capabilities::breaks_within_step.
  virtual StepReport step(double h, double end_time) = 0;
  /// Takes the last step back; once after a step that succeeded, and only where
  /// Capabilities::takes_steps_back.
  virtual void undo() = 0;
  /// The state that the steps have come to, until the next call of any other function. It may first have to
  /// be made.
  virtual const State& store() = 0;

  /// The same, but where that would cost something tensions are those of an earlier step.
  virtual const State& motion() { return store(); }

  /// Where Capabilities::chooses_steps: the state at a time within the last step, and the links that have
  /// come to their thresholds at its end, which are to be broken before the next one.
  virtual State between(double) { return store(); }
  virtual std::span<const Index> breaking() const { return {}; }

  /// What glimpse() is to show from now on.
  virtual void watch(const Watched&) {}
  /// The same as store(), but where that would cost something the state is that of an earlier step beside
  /// time, pins, and what is watched.
  virtual const State& glimpse() { return store(); }
  /// The energy of the masses' motion and of gravity (J), where it costs less than store() and nothing else
  /// holds any: no springs, bends or limits.
  virtual std::optional<double> energy() { return std::nullopt; }
};

/// What a method costs on a usual processor (ns): what searches and charts predict times from before they
/// measure them.
struct Prices {
  double step = 10.0;       ///< a link, of every step
  double solve = 10.0;      ///< one of StepReport::link_solves, in chains and trees
  double net_solve = 10.0;  ///< the same in nets
  double factor = 0.0;      ///< of a net's factorisation, to be multiplied by rows^1.5
  double round = 0.0;       ///< one of StepReport::rounds, whatever the model
};

/// How finely settings make a method run, for people: "at 600 steps/s", or "within 1e-06 m a step".
std::string pace_text(const Settings& settings);

/// What a method keeps and loses, in a line for people.
std::string conservation_text(const Conservation& keeps);

/// One entry of the registry.
struct Method {
  std::string_view name;
  std::string_view title;   ///< one line, for people
  std::string_view source;  ///< paper or book
  std::span<const Param> params;
  Capabilities can;
  Prices prices;
  /// For a model and settings that refusals() has nothing against.
  std::unique_ptr<Stepper> (*make)(const Model&, const Settings&, const Execution&);
  /// What, beside the capabilities, the method refuses to do: a sentence, or nothing. Absent: it never
  /// refuses.
  std::string (*refusal)(const Model&, const State& start, const Settings&) = nullptr;
  /// About how much memory (bytes) a step takes beside model and states, of a method that solves all links
  /// together. Absent: next to none.
  double (*memory)(const Model&) = nullptr;
};

}  // namespace taut
