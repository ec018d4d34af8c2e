#include "render/colour_range.h"

#include <cmath>
#include <limits>

#include "geometry/colour_scale.h"
#include "render/appearance.h"

namespace taut {
namespace {

constexpr double share_below_top = 0.98;
constexpr double bin_ratio = 1.01;
constexpr int bin_of_nothing = std::numeric_limits<int>::min();

}  // namespace

void ColourRange::add(const Model& model, const State& state, const Look& look) {
  const Quantity values = quantity(model, state, by_);
  const std::vector<bool> seen = masses_in_view(model, look);
  if (by_ == ColourBy::speed) {
    for (std::size_t mass = 0; mass < values.of_mass.size(); ++mass)
      if (seen[mass]) add(values.of_mass[mass]);
    return;
  }
  for (std::size_t link = 0; link < values.of_link.size(); ++link)
    if (seen[model.links.a[link]] && seen[model.links.b[link]] && !state.broken(link) &&
        model.links.family[link] == LinkFamily::structural)
      add(values.of_link[link]);
}

void ColourRange::add(double value) {
  if (!std::isfinite(value)) return;
  ++counts_[value > 0.0 ? static_cast<int>(std::ceil(std::log(value) / std::log(bin_ratio)))
                        : bin_of_nothing];
  ++count_;
}

double ColourRange::top() const {
  const double wanted = share_below_top * static_cast<double>(count_);
  std::int64_t below = 0;
  for (const auto& [bin, count] : counts_) {
    below += count;
    if (static_cast<double>(below) < wanted) continue;
    // Most may be at rest while a few are not.
    if (bin == bin_of_nothing) continue;
    return round_number_above(std::pow(bin_ratio, bin));
  }
  return 1.0;
}

double round_number_above(double value) {
  if (!(value > 0.0) || !std::isfinite(value)) return 1.0;
  const double decade = std::pow(10.0, std::floor(std::log10(value)));
  for (const double step : {1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
    // A value that is round but for its bin's width stays where it is.
    if (value <= step * decade * bin_ratio * (1.0 + 1e-9)) return step * decade;
  return 10.0 * decade;
}

}  // namespace taut
