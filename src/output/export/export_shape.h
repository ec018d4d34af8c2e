#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/model.h"
#include "model/state.h"

namespace taut {

/// A face between three or four masses, in the sense of the sheet's triangles.
struct ExportFace {
  std::array<Index, 4> masses{};
  std::uint8_t corners = 4;
};

/// What stands for a model in a format of points, lines and faces: the whole cells of each sheet with faces,
/// the whole links that are edges of none of these, and masses that then have nothing. Links that stand in
/// for a sheet's stiffness don't show.
struct ExportShape {
  std::vector<std::vector<ExportFace>> sheets;  ///< one a sheet of the model
  std::vector<Index> links;                     ///< of the model, rising
  std::vector<Index> masses;                    ///< of the model, rising
};

/// The shape while these links are broken. `faces` says which sheets have faces; the others are nets, and
/// show as links.
ExportShape export_shape(const Model& model, const std::vector<bool>& faces, const State& state);

/// The shape from instant to instant, made anew only where something has broken.
class ShapeInTime {
 public:
  /// Refers to both from then on.
  ShapeInTime(const Model& model, const std::vector<bool>& faces) : model_(model), faces_(faces) {}
  /// The shape of a state that is not before the one asked for last.
  const ExportShape& at(const State& state);
  /// Whether the last call gave another shape than the one before it, or was the first.
  bool changed() const { return changed_; }

 private:
  const Model& model_;
  const std::vector<bool>& faces_;
  ExportShape shape_;
  std::size_t broken_ = 0;
  bool begun_ = false, changed_ = false;
};

/// The way that a model's up direction is turned by to point along y: what formats with an up axis of their
/// own turn a scene by.
Eigen::Quaterniond turn_to_y_up(const Model& model);

}  // namespace taut
