#pragma once

#include <optional>
#include <string>
#include <vector>

#include "methods/method.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// The largest tension that every link bears over a duration (N), one a link: from a run with rattle whose
/// step is halved until the largest of them changes by less than 1 %. Nothing where that does not settle.
std::optional<std::vector<double>> largest_tensions(const Model& model, const State& start, double duration);

/// A limit that theory gives, and the formula it comes from.
struct Prediction {
  double value = 0.0;  ///< s, or passes
  std::string formula;
};

/// The longest step (s) that theory gives a method (Capabilities::limit), or nothing where it gives none:
/// 2/ω_max with the power iteration's ω_max of the start, and √(m l/T), the least over all rigid links of
/// length l with m the lighter free end and T the link's entry in `tensions`. Without tensions only the
/// former.
std::optional<Prediction> predicted_step(const Model& model, const State& start, const Method& method,
                                         const std::optional<std::vector<double>>& tensions);

/// The highest frequency of a long chain of masses m on springs k: 2√(k/m) (rad/s).
double chain_frequency(double stiffness, double mass);

/// The highest frequency of a large square net with springs k_s along its sides and k_d along its diagonals:
/// √(4 (k_s + k_d)/m) (rad/s).
double net_frequency(double side_stiffness, double diagonal_stiffness, double mass);

/// Gauss–Seidel passes that shrink a stretch of a chain 1000 times, the last mass `ratio` times as heavy as
/// the others: 2.9 n² for equal masses, n·ratio for heavy tips, whichever is more.
double predicted_passes(double links, double ratio);

/// The energy that masses gain which hang while their velocities keep what gravity adds to them,
/// Σ m (g t)²/2, over the energy scale.
double kept_velocity_gain(const Model& model, const State& start, double duration);

}  // namespace taut
