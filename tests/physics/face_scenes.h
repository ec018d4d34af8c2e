#pragma once

#include <random>

#include "exact_solids.h"
#include "fixtures.h"
#include "model/face_depth.h"
#include "model/measures.h"
#include "model/tangles.h"

namespace taut::test {

/// The methods that know faces.
inline std::vector<std::string> face_methods() {
  return methods_that([](const Capabilities& can) { return can.faces; });
}

/// A sheet around a middle, with its edges' directions as the first and third column of a frame.
inline SheetSpec sheet_around(std::string name, const Vec3& middle, const Eigen::Matrix3d& frame,
                              double width, int cells, double thickness) {
  SheetSpec sheet;
  sheet.name = std::move(name);
  sheet.rows = sheet.columns = cells + 1;
  const Vec3 along = width * frame.col(0), down = width * frame.col(2);
  sheet.from = middle - 0.5 * (along + down);
  sheet.to = sheet.from + along;
  sheet.down = down;
  sheet.mass = 0.2 * width * width;
  sheet.properties.stiffness = 500.0;
  sheet.properties.damping = 0.2;
  sheet.diagonals = sheet.properties;
  sheet.faces = FacesSpec{thickness, 0.3, true};
  sheet.collides = true;
  return sheet;
}

/// For a method that knows no springs, rigid links along rows and columns.
inline Built built_for(const std::string& method, Description description) {
  if (!find_method(method)->can.stiffness)
    for (SheetSpec& sheet : description.sheets) {
      sheet.properties = {};
      sheet.diagonals.reset();
    }
  return build_valid(description);
}

inline Eigen::Matrix3d random_frame(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
      .normalized()
      .toRotationMatrix();
}

/// Whether a point is above a sheet that lies more or less flat, or beside it.
inline bool is_above(const Vec3& point, const Model& model, const State& state, const Sheet& sheet) {
  for (Index i = sheet.first_triangle; i < sheet.first_triangle + sheet.triangle_count; ++i) {
    const auto& masses = model.triangles[i].masses;
    const Vec3 a = state.position.at(masses[0]), b = state.position.at(masses[1]),
               c = state.position.at(masses[2]);
    const Vec3 down(0.0, -1e3, 0.0), up(0.0, 1e3, 0.0);
    if (goes_through(point, point + down, {a, b, c})) return true;
    if (goes_through(point, point + up, {a, b, c})) return false;
  }
  return true;  // beside it
}

}  // namespace taut::test
