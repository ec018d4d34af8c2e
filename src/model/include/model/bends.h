#pragma once

#include <array>
#include <vector>

#include "model/limits.h"

namespace taut {

/// A place where a chain or a sheet resists being bent: three masses in a row, and the turn φ at the middle
/// one away from straight, 0 to π. Its energy is k (φ − φ₀)²/2: a rod of bending stiffness EI (N m²) whose
/// masses are l apart has k = EI/l (Bergou et al., Discrete Elastic Rods, 2008, eq. 2).
struct Bend {
  std::array<Index, 3> masses{};
  double stiffness = 0.0;  ///< N m/rad
  double rest = 0.0;       ///< rad, φ₀
  /// The links that hold the three together, as far as there are; where one is broken nothing is resisted.
  std::array<Index, 4> links{no_link, no_link, no_link, no_link};
};

/// The turn at a bend and its gradient with respect to each of its masses (rad/m). The gradient at φ = 0,
/// where the way the masses will leave the line is open, is one of those that are as good.
struct BendAngle {
  double angle = 0.0;  ///< rad
  std::array<Vec3, 3> gradient;
};

BendAngle bend_gradients(const Bend& bend, const Vectors& position);

struct Model;
struct State;

/// Whether none of its links is broken.
bool is_whole(const Bend& bend, const State& state);

/// The bends of a model that none of their links' breaking has undone.
std::vector<Bend> whole_bends(const Model& model, const State& state);

/// What the bends hold (J).
double bending_energy(const Model& model, const State& state);

}  // namespace taut
