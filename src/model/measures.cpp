#include "model/measures.h"

#include <algorithm>
#include <cmath>

#include "base/vector_operations.h"
#include "model/face_depth.h"

namespace taut {

Strain link_strain(const Model& model, const State& state) {
  Strain strain;
  double sum = 0.0, squares = 0.0;
  std::size_t whole = 0;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (state.broken(i)) continue;
    const double size = std::abs(model.links.strain(i, link_distance(model, state.position, i)));
    sum += size;
    squares += size * size;
    ++whole;
    if (size > strain.largest || strain.worst_link == no_link) {
      strain.largest = size;
      strain.worst_link = static_cast<Index>(i);
    }
  }
  if (whole > 0) {
    strain.mean = sum / static_cast<double>(whole);
    strain.root_mean_square = std::sqrt(squares / static_cast<double>(whole));
  }
  return strain;
}

Energy energy_of_masses(const Model& model, const State& state) {
  Energy energy;
  const auto mass = free_masses(model.masses.inverse_mass) * all_of(model.masses.mass);
  const Vectors &v = state.velocity, &x = state.position;
  energy.kinetic = 0.5 * (mass * (all_of(v.x).square() + all_of(v.y).square() + all_of(v.z).square())).sum();
  energy.potential = -(mass * (model.gravity.x() * all_of(x.x) + model.gravity.y() * all_of(x.y) +
                               model.gravity.z() * all_of(x.z)))
                          .sum();
  for (const Limit& limit : model.limits) {
    if (limit.compliance == 0.0 || limit.kind == LimitKind::reach) continue;  // links are asked for theirs
    const double excess = std::max(overshoot(limit, limit_angle(limit, state.position)).size, 0.0);
    energy.elastic += 0.5 * excess * excess / limit.compliance;
  }
  energy.elastic += bending_energy(model, state);
  return energy;
}

double elastic_energy(const Model& model, const State& state, std::size_t link) {
  if (model.links.rigid(link) || state.broken(link)) return 0.0;
  const double stretch = model.links.stretch(link, link_distance(model, state.position, link));
  return 0.5 * model.links.stiffness[link] * stretch * stretch;
}

Energy energy(const Model& model, const State& state) {
  Energy energy = energy_of_masses(model, state);
  for (std::size_t i = 0; i < model.links.size(); ++i) energy.elastic += elastic_energy(model, state, i);
  return energy;
}

double energy_scale(const Model& model, const State& start) {
  const Energy at_start = energy(model, start);
  const double length = total_link_length(model);
  return at_start.kinetic + at_start.elastic +
         free_mass(model) * model.gravity.norm() * (length > 0.0 ? length : scene_size(model, start));
}

double scene_size(const Model& model, const State& start) {
  if (start.position.size() == 0) return 0.0;
  Vec3 low = start.position.at(0), high = low;
  for (std::size_t i = 1; i < start.position.size(); ++i) {
    low = low.cwiseMin(start.position.at(i));
    high = high.cwiseMax(start.position.at(i));
  }
  const double diagonal = (high - low).norm();
  if (diagonal > 0.0) return diagonal;
  if (const double length = total_link_length(model); length > 0.0) return length;
  double radius = 0.0;
  for (const double each : model.masses.radius) radius = std::max(radius, each);
  return radius > 0.0 ? 2.0 * radius : 1.0;
}

Vec3 linear_momentum(const Model& model, const State& state) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < model.masses.size(); ++i)
    if (!model.masses.pinned(i)) sum += model.masses.mass[i] * state.velocity.at(i);
  return sum;
}

Vec3 angular_momentum(const Model& model, const State& state) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < model.masses.size(); ++i)
    if (!model.masses.pinned(i))
      sum += model.masses.mass[i] * state.position.at(i).cross(state.velocity.at(i));
  return sum;
}

Vec3 centre_of_mass(const Model& model, const State& state) {
  Vec3 sum = Vec3::Zero();
  double mass = 0.0;
  for (std::size_t i = 0; i < model.masses.size(); ++i) {
    if (model.masses.pinned(i)) continue;
    sum += model.masses.mass[i] * state.position.at(i);
    mass += model.masses.mass[i];
  }
  return mass > 0.0 ? Vec3(sum / mass) : sum;
}

Vec3 spin(const Model& model, const State& state) {
  return angular_momentum(model, state) - centre_of_mass(model, state).cross(linear_momentum(model, state));
}

bool flies_freely(const Model& model) {
  for (std::size_t i = 0; i < model.links.size(); ++i)
    if (model.masses.pinned(model.links.a[i]) || model.masses.pinned(model.links.b[i])) return false;
  return free_mass(model) > 0.0 && model.contacts.empty() && model.drag == 0.0 && model.loads.empty() &&
         !model.wind;
}

Vec3 up_direction(const Model& model) {
  const bool weightless = model.gravity.isZero(0.0);
  return weightless ? Vec3(Vec3::UnitY()) : Vec3(-model.gravity.stableNormalized());
}

double sag(const Model& model, const State& state) {
  const Vec3 up = up_direction(model);
  double lowest = infinity, lowest_pin = infinity, highest = -infinity;
  for (std::size_t i = 0; i < model.masses.size(); ++i) {
    const double height = up.dot(state.position.at(i));
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
    if (model.masses.held(i, state.time)) lowest_pin = std::min(lowest_pin, height);
  }
  return (lowest_pin < infinity ? lowest_pin : highest) - lowest;
}

double fastest_speed(const State& state) {
  double fastest = 0.0;
  for (std::size_t i = 0; i < state.velocity.size(); ++i)
    fastest = std::max(fastest, state.velocity.at(i).norm());
  return fastest;
}

double largest_limit_excess(const Model& model, const State& state) {
  double largest = 0.0;
  for (const Limit& limit : model.limits)
    if (limit.kind != LimitKind::reach)
      largest = std::max(largest, overshoot(limit, limit_angle(limit, state.position)).size);
  return largest;
}

double deepest_penetration(const Model& model, const State& state) {
  double deepest = deepest_face(model, state);
  std::vector<Shape> shapes;
  for (const Collider& collider : model.colliders) shapes.push_back(shape_at(collider, state.time));
  for (const ContactPoint& point : model.contacts) {
    const Vec3 place = value_at(point, state.position);
    for (const Shape& shape : shapes)
      if (const std::optional<Surface> surface = surface_within(shape, place, point.radius))
        deepest = std::max(deepest, point.radius - surface->distance);
  }
  return deepest;
}

std::size_t broken_links(const State& state) {
  return static_cast<std::size_t>(std::count_if(state.broken_at.begin(), state.broken_at.end(),
                                                [](double at) { return at != infinity; }));
}

double position_error(const State& state, const State& reference) {
  double largest = 0.0;
  for (std::size_t i = 0; i < state.position.size(); ++i)
    largest = std::max(largest, (state.position.at(i) - reference.position.at(i)).norm());
  return largest;
}

}  // namespace taut
