#include <fmt/format.h>

#include "builder.h"
#include "model/measures.h"

namespace taut {
namespace {

constexpr double noticeable = 1e-3;  // of the scene's size, that something may be inside

bool is_held(const Model& model, const ContactPoint& point) {
  for (std::size_t k = 0; k < point.masses.size(); ++k)
    if (point.weights[k] != 0.0 && !model.masses.pinned(point.masses[k])) return false;
  return true;
}

}  // namespace

void find_starts_inside(const Builder& builder, const Description& description,
                        std::vector<Problem>& problems) {
  const Model& model = builder.model;
  const double allowed = noticeable * scene_size(model, builder.start);
  for (std::size_t i = 0; i < model.colliders.size(); ++i) {
    if (!model.colliders[i].motion) continue;
    const Shape shape = shape_at(model.colliders[i], 0.0);
    for (const ContactPoint& point : model.contacts) {
      if (is_held(model, point)) continue;
      const double depth =
          point.radius - nearest_surface(shape, value_at(point, builder.start.position)).distance;
      if (!(depth > allowed)) continue;
      const auto [section, index] = solid_entry(description, i);
      problems.push_back({std::string(section), index, "",
                          fmt::format("it moves, and at the start \"{}\" is {:.4g} m inside it",
                                      model.masses.name[point.masses[0]], depth),
                          ""});
      break;  // one tells of its kind
    }
  }
}

}  // namespace taut
