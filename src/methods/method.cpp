#include "methods/method.h"

#include <fmt/format.h>

namespace taut {

double Settings::number(std::string_view name) const {
  return std::get<double>(values.find(name)->second);
}

std::string_view Settings::choice(std::string_view name) const {
  return std::get<std::string>(values.find(name)->second);
}

std::string pace_text(const Settings& settings) {
  return settings.chooses_steps() ? fmt::format("within {:g} m a step", settings.number("tolerance"))
                                  : fmt::format("at {:g} steps/s", settings.steps_per_second());
}

std::string conservation_text(const Conservation& keeps) {
  const auto momentum = [](Keeping keeping) {
    switch (keeping) {
      case Keeping::kept:
        return "kept to rounding";
      case Keeping::lost_with_step:
        return "lost in proportion to the step";
      case Keeping::within_tolerance:
        return "kept within the tolerance";
      case Keeping::not_kept:
        break;
    }
    return "not kept";
  };
  const std::string_view energy =
      keeps.energy == Keeping::kept ? "swings without drift" : momentum(keeps.energy);
  return fmt::format("linear momentum {}, angular momentum {}, energy {}", momentum(keeps.linear_momentum),
                     momentum(keeps.angular_momentum), energy);
}

void StepReport::add(const StepReport& other) {
  status = other.status;
  worst_link = other.worst_link;
  rounds += other.rounds;
  link_solves += other.link_solves;
  factorisations += other.factorisations;
  halvings += other.halvings;
  breaks += other.breaks;
}

}  // namespace taut
