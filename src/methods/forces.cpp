#include "forces.h"

#include <algorithm>
#include <cmath>

namespace taut {
namespace {

// v' = v·keep + gain in the free masses.
void kick_axis(const std::vector<double>& inverse_mass, double gain, double keep,
               const std::vector<double>& velocity, std::vector<double>& kicked) {
  for (std::size_t i = 0; i < velocity.size(); ++i)
    kicked[i] = inverse_mass[i] == 0.0 ? velocity[i] : velocity[i] * keep + gain;
}

void drift_axis(double h, const std::vector<double>& position, const std::vector<double>& velocity,
                std::vector<double>& moved) {
  for (std::size_t i = 0; i < position.size(); ++i) moved[i] = position[i] + h * velocity[i];
}

void difference_axis(double rate, const std::vector<double>& from, const std::vector<double>& to,
                     std::vector<double>& velocity) {
  for (std::size_t i = 0; i < from.size(); ++i) velocity[i] = (to[i] - from[i]) * rate;
}

}  // namespace

void kick(const Model& model, double load_time, double h, const Vectors& velocity, Vectors& kicked,
          DragAt drag_at) {
  const std::vector<double>& inverse_mass = model.masses.inverse_mass;
  const double answer = drag_at == DragAt::end ? 1.0 / (1.0 + h * model.drag) : 1.0;
  const double keep = drag_at == DragAt::end ? answer : 1.0 - h * model.drag;
  const Vec3 gain = model.gravity * (h * answer);
  kick_axis(inverse_mass, gain.x(), keep, velocity.x, kicked.x);
  kick_axis(inverse_mass, gain.y(), keep, velocity.y, kicked.y);
  kick_axis(inverse_mass, gain.z(), keep, velocity.z, kicked.z);
  for (const Load& load : model.loads) {
    const Vec3 impulse = load.force * (load.share(load_time) * h * answer);
    if (impulse.isZero(0.0)) continue;
    for (const Index mass : load.masses) kicked.add(mass, impulse * inverse_mass[mass]);
  }
}

void blow(const Wind& wind, const Model& model, const State& state, double time, double h,
          Vectors& velocity) {
  const Vec3 air = wind_at(wind, time);
  const std::vector<double>& inverse_mass = model.masses.inverse_mass;
  for (const Triangle& triangle : model.triangles) {
    const auto& [a, b, c] = triangle.masses;
    if (std::any_of(triangle.links.begin(), triangle.links.end(),
                    [&state](Index link) { return link != no_link && state.broken(link); }))
      continue;
    const Vec3 across =
        0.5 *
        (state.position.at(b) - state.position.at(a)).cross(state.position.at(c) - state.position.at(a));
    const double area = across.norm();
    if (area == 0.0) continue;
    const Vec3 normal = across / area;
    const Vec3 moving = (state.velocity.at(a) + state.velocity.at(b) + state.velocity.at(c)) / 3.0;
    const double wind_speed = (air - moving).dot(normal);
    // Impulse on each mass per metre a second, and how much of the difference in speed it would take away.
    const double push = wind.density * wind.drag_coefficient * area * std::abs(wind_speed) * h / 6.0;
    const double taken = push * (inverse_mass[a] + inverse_mass[b] + inverse_mass[c]) / 3.0;
    const Vec3 impulse = (push / (1.0 + taken) * wind_speed) * normal;
    for (const Index mass : triangle.masses) velocity.add(mass, inverse_mass[mass] * impulse);
  }
}

void drift(double h, const Vectors& position, const Vectors& velocity, Vectors& moved) {
  drift_axis(h, position.x, velocity.x, moved.x);
  drift_axis(h, position.y, velocity.y, moved.y);
  drift_axis(h, position.z, velocity.z, moved.z);
}

void difference_quotient(double h, const Vectors& from, const Vectors& to, Vectors& velocity) {
  difference_axis(1.0 / h, from.x, to.x, velocity.x);
  difference_axis(1.0 / h, from.y, to.y, velocity.y);
  difference_axis(1.0 / h, from.z, to.z, velocity.z);
}

void keep_out_of_plane(const Plane& plane, const Masses& masses, const Vectors& start, Vectors& position) {
  for (std::size_t i = 0; i < position.size(); ++i) {
    const Vec3 x = position.at(i);
    const double depth = (plane.point - x).dot(plane.normal);
    if (!(depth > 0.0) || masses.pinned(i)) continue;
    const Vec3 moved = x - start.at(i);
    const Vec3 slide = moved - plane.normal * moved.dot(plane.normal);
    const double distance = slide.norm();
    const double held = plane.friction * depth;
    const double kept = distance > held ? 1.0 - held / distance : 0.0;
    position.set(i, x + plane.normal * depth - slide * (1.0 - kept));
  }
}

}  // namespace taut
