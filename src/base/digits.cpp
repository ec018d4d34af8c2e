#include "base/digits.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string_view>

namespace taut {
namespace {

std::string raised(std::string_view digits) {
  constexpr std::array<std::string_view, 10> small{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : digits) text += c == '-' ? "⁻" : small[static_cast<std::size_t>(c - '0')];
  return text;
}

}  // namespace

std::string two_digits(double number) {
  const std::string shortest = fmt::format("{:.2g}", number);
  return number >= 10.0 ? fmt::format("{:.0f}", std::stod(shortest)) : shortest;
}

std::string percent(double share) {
  return share < 1e-6 ? "below 0.0001 %" : two_digits(100.0 * share) + " %";
}

std::string with_power_of_ten(double number) {
  const std::string text = fmt::format("{:g}", number);
  const std::size_t e = text.find('e');
  if (e == std::string::npos) return text;
  const std::string digits = text.substr(0, e),
                    power = raised(fmt::format("{}", std::stoi(text.substr(e + 1))));
  return digits == "1" ? "10" + power : digits + "·10" + power;
}

}  // namespace taut
