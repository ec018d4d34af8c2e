#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "builder.h"

namespace taut {
namespace {

// At the start an angle may be this far outside, so that a range may end where the angle begins.
constexpr double rounding = 1e-9;  // rad

// Builds limits one after another and reports what is wrong with them.
class LimitBuilder {
 public:
  LimitBuilder(Builder& builder, const MassesByName& by_name, std::vector<Problem>& problems)
      : builder_(builder), by_name_(by_name), problems_(problems) {
    for (const Problem& problem : problems) unsound_.emplace(problem.section, problem.index);
  }

  void enter(std::string_view section, std::size_t index) {
    section_ = section;
    index_ = index;
    sound_ = !unsound_.contains({section_, index_});
  }

  void add(const AngleSpec& spec) {
    Limit limit{LimitKind::angle, 3, {}, Vec3::UnitX(), spec.min * degree, spec.max * degree,
                spec.compliance};
    if (!sound_ || !find(spec.masses, "masses", limit, 0)) return;
    apart(limit, 0, 1, "masses");
    apart(limit, 2, 1, "masses");
    finish(limit, "min", "max");
  }

  void add(const HingeSpec& spec) {
    Limit limit{LimitKind::hinge, 5, {}, Vec3::UnitX(), spec.min * degree, spec.max * degree,
                spec.compliance};
    if (!sound_ || !find(spec.masses, "masses", limit, 0) || !find(spec.axis, "axis", limit, 3)) return;
    apart(limit, 3, 4, "axis");
    if (sound_) {
      off_axis(limit, 0);
      off_axis(limit, 2);
    }
    finish(limit, "min", "max");
  }

  void add(const ConeSpec& spec) {
    Limit limit{LimitKind::cone, 6, {}, Vec3::UnitX(), 0.0, spec.half_angle * degree, spec.compliance};
    if (!sound_ || !find(spec.frame, "frame", limit, 0) || !find(spec.limb, "limb", limit, 3)) return;
    if (spec.limb.size() == 2) limit.masses[5] = limit.masses[4];
    const Vec3 o = place(limit, 0), first = place(limit, 1) - o, second = place(limit, 2) - o;
    require(first.cross(second).norm() > 1e-9 * first.norm() * second.norm(), "frame",
            "the masses of the frame lie on one line, so it has no directions");
    require((0.5 * (place(limit, 4) + place(limit, 5)) - place(limit, 3)).norm() > 0.0, "limb",
            "the limb begins and ends at the same point, so it has no direction");
    if (!sound_) return;
    limit.axis = frame_axes(o, o + first, o + second).transpose() * spec.axis.normalized();
    finish(limit, "half_angle", "half_angle");
  }

 private:
  Vec3 place(const Limit& limit, std::size_t slot) const {
    return builder_.start.position.at(limit.masses[slot]);
  }
  const std::string& name(const Limit& limit, std::size_t slot) const {
    return builder_.model.masses.name[limit.masses[slot]];
  }

  void require(bool holds, std::string_view key, std::string message, std::string suggestion = "") {
    if (holds) return;
    problems_.push_back({section_, index_, std::string(key), std::move(message), std::move(suggestion)});
    sound_ = false;
  }

  bool find(const std::vector<std::string>& names, std::string_view key, Limit& limit, std::size_t slot) {
    for (const std::string& each : names) {
      const auto found = by_name_.find(each);
      require(found != by_name_.end(), key, fmt::format("no mass is named \"{}\"", each),
              found != by_name_.end() ? "" : nearest_mass(each, builder_.model.masses, problems_));
      if (found != by_name_.end()) limit.masses[slot++] = found->second;
    }
    return sound_;
  }

  void apart(const Limit& limit, std::size_t i, std::size_t j, std::string_view key) {
    require((place(limit, i) - place(limit, j)).norm() >= smallest_divisor, key,
            fmt::format("\"{}\" and \"{}\" are at the same point, so there is no direction", name(limit, i),
                        name(limit, j)));
  }

  void off_axis(const Limit& limit, std::size_t slot) {
    const Vec3 lever = place(limit, slot) - place(limit, 1);
    const Vec3 axis = (place(limit, 4) - place(limit, 3)).normalized();
    require(lever.cross(axis).norm() > 1e-9 * (place(limit, 4) - place(limit, 3)).norm(), "masses",
            fmt::format("\"{}\" lies on the hinge's axis, so its angle about it is none", name(limit, slot)));
  }

  void finish(const Limit& limit, std::string_view min_key, std::string_view max_key) {
    if (!sound_) return;
    const double angle = limit_angle(limit, builder_.start.position);
    const Overshoot beyond = overshoot(limit, angle);
    require(beyond.size <= rounding, beyond.sign > 0.0 ? max_key : min_key,
            fmt::format("at the start the angle is {:.4g} degrees, outside its range of {:.4g} to {:.4g}",
                        angle / degree, limit.min / degree, limit.max / degree));
    if (sound_) builder_.model.limits.push_back(limit);
  }

  Builder& builder_;
  const MassesByName& by_name_;
  std::vector<Problem>& problems_;
  std::set<std::pair<std::string, std::size_t>> unsound_;  // entries, before limits are looked at
  std::string section_;
  std::size_t index_ = 0;
  bool sound_ = true;
};

template <typename Spec>
void add_each(LimitBuilder& limits, std::string_view section, const std::vector<Spec>& specs) {
  for (std::size_t i = 0; i < specs.size(); ++i) {
    limits.enter(section, i);
    limits.add(specs[i]);
  }
}

}  // namespace

void add_limits(Builder& builder, const Description& description, const MassesByName& by_name,
                std::vector<Problem>& problems) {
  LimitBuilder limits(builder, by_name, problems);
  add_each(limits, "angle", description.angles);
  add_each(limits, "hinge", description.hinges);
  add_each(limits, "cone", description.cones);
}

}  // namespace taut
