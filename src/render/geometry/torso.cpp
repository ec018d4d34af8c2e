#include "geometry/torso.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace taut {
namespace {

// A trunk's half width, half depth and how far forward its middle lies, at heights above the hips.
struct TorsoSection {
  float height, width, depth, forward;
};
constexpr std::array torso_sections{
    TorsoSection{-0.070F, 0.122F, 0.058F, -0.004F}, TorsoSection{0.000F, 0.139F, 0.069F, -0.004F},
    TorsoSection{0.105F, 0.117F, 0.058F, 0.000F},   TorsoSection{0.215F, 0.149F, 0.072F, 0.003F},
    TorsoSection{0.285F, 0.163F, 0.062F, -0.003F},  TorsoSection{0.330F, 0.150F, 0.050F, -0.006F}};

// Along a curve through four values, from the second to the third.
float between(float before, float from, float to, float after, float share) {
  const float first = 0.5F * (to - before), last = 0.5F * (after - from);
  const float rise = to - from;
  return from +
         share * (first + share * (3.0F * rise - 2.0F * first - last + share * (first + last - 2.0F * rise)));
}

TorsoSection torso_section(float height) {
  std::size_t next = 1;
  while (next + 1 < torso_sections.size() && torso_sections[next].height < height) ++next;
  const auto& from = torso_sections[next - 1];
  const auto& to = torso_sections[next];
  const auto& before = torso_sections[next > 1 ? next - 2 : 0];
  const auto& after = torso_sections[std::min(next + 1, torso_sections.size() - 1)];
  const float share = std::clamp((height - from.height) / (to.height - from.height), 0.0F, 1.0F);
  return {height, between(before.width, from.width, to.width, after.width, share),
          between(before.depth, from.depth, to.depth, after.depth, share),
          between(before.forward, from.forward, to.forward, after.forward, share)};
}

constexpr float torso_bottom = -0.068F, torso_top = 0.331F;

// Where a ray of that angle meets the curve |x|^exponent + |y|^exponent = 1: between a circle, 2, and a
// square.
glm::vec2 on_rounded_square(float angle, float exponent) {
  const glm::vec2 ray(std::cos(angle), std::sin(angle));
  return ray * std::pow(std::pow(std::abs(ray.x), exponent) + std::pow(std::abs(ray.y), exponent),
                        -1.0F / exponent);
}

// A ball of that latitude and longitude, made squarer and then as wide and deep as a trunk is at its height.
glm::vec3 torso_place(float latitude, float longitude) {
  constexpr float upright = 3.2F, around = 2.4F;
  const float middle = 0.5F * (torso_top + torso_bottom), half = 0.5F * (torso_top - torso_bottom);
  const glm::vec2 side = on_rounded_square(latitude, upright), ring = on_rounded_square(longitude, around);
  const TorsoSection section = torso_section(middle + half * side.y);
  return {section.width * side.x * ring.x, section.height, section.forward - section.depth * side.x * ring.y};
}

}  // namespace

std::vector<TorsoVertex> torso_vertices(int sides, int bands) {
  constexpr float pi = std::numbers::pi_v<float>, step = 1e-3F;
  std::vector<TorsoVertex> vertices;
  for (int ring = 0; ring <= bands; ++ring) {
    const float latitude = pi * (static_cast<float>(ring) / static_cast<float>(bands) - 0.5F);
    for (int side = 0; side < sides; ++side) {
      const float longitude = 2.0F * pi * static_cast<float>(side) / static_cast<float>(sides);
      const glm::vec3 up = torso_place(std::min(latitude + step, 0.5F * pi), longitude) -
                           torso_place(std::max(latitude - step, -0.5F * pi), longitude);
      const glm::vec3 along =
          torso_place(latitude, longitude + step) - torso_place(latitude, longitude - step);
      const bool tip = ring == 0 || ring == bands;
      const glm::vec3 outward =
          tip ? glm::vec3(0.0F, ring == 0 ? -1.0F : 1.0F, 0.0F) : glm::normalize(glm::cross(along, up));
      vertices.push_back({torso_place(latitude, longitude), outward});
    }
  }
  return vertices;
}

std::array<glm::vec3, 8> torso_corners() {
  constexpr float width = 0.17F, depth = 0.08F;
  std::array<glm::vec3, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i)
    corners[i] = {(i & 1U) != 0 ? width : -width, (i & 2U) != 0 ? torso_top : torso_bottom,
                  (i & 4U) != 0 ? depth : -depth};
  return corners;
}

}  // namespace taut
