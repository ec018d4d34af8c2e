#include "geometry/hiders.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/inverse_root.h"
#include "geometry/torso.h"

namespace taut {
namespace {

// How much darker it gets for what is hidden.
constexpr float darkening = 1.6F;

constexpr std::array upright{glm::vec3(1, 0, 0), glm::vec3(0, 1, 0), glm::vec3(0, 0, 1)};

std::array<glm::vec3, 3> axes_along(const glm::vec3& first) {
  const glm::vec3 any = std::abs(first.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 second = glm::normalize(glm::cross(first, any));
  return {first, second, glm::cross(first, second)};
}

// Without comparisons, which would make branches.
float within(float value, float limit) {
  return 0.5F * (std::abs(value + limit) - std::abs(value - limit));
}

float positive(float value) {
  return 0.5F * (value + std::abs(value));
}

/// A hider as the loop over points takes it.
struct Seen {
  Hider hider;
  std::array<float, 3> outlines;  // m², as seen along each axis
  float reach;
};

float share_hidden(const Seen& seen, const glm::vec3& place, const glm::vec3& normal) {
  constexpr float pi = std::numbers::pi_v<float>;
  const Hider& hider = seen.hider;
  float square = 1e-12F, facing = 0.0F, outline = 0.0F, along = 0.0F;
  for (int i = 0; i < 3; ++i) {
    const glm::vec3& axis = hider.axes[static_cast<std::size_t>(i)];
    const float at = axis.x * (place.x - hider.centre.x) + axis.y * (place.y - hider.centre.y) +
                     axis.z * (place.z - hider.centre.z);
    const float nearest = within(at, hider.halves[i]), off = at - nearest;
    square += off * off;
    facing -= off * (axis.x * normal.x + axis.y * normal.y + axis.z * normal.z);
    outline += std::abs(off) * seen.outlines[static_cast<std::size_t>(i)];
    along += i == 0 ? nearest : 0.0F;
  }
  // The ball in it that is nearest.
  const float radius = hider.radius + hider.taper * along;
  const float inverse = inverse_root(square), sine = radius * inverse;
  const float rise = within(sine, 1.0F);  // so far it reaches above the horizon, seen from its foot
  const float away = positive(square * inverse - radius);
  const float near = positive(1.0F - away / seen.reach);
  const float area = outline * inverse;
  return near * near * positive(facing * inverse + rise) * area / ((1.0F + rise) * (area + pi * away * away));
}

}  // namespace

Hider hider_of(const TaperedRod& rod) {
  const glm::vec3 span = rod.end - rod.start;
  const float length = glm::length(span);
  // What is squeezed is nearly always a disc: of its thickness, and as wide.
  const float squeeze = glm::length(rod.squeeze), thin = 1.0F - squeeze * squeeze;
  const float widest = std::max(rod.start_radius, rod.end_radius);
  Hider hider{0.5F * (rod.start + rod.end), upright, glm::vec3(0.0F),
              0.5F * thin * (rod.start_radius + rod.end_radius)};
  if (length > 1e-3F * widest) {
    hider.axes = axes_along(span / length);
    hider.halves.x = 0.5F * length;
    hider.taper = thin * (rod.end_radius - rod.start_radius) / length;
  } else if (squeeze > 0.0F) {
    hider.axes = axes_along(rod.squeeze / squeeze);
    hider.halves.y = hider.halves.z = 0.85F * (1.0F - thin) * widest;
  }
  return hider;
}

Hider hider_of(const TorsoRecord& torso) {
  const std::array<glm::vec3, 8> corners = torso_corners();
  const glm::vec3 low = corners[0], high = corners[7];
  Hider hider{torso.origin + 0.5F * (low.y + high.y) * torso.axes[1], {}, glm::vec3(0.0F), 0.0F};
  const glm::vec3 sizes(glm::length(torso.axes[0]), glm::length(torso.axes[1]), glm::length(torso.axes[2]));
  for (int i = 0; i < 3; ++i) hider.axes[static_cast<std::size_t>(i)] = torso.axes[i] / sizes[i];
  hider.radius = 0.8F * high.z * sizes.z;
  hider.halves.x = std::max(0.8F * high.x * sizes.x - hider.radius, 0.0F);
  hider.halves.y = std::max(0.5F * (high.y - low.y) * sizes.y - hider.radius, 0.0F);
  return hider;
}

Hider hider_of(const BoxRecord& box) {
  Hider hider{box.centre, {}, glm::vec3(0.0F), 0.0F};
  for (int i = 0; i < 3; ++i) {
    hider.halves[i] = std::max(glm::length(box.edges[i]), 1e-9F);
    hider.axes[static_cast<std::size_t>(i)] = box.edges[i] / hider.halves[i];
  }
  // Edges that are a little round hide as much.
  hider.radius = 0.5F * std::min({hider.halves.x, hider.halves.y, hider.halves.z});
  hider.halves -= hider.radius;
  return hider;
}

Hider hider_of(const GroundPatch& ground, float reach) {
  // A slab with its surface there, as far as anything is seen.
  return {-ground.normal * (ground.height + 2.0F * reach), axes_along(ground.normal),
          reach * glm::vec3(1.0F, 200.0F, 200.0F), reach};
}

float distance_to(const Hider& hider, const glm::vec3& place) {
  glm::vec3 off(0.0F);
  float along = 0.0F;
  for (int i = 0; i < 3; ++i) {
    const float at = glm::dot(hider.axes[static_cast<std::size_t>(i)], place - hider.centre);
    const float nearest = within(at, hider.halves[i]);
    off[i] = at - nearest;
    if (i == 0) along = nearest;
  }
  return glm::length(off) - hider.radius - hider.taper * along;
}

void ShadedPoints::clear() {
  for (std::vector<float>& along : places_) along.clear();
  for (std::vector<float>& along : normals_) along.clear();
  hidden_.clear();
}

void ShadedPoints::add(const glm::vec3& place, const glm::vec3& normal) {
  for (int i = 0; i < 3; ++i) {
    places_[static_cast<std::size_t>(i)].push_back(place[i]);
    normals_[static_cast<std::size_t>(i)].push_back(normal[i]);
  }
  hidden_.push_back(0.0F);
}

void ShadedPoints::hide_by(const Hider& hider, float reach) {
  // What lies beyond the reach is not seen, however long it is.
  const glm::vec3 sides = glm::min(hider.halves + hider.radius, glm::vec3(reach));
  constexpr float pi = std::numbers::pi_v<float>;
  const Seen seen{
      hider,
      {0.8F * pi * sides.y * sides.z, 0.8F * pi * sides.x * sides.z, 0.8F * pi * sides.x * sides.y},
      reach};
  const float *x = places_[0].data(), *y = places_[1].data(), *z = places_[2].data();
  const float *across = normals_[0].data(), *up = normals_[1].data(), *along = normals_[2].data();
  float* hidden = hidden_.data();
  const std::size_t count = hidden_.size();
  for (std::size_t i = 0; i < count; ++i)
    hidden[i] += share_hidden(seen, {x[i], y[i], z[i]}, {across[i], up[i], along[i]});
}

float ShadedPoints::openness(std::size_t point) const {
  return std::exp(-darkening * hidden_[point]);
}

}  // namespace taut
