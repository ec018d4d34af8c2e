#include "model/motion.h"

#include <algorithm>
#include <limits>

namespace taut {
namespace {

constexpr double for_ever = std::numeric_limits<double>::infinity(), never = -for_ever;

double last_change_of(std::monostate) {
  return never;
}
double last_change_of(const Sinusoid&) {
  return for_ever;
}
double last_change_of(const SteadyTurn&) {
  return for_ever;
}
double last_change_of(const Path& path) {
  return path.knots.back().time;
}
double last_change_of(const Carried& carried) {
  const auto last = [](const auto& part) { return last_change_of(part); };
  return std::max(std::visit(last, carried.solid.turn), std::visit(last, carried.solid.way));
}

void add_kinks(std::monostate, std::vector<double>&) {}
void add_kinks(const Sinusoid&, std::vector<double>&) {}
void add_kinks(const SteadyTurn& turn, std::vector<double>& times) {
  times.insert(times.end(), {0.0, turn.rise});
}
void add_kinks(const Path& path, std::vector<double>& times) {
  for (const Knot& knot : path.knots) times.push_back(knot.time);
}
void add_kinks(const Carried& carried, std::vector<double>& times) {
  const auto add = [&times](const auto& part) { add_kinks(part, times); };
  std::visit(add, carried.solid.turn);
  std::visit(add, carried.solid.way);
}

}  // namespace

Vec3 position_at(const Carried& carried, double time) {
  return placement_at(carried.solid, time).place(carried.place);
}

Vec3 velocity_at(const Carried& carried, double time) {
  return twist_at(carried.solid, time).velocity(position_at(carried, time));
}

Vec3 acceleration_at(const Carried& carried, double time) {
  return twist_at(carried.solid, time).acceleration(position_at(carried, time));
}

Vec3 position_at(const Motion& motion, double time) {
  return std::visit([time](const auto& way) { return position_at(way, time); }, motion);
}

Vec3 velocity_at(const Motion& motion, double time) {
  return std::visit([time](const auto& way) { return velocity_at(way, time); }, motion);
}

Vec3 acceleration_at(const Motion& motion, double time) {
  return std::visit([time](const auto& way) { return acceleration_at(way, time); }, motion);
}

std::vector<double> kinks_of(const Motion& motion) {
  std::vector<double> times;
  std::visit([&times](const auto& way) { add_kinks(way, times); }, motion);
  return times;
}

double last_change(const Motion& motion) {
  return std::visit([](const auto& way) { return last_change_of(way); }, motion);
}

}  // namespace taut
