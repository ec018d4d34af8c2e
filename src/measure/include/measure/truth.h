#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "measure/reference.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// What can be wrong about a run. Each error is a pure number.
enum class ErrorKind {
  trajectory,  ///< largest distance of a mass from where it should be, over the times looked at, by
               ///< scene_size()
  strain,      ///< largest |strain| of the rigid links over those times; where no link is rigid: largest
               ///< difference of a link's strain from what it should be
  energy,      ///< the same of the total energy, by energy_scale()
  sag,         ///< largest difference of the sag from what it should be, by scene_size()
};
inline constexpr std::array all_error_kinds{ErrorKind::trajectory, ErrorKind::strain, ErrorKind::energy,
                                            ErrorKind::sag};
std::string_view name_of(ErrorKind kind);

/// A number for every kind of error; nothing where that kind can't be judged.
class Errors {
 public:
  std::optional<double>& operator[](ErrorKind kind) { return values_[static_cast<std::size_t>(kind)]; }
  const std::optional<double>& operator[](ErrorKind kind) const {
    return values_[static_cast<std::size_t>(kind)];
  }

 private:
  std::array<std::optional<double>, all_error_kinds.size()> values_;
};

/// A state in three numbers.
struct Summary {
  double sag = 0.0;     ///< m
  double energy = 0.0;  ///< J, in total
  double strain = 0.0;  ///< largest |strain|
};
Summary summary_of(const Model& model, const State& state);

/// How far two summaries are apart, each number by its size; no trajectory.
Errors difference(const Model& model, const State& start, const Summary& a, const Summary& b);

/// What is true of a scene up to a horizon, and how small an error can be judged by it.
struct Truth {
  std::vector<double> times;  ///< s, rising, at which runs are looked at; the last one is the horizon
  std::vector<State> states;  ///< the certified motion, one a time; empty where no motion can be certified
  bool certified = false;     ///< the motion, by a reference
  std::vector<Summary> summaries;  ///< one a time; there without a motion, too
  Errors smallest;     ///< of each kind, the smallest error that can be judged; absent: that kind can't be
  std::string how;     ///< what it was made with, for people
  std::string remark;  ///< what can't be judged and why; may be empty

  double horizon() const { return times.back(); }
};

/// Where any link is rigid, `strain` needs no reference, and rounding alone limits it.
inline constexpr double exact_length_limit = 1e-14;

/// What a certified reference says. Errors are judged down to a hundred times its uncertainty.
Truth truth_from(const Model& model, const State& start, const Reference& reference);

/// One kind of error of a run against the true states at the same times.
double error_against(const Model& model, const State& start, ErrorKind kind, std::span<const State> states,
                     std::span<const State> truth);

/// The errors of a run that was looked at at the truth's times, those kinds that the truth can judge.
Errors judge(const Model& model, const State& start, const Truth& truth, const std::vector<State>& states);

}  // namespace taut
