#include "geometry/body_hues.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace taut {
namespace {

double to_linear(double shown) {
  return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
}

double to_shown(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

// From linear red, green, blue to what the eye's three kinds of cones answer, and from their cube roots on.
Eigen::Matrix3d cones_of_light() {
  return (Eigen::Matrix3d() << 0.4122214708, 0.5363325363, 0.0514459929,  //
          0.2119034982, 0.6806995451, 0.1073969566,                       //
          0.0883024619, 0.2817188376, 0.6299787005)
      .finished();
}
Eigen::Matrix3d lab_of_cones() {
  return (Eigen::Matrix3d() << 0.2104542553, 0.7936177850, -0.0040720468,  //
          1.9779984951, -2.4285922050, 0.4505937099,                       //
          0.0259040371, 0.7827717662, -0.8086757660)
      .finished();
}

constexpr std::size_t most_hues = 12;

// Eyes that don't tell red from green see of colours of one lightness how blue or yellow they are, on an axis
// a little turned. So colours are taken in equal steps along it, and every other one from the green half of
// the circle.
Oklab on_circle(double lightness, double chroma, std::size_t step, std::size_t count) {
  const double yellow = -1.0 + (2.0 * static_cast<double>(step) + 1.0) / static_cast<double>(count);
  const double red = std::sqrt(1.0 - yellow * yellow);
  constexpr double turn = -0.0785;  // rad
  const double across = step % 2 == 0 ? red : -red;
  return {lightness, chroma * (across * std::cos(turn) - yellow * std::sin(turn)),
          chroma * (across * std::sin(turn) + yellow * std::cos(turn))};
}

}  // namespace

Oklab oklab(const Colour& colour) {
  const Vec3 linear(to_linear(colour[0]), to_linear(colour[1]), to_linear(colour[2]));
  const Vec3 lab =
      lab_of_cones() * (cones_of_light() * linear).unaryExpr([](double v) { return std::cbrt(v); });
  return {lab[0], lab[1], lab[2]};
}

Colour colour_of(const Oklab& lab) {
  const Vec3 roots = lab_of_cones().inverse() * Vec3(lab.lightness, lab.green_red, lab.blue_yellow);
  const Vec3 linear = cones_of_light().inverse() * roots.cwiseProduct(roots).cwiseProduct(roots);
  Colour colour{};
  for (std::size_t i = 0; i < colour.size(); ++i)
    colour[i] = std::clamp(to_shown(std::max(linear[static_cast<Eigen::Index>(i)], 0.0)), 0.0, 1.0);
  return colour;
}

std::vector<Colour> body_hues(const Colour& seed, std::size_t count) {
  if (count <= 1) return std::vector<Colour>(count, seed);
  // Where all hues can be shown, and look like hues.
  constexpr double least_chroma = 0.105, most_chroma = 0.115, darkest = 0.60, lightest = 0.76;
  const Oklab own = oklab(seed);
  const double lightness = std::clamp(own.lightness, darkest, lightest);
  const double chroma = std::clamp(std::hypot(own.green_red, own.blue_yellow), least_chroma, most_chroma);
  const std::size_t kinds = std::min(count, most_hues);
  const auto distance = [&](std::size_t step) {
    const Oklab hue = on_circle(lightness, chroma, step, kinds);
    return std::hypot(hue.green_red - own.green_red, hue.blue_yellow - own.blue_yellow);
  };
  std::size_t first = 0;
  for (std::size_t step = 1; step < kinds; ++step)
    if (distance(step) < distance(first)) first = step;
  // A stride that visits all of them in turn, and is about two fifths of the way.
  std::size_t stride = std::max<std::size_t>(1, (2 * kinds + 2) / 5);
  while (std::gcd(stride, kinds) != 1) ++stride;
  std::vector<Colour> hues;
  for (std::size_t body = 0; body < count; ++body)
    hues.push_back(colour_of(on_circle(lightness, chroma, (first + body * stride) % kinds, kinds)));
  return hues;
}

}  // namespace taut
