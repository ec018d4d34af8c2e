#include "base/digits.h"

#include <fmt/format.h>

#include <cmath>

namespace taut {

std::string two_digits(double number) {
  const std::string shortest = fmt::format("{:.2g}", number);
  return number >= 10.0 ? fmt::format("{:.0f}", std::stod(shortest)) : shortest;
}

std::string percent(double share) {
  return share < 1e-6 ? "below 0.0001 %" : two_digits(100.0 * share) + " %";
}

}  // namespace taut
