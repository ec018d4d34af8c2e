#include "forces/forces.h"

#include <algorithm>
#include <cmath>

#include "base/vector_operations.h"
#include "forces/mass_kernels.h"

namespace taut {
namespace {

MassKick of_masses(const Model& model, const FieldKick& fields, std::size_t begin = 0) {
  return {model.masses.inverse_mass.data() + begin, fields.keep, fields.gain};
}

// Visits the masses of loads with what a load adds to their velocity in a kick of h seconds.
template <class Visit>
void visit_loads(const Model& model, double time, double h, double answer, const Visit& visit) {
  for (const Load& load : model.loads) {
    const Vec3 impulse = load.force * (load.share(time) * h * answer);
    if (impulse.isZero(0.0)) continue;
    for (const Index mass : load.masses) visit(mass, impulse * model.masses.inverse_mass[mass]);
  }
}

// The wind's push on a triangle.
struct WindPush {
  Vec3 force = Vec3::Zero();  // N, on each of its masses
  double rate = 0.0;          // 1/s: the share of the difference in speed that it takes away
};

// Visits the triangles that are whole with visit(triangle, push).
template <class Visit>
void visit_pushes(const Model& model, const State& state, const Vectors& position, const Vectors& velocity,
                  double time, const Visit& visit) {
  if (!model.wind) return;
  const Wind& wind = *model.wind;
  const Vec3 air = wind_at(wind, time);
  const std::vector<double>& inverse_mass = model.masses.inverse_mass;
  for (const Triangle& triangle : model.triangles) {
    const auto& [a, b, c] = triangle.masses;
    if (std::any_of(triangle.links.begin(), triangle.links.end(),
                    [&state](Index link) { return link != no_link && state.broken(link); }))
      continue;
    const Vec3 across = 0.5 * (position.at(b) - position.at(a)).cross(position.at(c) - position.at(a));
    const double area = across.norm();
    if (area == 0.0) continue;
    const Vec3 normal = across / area;
    const Vec3 moving = (velocity.at(a) + velocity.at(b) + velocity.at(c)) / 3.0;
    const double speed = (air - moving).dot(normal);
    const double force = wind.density * wind.drag_coefficient * area * std::abs(speed) / 6.0;
    visit(triangle, WindPush{(force * speed) * normal,
                             force * (inverse_mass[a] + inverse_mass[b] + inverse_mass[c]) / 3.0});
  }
}

}  // namespace

FieldKick field_kick(const Model& model, double h, DragAt drag_at) {
  const double answer = drag_at == DragAt::end ? 1.0 / (1.0 + h * model.drag) : 1.0;
  const double keep = drag_at == DragAt::end ? answer : 1.0 - h * model.drag;
  return {keep, answer, model.gravity * (h * answer)};
}

void kick(const Model& model, double load_time, double h, const Vectors& velocity, Vectors& kicked,
          DragAt drag_at) {
  const FieldKick fields = field_kick(model, h, drag_at);
  kick_masses(velocity.size(), of_masses(model, fields), to_read(velocity), to_write(kicked));
  visit_loads(model, load_time, h, fields.answer,
              [&](Index mass, const Vec3& change) { kicked.add(mass, change); });
}

bool pushed_from_outside(const Model& model) {
  return model.wind || !model.loads.empty() || !model.driven_pins.empty();
}

void kick_and_drift(const Model& model, double load_time, double kick_time, double h, const Vectors& position,
                    const Vectors& velocity, Vectors& kicked, Vectors& moved, DragAt drag_at, Extent masses) {
  const FieldKick fields = field_kick(model, kick_time, drag_at);
  const std::size_t begin = masses.begin;
  kick_and_move(masses.size(), of_masses(model, fields, begin), h, to_read(position, begin),
                to_read(velocity, begin), model.loads.empty() ? AxesToWrite{} : to_write(kicked, begin),
                to_write(moved, begin));
  visit_loads(model, load_time, kick_time, fields.answer, [&](Index mass, const Vec3& change) {
    if (!masses.holds(mass)) return;
    kicked.add(mass, change);
    moved.set(mass, position.at(mass) + h * kicked.at(mass));
  });
}

void mean_velocity_and_kick(const Model& model, double load_time, double kick_time, double h,
                            const Vectors& from, const Vectors& to, Vectors& velocity, Extent masses) {
  const FieldKick fields = field_kick(model, kick_time, DragAt::end);
  const std::size_t begin = masses.begin;
  mean_and_kick(masses.size(), of_masses(model, fields, begin), 1.0 / h, to_read(from, begin),
                to_read(to, begin), to_write(velocity, begin));
  for (const DrivenPin& pin : model.driven_pins)
    if (masses.holds(pin.mass)) velocity.set(pin.mass, velocity_at(pin.motion, load_time));
  visit_loads(model, load_time, kick_time, fields.answer, [&](Index mass, const Vec3& change) {
    if (masses.holds(mass)) velocity.add(mass, change);
  });
}

void fall(const Model& model, double load_time, const Vectors& velocity, Vectors& acceleration) {
  const std::vector<double>& inverse_mass = model.masses.inverse_mass;
  const auto fall_axis = [&](double gravity, const std::vector<double>& along, std::vector<double>& result) {
    all_of(result) = free_masses(inverse_mass) * (gravity - model.drag * all_of(along));
  };
  fall_axis(model.gravity.x(), velocity.x, acceleration.x);
  fall_axis(model.gravity.y(), velocity.y, acceleration.y);
  fall_axis(model.gravity.z(), velocity.z, acceleration.z);
  for (const Load& load : model.loads) {
    const Vec3 force = load.force * load.share(load_time);
    for (const Index mass : load.masses) acceleration.add(mass, force * inverse_mass[mass]);
  }
}

void blow(const Model& model, const State& state, const Vectors& position, const Vectors& velocity,
          double time, double h, Vectors& kicked, DragAt drag_at) {
  visit_pushes(model, state, position, velocity, time, [&](const Triangle& triangle, const WindPush& push) {
    const double taken = h * push.rate;
    const double share = drag_at == DragAt::end ? 1.0 / (1.0 + taken) : std::min(1.0, 1.0 / taken);
    for (const Index mass : triangle.masses)
      kicked.add(mass, (h * share * model.masses.inverse_mass[mass]) * push.force);
  });
}

void add_wind(const Model& model, const State& state, const Vectors& position, const Vectors& velocity,
              double time, Vectors& acceleration) {
  visit_pushes(model, state, position, velocity, time, [&](const Triangle& triangle, const WindPush& push) {
    for (const Index mass : triangle.masses)
      acceleration.add(mass, model.masses.inverse_mass[mass] * push.force);
  });
}

void drift(double h, const Vectors& position, const Vectors& velocity, Vectors& moved) {
  add_scaled(position, h, velocity, moved);
}

void difference_quotient(double h, const Vectors& from, const Vectors& to, Vectors& velocity) {
  difference_quotient(h, from, to, velocity, {0, velocity.size()});
}

void difference_quotient(double h, const Vectors& from, const Vectors& to, Vectors& velocity, Extent masses) {
  mean_velocities(masses.size(), 1.0 / h, to_read(from, masses.begin), to_read(to, masses.begin),
                  to_write(velocity, masses.begin));
}

double energy_of_some(const Model& model, const Vectors& position, const Vectors& velocity, Extent masses) {
  const std::size_t begin = masses.begin;
  return energy_of_falling(masses.size(),
                           {&model.masses.mass[begin], &model.masses.inverse_mass[begin], model.gravity},
                           to_read(position, begin), to_read(velocity, begin));
}

}  // namespace taut
