#include "measures_json.h"

#include <fmt/format.h>

#include "methods/registry.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

Json energy_to_json(const Energy& energy) {
  return {{"kinetic", energy.kinetic},
          {"potential", energy.potential},
          {"elastic", energy.elastic},
          {"total", energy.total()}};
}

Json vector_to_json(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

Json strain_to_json(const Strain& strain, const Model& model) {
  Json json{{"largest", strain.largest},
            {"mean", strain.mean},
            {"root_mean_square", strain.root_mean_square},
            {"worst_link", nullptr}};
  if (strain.worst_link != no_link)
    json["worst_link"] = {model.masses.name[model.links.a[strain.worst_link]],
                          model.masses.name[model.links.b[strain.worst_link]]};
  return json;
}

}  // namespace

Json measures_to_json(const RunMeasures& measures, const Scene& scene) {
  const bool tension_known = find_method(scene.settings.method)->can.tension_order > 0;
  return {{"time", measures.time},
          {"strain", strain_to_json(measures.strain, scene.model)},
          {"largest_tension", tension_known ? Json(measures.largest_tension) : Json(nullptr)},
          {"energy_at_start", energy_to_json(measures.energy_at_start)},
          {"energy", energy_to_json(measures.energy)},
          {"pin_work", measures.pin_work},
          {"load_work", measures.load_work},
          {"contact_work", measures.contact_work},
          {"broken_energy", measures.broken_energy},
          {"energy_error", measures.energy_error},
          {"linear_momentum", vector_to_json(measures.linear_momentum)},
          {"angular_momentum", vector_to_json(measures.angular_momentum)},
          {"sag", measures.sag},
          {"fastest_speed", measures.fastest_speed},
          {"limit_excess", measures.limit_excess},
          {"penetration", measures.penetration},
          {"tangled", measures.tangled},
          {"broken_links", measures.broken_links},
          {"rounds", measures.report.counts.rounds},
          {"link_solves", measures.report.counts.link_solves},
          {"factorisations", measures.report.counts.factorisations},
          {"halvings", measures.report.counts.halvings},
          {"halved_steps", measures.report.halved_steps},
          {"deepest_halving", measures.report.deepest_halving},
          {"first_halved_at", measures.report.first_halved_at},
          {"last_halved_at", measures.report.last_halved_at}};
}

nlohmann::ordered_json certificate_to_json(const Certificate& certificate) {
  nlohmann::ordered_json json{{"against", certificate.how},
                              {"largest_difference", certificate.largest},
                              {"share_of_size", certificate.largest / certificate.size},
                              {"at", certificate.at},
                              {"until", certificate.until},
                              {"agreed_until", certificate.agreed_until},
                              {"own_error", certificate.own_error},
                              {"chaotic_from", nullptr},
                              {"problem", certificate.problem}};
  if (certificate.chaotic_from) json["chaotic_from"] = *certificate.chaotic_from;
  return json;
}

}  // namespace taut
