#include "geometry/colour_scale.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "render/colour_range.h"

namespace taut {
namespace {

// Each list rises steadily in lightness, and keeps away from the lightness of its theme's background.
constexpr std::array<Colour, 6> for_light_backgrounds{Colour{0.13, 0.09, 0.42}, Colour{0.36, 0.10, 0.58},
                                                      Colour{0.62, 0.16, 0.55}, Colour{0.82, 0.29, 0.40},
                                                      Colour{0.94, 0.47, 0.25}, Colour{0.98, 0.70, 0.18}};
constexpr std::array<Colour, 6> for_dark_backgrounds{Colour{0.24, 0.29, 0.54}, Colour{0.17, 0.44, 0.56},
                                                     Colour{0.13, 0.59, 0.55}, Colour{0.31, 0.73, 0.42},
                                                     Colour{0.66, 0.85, 0.22}, Colour{0.99, 0.91, 0.25}};

// That a logarithmic scale shows.
constexpr double decades = 3.0;

Colour mix(const Colour& a, const Colour& b, double share) {
  return {std::lerp(a[0], b[0], share), std::lerp(a[1], b[1], share), std::lerp(a[2], b[2], share)};
}

double speed(const State& state, std::size_t mass) {
  return state.velocity.at(mass).norm();
}

double link_value(const Model& model, const State& state, ColourBy by, std::size_t link) {
  switch (by) {
    case ColourBy::strain:
      return model.links.strain(link, link_distance(model, state.position, link));
    case ColourBy::tension:
      return state.tension[link];
    case ColourBy::speed:
      return 0.5 * (speed(state, model.links.a[link]) + speed(state, model.links.b[link]));
    case ColourBy::limit:
    case ColourBy::plain:
      break;
  }
  return 0.0;
}

// How far an angle has gone from the middle of its range to a stop, 0 to 1; where only one end is a stop,
// from the other end.
double nearness(const Limit& limit, double angle) {
  const bool from_zero = limit.kind != LimitKind::hinge && limit.min <= 0.0;
  const double share =
      from_zero ? angle / limit.max : std::abs(2.0 * (angle - limit.min) / (limit.max - limit.min) - 1.0);
  return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 1.0;
}

// The nearest to a stop of the limits at each mass; a hinge's axis may be two masses.
std::vector<double> nearest_to_stops(const Model& model, const State& state) {
  std::vector<double> nearest(model.masses.size());
  for (const Limit& limit : model.limits) {
    if (limit.kind == LimitKind::reach) continue;
    const double value = nearness(limit, limit_angle(limit, state.position));
    const std::size_t joint = limit.kind == LimitKind::cone ? 3 : 1;
    const bool wide = limit.kind == LimitKind::hinge;
    for (const std::size_t slot : {joint, wide ? std::size_t{3} : joint, wide ? std::size_t{4} : joint})
      nearest[limit.masses[slot]] = std::max(nearest[limit.masses[slot]], value);
  }
  return nearest;
}

std::vector<double> mean_over_links(const Model& model, const State& state,
                                    const std::vector<double>& values) {
  std::vector<double> sum(model.masses.size()), count(model.masses.size());
  for (std::size_t link = 0; link < values.size(); ++link) {
    if (state.broken(link) || model.links.family[link] != LinkFamily::structural) continue;
    for (const Index mass : {model.links.a[link], model.links.b[link]}) {
      sum[mass] += values[link];
      count[mass] += 1.0;
    }
  }
  for (std::size_t mass = 0; mass < sum.size(); ++mass) sum[mass] /= std::max(count[mass], 1.0);
  return sum;
}

}  // namespace

Rgba opaque(const Colour& colour) {
  const auto byte = [](double share) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
  };
  return {byte(colour[0]), byte(colour[1]), byte(colour[2]), 255};
}

Quantity quantity(const Model& model, const State& state, ColourBy by) {
  Quantity result;
  if (by == ColourBy::plain) return result;
  result.of_link.resize(model.links.size());
  if (by == ColourBy::limit) {
    result.of_mass = nearest_to_stops(model, state);
    for (std::size_t link = 0; link < model.links.size(); ++link)
      result.of_link[link] =
          0.5 * (result.of_mass[model.links.a[link]] + result.of_mass[model.links.b[link]]);
    return result;
  }
  for (std::size_t link = 0; link < model.links.size(); ++link) {
    result.of_link[link] = link_value(model, state, by, link);
  }
  if (by == ColourBy::speed) {
    result.of_mass.resize(model.masses.size());
    for (std::size_t mass = 0; mass < model.masses.size(); ++mass) result.of_mass[mass] = speed(state, mass);
  } else {
    result.of_mass = mean_over_links(model, state, result.of_link);
  }
  return result;
}

double ColourScale::value_at(double share) const {
  return steps == ColourSteps::log ? top * std::pow(10.0, decades * (share - 1.0)) : share * top;
}

Colour ColourScale::at(double value) const {
  const std::span<const Colour> stops = theme == Theme::dark ? for_dark_backgrounds : for_light_backgrounds;
  double share = top > 0.0 && value > 0.0 ? value / top : 0.0;
  if (steps == ColourSteps::log && share > 0.0) share = 1.0 + std::log10(share) / decades;
  const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  return mix(stops[below], stops[below + 1], place - static_cast<double>(below));
}

ColourScale colour_scale(const Look& look, const Model& model, const State& state) {
  if (look.colour_by == ColourBy::limit) return {1.0, look.theme, ColourSteps::linear, false};
  double top = look.colour_range;
  if (!(top > 0.0)) {
    ColourRange range(look.colour_by);
    range.add(model, state, look);
    top = range.top();
  }
  return {top, look.theme, look.colour_steps, true};
}

}  // namespace taut
