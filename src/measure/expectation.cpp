#include "measure/expectation.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace taut {
namespace {

Finding at_most(std::string key, double measured, double most, std::string_view unit) {
  return {std::move(key), measured <= most,
          fmt::format("{:.4g}{} of at most {:.4g}{}", measured, unit, most, unit)};
}

Finding within(std::string key, double measured, const std::array<double, 2>& range, std::string_view unit) {
  return {std::move(key), measured >= range[0] && measured <= range[1],
          fmt::format("{:.4g}{} of {:.4g} to {:.4g}{}", measured, unit, range[0], range[1], unit)};
}

Finding all_inside(const std::array<Vec3, 2>& box, const Model& model, const State& end) {
  for (std::size_t i = 0; i < model.masses.size(); ++i) {
    const Vec3 x = end.position.at(i);
    if ((x.array() >= box[0].array()).all() && (x.array() <= box[1].array()).all()) continue;
    return {
        "inside", false,
        fmt::format("{} is outside, at ({:.4g}, {:.4g}, {:.4g})", model.masses.name[i], x.x(), x.y(), x.z())};
  }
  return {"inside", true, "every mass"};
}

}  // namespace

std::vector<Finding> check_expectation(const Expectation& expectation, const Model& model, const State& end,
                                       const RunMeasures& measures) {
  std::vector<Finding> findings;
  if (expectation.max_strain)
    findings.push_back(at_most("max_strain", measures.strain.largest, *expectation.max_strain, ""));
  if (expectation.energy_drift)
    findings.push_back(
        at_most("energy_drift", std::abs(measures.energy_error), *expectation.energy_drift, ""));
  if (expectation.broken_links)
    findings.push_back(
        within("broken_links", static_cast<double>(measures.broken_links), *expectation.broken_links, ""));
  if (expectation.sag) findings.push_back(within("sag", measures.sag, *expectation.sag, " m"));
  if (expectation.at_rest)
    findings.push_back(at_most("at_rest", measures.fastest_speed, *expectation.at_rest, " m/s"));
  if (expectation.inside) findings.push_back(all_inside(*expectation.inside, model, end));
  if (expectation.limit_excess)
    findings.push_back(at_most("limit_excess", measures.limit_excess * 180.0 / std::numbers::pi,
                               *expectation.limit_excess, "°"));
  if (expectation.penetration)
    findings.push_back(at_most("penetration", measures.penetration, *expectation.penetration, " m"));
  if (expectation.tangled)
    findings.push_back(at_most("tangled", static_cast<double>(measures.tangled), *expectation.tangled, ""));
  return findings;
}

}  // namespace taut
