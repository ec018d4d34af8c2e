#include "frames/picture_price.h"

namespace taut {

double predicted_picture_seconds(const Model& model, const RenderSettings& settings) {
  // Seconds each: a picture at all, a mass that is shaped, a pixel, and a sample of it, of what is empty and
  // of what is covered from edge to edge.
  constexpr double picture = 2e-3, mass = 2e-6;
  constexpr double empty_pixel = 6.5e-9, empty_sample = 0.6e-9, covered_pixel = 8e-9, covered_sample = 4e-9;
  constexpr double bone_in_triangles = 20.0, half_covered = 300.0;  // triangles, or links
  const double things = static_cast<double>(model.triangles.size() + model.links.size()) +
                        bone_in_triangles * static_cast<double>(model.bones.size());
  const double covered = things / (things + half_covered);
  const double pixels = static_cast<double>(settings.size.width) * settings.size.height;
  const auto cost_of = [&](double pixel, double sample) { return pixel + sample * settings.samples; };
  return picture + mass * static_cast<double>(model.masses.size()) +
         pixels * ((1.0 - covered) * cost_of(empty_pixel, empty_sample) +
                   covered * cost_of(covered_pixel, covered_sample));
}

}  // namespace taut
