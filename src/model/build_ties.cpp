#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "builder.h"
#include "name_patterns.h"

namespace taut {
namespace {

class TieMaker {
 public:
  TieMaker(Builder& builder, std::vector<Problem>& problems)
      : builder_(builder), names_(builder.model.masses), problems_(problems) {}

  void add(const TieSpec& spec, std::size_t index) {
    constexpr double most_pairs = 5e8;  // so that nobody waits for long
    index_ = index;
    if (spec.every < 1) return;  // that is said already
    const std::vector<Index> tied = masses_of("a", spec.a), others = masses_of("b", spec.b);
    if (tied.empty() || others.empty()) return;
    const std::size_t steps = tied.size() - 1;
    const auto every = static_cast<std::size_t>(spec.every);
    if (steps % every != 0)
      return report("every",
                    fmt::format("every = {} does not divide {}, one less than the {} masses that \"{}\" "
                                "names: its last one would hang loose",
                                every, steps, tied.size(), spec.a));
    if (static_cast<double>(tied.size()) * static_cast<double>(others.size()) > most_pairs)
      return report("b",
                    fmt::format("{} masses, each tied to the nearest of {}, are too many to look through",
                                tied.size(), others.size()));
    for (std::size_t i = 0; i < tied.size(); i += every)
      if (!tie(tied[i], nearest(tied[i], others), spec.properties)) return;
  }

 private:
  void report(std::string key, std::string message, std::string suggestion = {}) {
    problems_.push_back({"tie", index_, std::move(key), std::move(message), std::move(suggestion)});
  }

  std::vector<Index> masses_of(const std::string& key, const std::string& pattern) {
    std::vector<Index> found = names_.fitting(pattern);
    if (found.empty())
      report(key, fmt::format("no mass is named \"{}\"", pattern),
             nearest_mass(pattern, builder_.model.masses, problems_));
    return found;
  }

  Index nearest(Index mass, const std::vector<Index>& others) const {
    const Vec3 place = builder_.start.position.at(mass);
    const auto distance = [&](Index other) {
      return (builder_.start.position.at(other) - place).squaredNorm();
    };
    return *std::ranges::min_element(others, {}, distance);
  }

  // False where they can't be tied, which is said once.
  bool tie(Index a, Index b, const LinkProperties& properties) {
    const std::vector<std::string>& name = builder_.model.masses.name;
    if (a == b) {
      report("b", fmt::format("\"{}\" would be tied to itself", name[a]));
      return false;
    }
    const double apart = (builder_.start.position.at(a) - builder_.start.position.at(b)).norm();
    if (!(apart >= smallest_divisor)) {
      report("b",
             fmt::format("\"{}\" and \"{}\" are at the same point, so their tie has no length; lay one of "
                         "them a link's length beside the other",
                         name[a], name[b]));
      return false;
    }
    builder_.add_link(a, b, apart, properties);
    return true;
  }

  Builder& builder_;
  NamePatterns names_;
  std::vector<Problem>& problems_;
  std::size_t index_ = 0;
};

}  // namespace

void add_ties(Builder& builder, const std::vector<TieSpec>& specs, std::vector<Problem>& problems) {
  if (specs.empty()) return;
  TieMaker maker(builder, problems);
  for (std::size_t i = 0; i < specs.size(); ++i) {
    builder.begin_entry("tie", i);
    maker.add(specs[i], i);
  }
}

}  // namespace taut
