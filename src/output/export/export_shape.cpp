#include "export/export_shape.h"

#include <algorithm>

#include "model/measures.h"

namespace taut {
namespace {

bool is_whole(const Triangle& triangle, const State& state) {
  return std::ranges::none_of(triangle.links,
                              [&](Index link) { return link != no_link && state.broken(link); });
}

ExportFace face_of(const Triangle& triangle) {
  return {{triangle.masses[0], triangle.masses[1], triangle.masses[2], 0}, 3};
}

// The cell that the two triangles make: they lie one after the other, and share their diagonal.
ExportFace cell_of(const Triangle& upper, const Triangle& lower) {
  return {{upper.masses[0], upper.masses[1], lower.masses[2], upper.masses[2]}, 4};
}

std::vector<ExportFace> whole_cells(const Model& model, const Sheet& sheet, const State& state,
                                    std::vector<bool>& is_edge) {
  std::vector<ExportFace> faces;
  faces.reserve(sheet.triangle_count / 2);
  for (Index i = 0; i + 1 < sheet.triangle_count; i += 2) {
    const Triangle& upper = model.triangles[sheet.first_triangle + i];
    const Triangle& lower = model.triangles[sheet.first_triangle + i + 1];
    const bool upper_whole = is_whole(upper, state), lower_whole = is_whole(lower, state);
    if (upper_whole && lower_whole)
      faces.push_back(cell_of(upper, lower));
    else if (upper_whole)
      faces.push_back(face_of(upper));
    else if (lower_whole)
      faces.push_back(face_of(lower));
    for (const Triangle* triangle : {&upper, &lower})
      if (triangle == &upper ? upper_whole : lower_whole)
        for (const Index link : triangle->links)
          if (link != no_link) is_edge[link] = true;
  }
  return faces;
}

}  // namespace

ExportShape export_shape(const Model& model, const std::vector<bool>& faces, const State& state) {
  ExportShape shape;
  std::vector<bool> is_edge(model.links.size(), false), used(model.masses.size(), false);
  shape.sheets.reserve(model.sheets.size());
  for (std::size_t i = 0; i < model.sheets.size(); ++i) {
    auto& cells = shape.sheets.emplace_back();
    if (faces[i]) cells = whole_cells(model, model.sheets[i], state, is_edge);
    for (const ExportFace& face : cells)
      for (std::size_t corner = 0; corner < face.corners; ++corner) used[face.masses.at(corner)] = true;
  }
  for (Index link = 0; link < model.links.size(); ++link) {
    if (is_edge[link] || state.broken(link) || model.links.family[link] != LinkFamily::structural) continue;
    shape.links.push_back(link);
    used[model.links.a[link]] = used[model.links.b[link]] = true;
  }
  for (Index mass = 0; mass < model.masses.size(); ++mass)
    if (!used[mass]) shape.masses.push_back(mass);
  return shape;
}

const ExportShape& ShapeInTime::at(const State& state) {
  const std::size_t broken = broken_links(state);
  changed_ = !begun_ || broken != broken_;
  if (changed_) shape_ = export_shape(model_, faces_, state);
  begun_ = true;
  broken_ = broken;
  return shape_;
}

Eigen::Quaterniond turn_to_y_up(const Model& model) {
  return Eigen::Quaterniond::FromTwoVectors(up_direction(model), Vec3::UnitY());
}

}  // namespace taut
