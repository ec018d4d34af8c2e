#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "model/face_mesh.h"
#include "model/state.h"

namespace taut {

/// Whether a straight edge goes through a triangle.
enum class Piercing {
  none,
  through,
  unclear,  ///< they are so near that rounding hides it
};

/// Decided by the signs of volumes, each only where it is beyond what rounding can do to it (Shewchuk,
/// Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997, the first of his
/// bounds). So `none` is certain, for any doubles.
Piercing piercing(const std::array<Vec3, 2>& edge, const std::array<Vec3, 3>& triangle);

/// An edge that goes through a triangle, or lies in it, by nodes of a mesh.
struct Tangle {
  std::array<std::uint32_t, 2> edge{};
  std::array<std::uint32_t, 3> triangle{};
};

/// All places where faces that are kept apart go through each other, or through boxes, unless there are more
/// than `most`: none exactly where no two triangles without a common corner have a place in common, and of
/// those with one no other.
std::vector<Tangle> find_tangles(const FaceMesh& mesh, const WholeFaces& whole,
                                 const std::vector<Vec3>& places, std::size_t most);

/// How many there are.
std::size_t tangled_places(const Model& model, const State& state);

}  // namespace taut
