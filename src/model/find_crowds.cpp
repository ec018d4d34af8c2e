#include <fmt/format.h>

#include <algorithm>

#include "builder.h"
#include "model/near_balls.h"

namespace taut {
namespace {

template <typename Spec>
bool report_in(std::string_view section, const std::vector<Spec>& specs, std::string_view name,
               const std::string& message, std::vector<Problem>& problems) {
  for (std::size_t i = 0; i < specs.size(); ++i) {
    if (specs[i].name != name) continue;
    problems.push_back({std::string(section), i, "collides", message, ""});
    return true;
  }
  return false;
}

}  // namespace

void find_crowds(const Builder& builder, const Description& description, std::vector<Problem>& problems) {
  if (!builder.any_body()) return;
  std::vector<BodyBall> balls;
  std::vector<Vec3> places;
  std::vector<Index> masses;
  for (const ContactPoint& point : builder.model.contacts) {
    if (point.body == no_body) continue;
    balls.push_back({point.radius, point.body});
    places.push_back(value_at(point, builder.start.position));
    masses.push_back(point.masses[0]);
  }
  NearBalls::Pairs pairs;
  NearBalls(balls, contact_margin).find(places, most_near_pairs, pairs);
  if (pairs.size() <= most_near_pairs) return;
  const auto& [a, b] = *std::min_element(pairs.begin(), pairs.end());
  const std::string& first = builder.model.masses.name[masses[a]];
  const std::string message = fmt::format(
      "more than {} million pairs of masses that collide start inside each other or within {} m of it, "
      "\"{}\" and \"{}\" among them; let them start farther apart",
      most_near_pairs / 1'000'000, contact_margin, first, builder.model.masses.name[masses[b]]);
  const std::string_view body = std::string_view(first).substr(0, first.find('.'));
  if (!report_in("mass", description.masses, body, message, problems) &&
      !report_in("chain", description.chains, body, message, problems) &&
      !report_in("sheet", description.sheets, body, message, problems) &&
      !report_in("mesh", description.meshes, body, message, problems) &&
      !report_in("points", description.points, body, message, problems))
    report_in("ragdoll", description.ragdolls, body, message, problems);
}

}  // namespace taut
