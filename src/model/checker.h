#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/nearest.h"
#include "model/description.h"

namespace taut {

/// Collects what is wrong with one entry after another.
class Checker {
 public:
  void enter(std::string_view section, std::size_t index) {
    section_ = section;
    index_ = index;
  }
  void require(bool holds, std::string_view key, std::string message) {
    if (!holds) problems.push_back({section_, index_, std::string(key), std::move(message), ""});
  }
  /// The same of a name, with the one that may have been meant.
  void require_named(bool holds, std::string_view key, std::string message, std::string_view nearest) {
    if (!holds)
      problems.push_back({section_, index_, std::string(key), std::move(message), std::string(nearest)});
  }
  void positive(double value, std::string_view key, std::string_view unit) {
    require(std::isfinite(value) && value > 0.0, key,
            fmt::format("{} must be above 0 {}, not {}", key, unit, value));
    not_nearly_zero(value, key);
  }
  void not_nearly_zero(double value, std::string_view key) {
    require(!(value > 0.0 && value < smallest_divisor), key,
            fmt::format("{} must not be so near 0: {} is smaller than {}", key, value, smallest_divisor));
  }
  /// Whether two places are far enough apart to tell in which direction.
  static bool apart(const Vec3& a, const Vec3& b) { return (a - b).norm() >= smallest_divisor; }
  void not_negative(double value, std::string_view key, std::string_view unit) {
    require(std::isfinite(value) && value >= 0.0, key,
            fmt::format("{} must be 0 {} or more, not {}", key, unit, value));
  }
  void finite(const Vec3& value, std::string_view key) {
    require(value.allFinite(), key, fmt::format("{} must have finite numbers", key));
  }
  void name(const std::string& name) {
    require(!name.empty(), "name", "name must not be empty");
    require(name.find_first_of(".* ") == std::string::npos, "name",
            fmt::format("name \"{}\" must not contain a dot, a star or a space", name));
    const auto [seen, is_new] =
        names_.try_emplace(name, fmt::format("[[{}]] number {}", section_, index_ + 1));
    require(is_new, "name", fmt::format("the name \"{}\" is taken by {}", name, seen->second));
  }
  void properties(const LinkProperties& properties, std::string_view prefix = "") {
    const auto key = [&](std::string_view name) { return fmt::format("{}{}", prefix, name); };
    const bool between = properties.acts == LinkAction::between;
    require(between == properties.longest.has_value(), key("longest"),
            between ? "a link that acts \"between\" needs the key \"longest\""
                    : "longest is only for links that act \"between\" two lengths");
    if (properties.longest)
      require(std::isfinite(*properties.longest) && *properties.longest > 1.0, key("longest"),
              fmt::format("longest must be above 1, not {}", *properties.longest));
    require(properties.acts == LinkAction::both || properties.damping == 0.0, key("damping"),
            "damping is only for links that act both ways");
    if (properties.stiffness) positive(*properties.stiffness, key("stiffness"), "N/m");
    not_negative(properties.damping, key("damping"), "N s/m");
    require(properties.damping == 0.0 || properties.stiffness.has_value(), key("damping"),
            "damping needs a stiffness: a rigid link has no speed to damp");
    if (properties.break_stretch)
      require(std::isfinite(*properties.break_stretch) && *properties.break_stretch > 1.0,
              key("break_stretch"),
              fmt::format("break_stretch must be above 1, not {}", *properties.break_stretch));
    if (properties.break_tension) positive(*properties.break_tension, key("break_tension"), "N");
    if (properties.break_at) positive(*properties.break_at, key("break_at"), "s");
    require(properties.scatter >= 0.0 && properties.scatter < 1.0, key("scatter"),
            fmt::format("scatter must be from 0 to below 1, not {}", properties.scatter));
    require(properties.scatter == 0.0 || properties.break_stretch || properties.break_tension, key("scatter"),
            "scatter is of break_stretch or break_tension, and there is neither");
    require(properties.scatter_seed >= 0, key("scatter_seed"),
            fmt::format("scatter_seed must be 0 or more, not {}", properties.scatter_seed));
  }
  /// Of the times of a list, one after another; `last` is -infinity before the first.
  void later(double time, double& last, std::string_view key, std::string_view what) {
    require(std::isfinite(time) && time > last, key, fmt::format("{} must increase", what));
    last = time;
  }
  void release(const std::optional<double>& time, bool pinned, std::string_view key) {
    if (!time) return;
    positive(*time, key, "s");
    require(pinned, key, fmt::format("{} is only for what is pinned", key));
  }
  void motion(const MotionSpec& motion, bool pinned, std::string_view key) {
    if (!motion.sinusoid && motion.path.empty() && motion.with.empty()) return;
    require(pinned, key, fmt::format("{} is only for a pinned mass", key));
    way(motion.sinusoid, motion.path, key);
    if (!motion.with.empty()) carried_by(motion.with, key);
  }
  void way(const std::optional<SinusoidSpec>& sinusoid, const std::vector<Knot>& path, std::string_view key) {
    require(!sinusoid || path.empty(), key,
            fmt::format("{} has both an amplitude and a path; it can be only one of them", key));
    if (sinusoid) {
      finite(sinusoid->amplitude, key);
      require(std::isfinite(sinusoid->angular_frequency) && std::isfinite(sinusoid->phase), key,
              fmt::format("{} must have finite numbers", key));
    }
    double last = -infinity;
    for (const Knot& knot : path) {
      later(knot.time, last, key, fmt::format("{}: times", key));
      finite(knot.position, key);
    }
    for (std::size_t i = 1; i < path.size(); ++i) no_jump(path[i - 1], path[i], key);
  }
  /// Solids that have a name, which may carry pins.
  void know_solids(const Description& description) {
    const auto add = [this](const auto& specs) {
      for (const auto& spec : specs)
        if (!spec.moves.name.empty()) solids_.push_back(spec.moves.name);
    };
    add(description.planes);
    add(description.spheres);
    add(description.capsules);
    add(description.boxes);
    add(description.mesh_solids);
  }

  std::vector<Problem> problems;

 private:
  void no_jump(const Knot& from, const Knot& to, std::string_view key) {
    constexpr double fastest = 1e4;  // m/s: nothing that anyone drives
    const double speed = (to.position - from.position).norm() / (to.time - from.time);
    require(!(to.time > from.time) || speed <= fastest, key,
            fmt::format("{}: between {} s and {} s the path goes {:.4g} m, at {:.4g} m/s: that is a jump",
                        key, from.time, to.time, (to.position - from.position).norm(), speed));
  }
  void carried_by(const std::string& solid, std::string_view key) {
    const bool known = std::ranges::find(solids_, solid) != solids_.end();
    if (known) return;
    const std::vector<std::string_view> names(solids_.begin(), solids_.end());
    problems.push_back({section_, index_, std::string(key), fmt::format("no solid is named \"{}\"", solid),
                        std::string(nearest_name(solid, names))});
  }

  std::string section_;
  std::size_t index_ = 0;
  std::vector<std::string> solids_;
  std::unordered_map<std::string, std::string> names_;
};

/// Checks every entry of a section.
template <typename Spec>
void check_each(Checker& check, std::string_view section, const std::vector<Spec>& specs,
                void (*check_one)(Checker&, const Spec&)) {
  for (std::size_t i = 0; i < specs.size(); ++i) {
    check.enter(section, i);
    check_one(check, specs[i]);
  }
}

/// Adds what is wrong with limits on angles and with ragdolls.
void check_bodies(Checker& check, const Description& description);

/// Adds what is wrong with meshes and points, whose files have been read.
void check_files(Checker& check, const Description& description);

/// Adds what is wrong with solids and the wind.
void check_surroundings(Checker& check, const Description& description);

}  // namespace taut
