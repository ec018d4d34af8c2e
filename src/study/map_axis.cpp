#include "map_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace taut {
namespace {

std::string mark_text(double value, int power, bool plain) {
  return plain ? fmt::format("{:g}", value) : fmt::format("10^{{{}}}", power);
}

}  // namespace

double cell_place(const std::vector<double>& values, double value) {
  if (values.size() < 2) return std::log(value / values.front());
  const auto above = std::ranges::upper_bound(values, value);
  const auto right =
      std::clamp<std::ptrdiff_t>(above - values.begin(), 1, static_cast<std::ptrdiff_t>(values.size()) - 1);
  const double a = values[static_cast<std::size_t>(right) - 1], b = values[static_cast<std::size_t>(right)];
  return static_cast<double>(right - 1) + std::log(value / a) / std::log(b / a);
}

std::vector<AxisMark> axis_marks(const std::vector<double>& values, bool plain, int most) {
  constexpr int few = 3;
  const auto within = [&](double value) {
    const double place = cell_place(values, value);
    return place >= -0.5 && place <= static_cast<double>(values.size()) - 0.5;
  };
  const int first = static_cast<int>(std::floor(std::log10(values.front()))) - 1;
  const int last = static_cast<int>(std::ceil(std::log10(values.back()))) + 1;
  int powers = 0;
  for (int power = first; power <= last; ++power) powers += within(std::pow(10.0, power)) ? 1 : 0;
  const int stride = powers > most ? 2 : 1;
  std::vector<AxisMark> marks;
  for (int power = first; power <= last; ++power)
    for (int digit = 1; digit < 10; ++digit) {
      const double value = digit * std::pow(10.0, power);
      if (!within(value)) continue;
      const bool named =
          digit == 1 ? power % stride == 0 : powers < few && plain && (digit == 2 || digit == 5);
      marks.push_back({cell_place(values, value), named ? mark_text(value, power, plain) : ""});
    }
  return marks;
}

}  // namespace taut
