#include "methods/method.h"

namespace taut {

double Settings::number(std::string_view name) const {
  return std::get<double>(values.find(name)->second);
}

std::string_view Settings::choice(std::string_view name) const {
  return std::get<std::string>(values.find(name)->second);
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
