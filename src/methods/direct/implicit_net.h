#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "direct/implicit_bends.h"
#include "direct/link_system.h"
#include "methods/method.h"

namespace taut {

/// Backward Euler for links in nets and for bends: finds positions and tensions that balance at the end of
/// the step, to the last digit in the lengths.
class ImplicitNet {
 public:
  /// For the given whole links and bends. Which links are hard (solved by multipliers) and which soft (forces
  /// in the masses' matrix) is decided for steps of h seconds; shorter ones may be asked for.
  ImplicitNet(const Model& model, const std::vector<Index>& whole, std::vector<Bend> bends, double h);

  /// Moves `position`, where the masses would be at the end of a step of h seconds from `start` without
  /// links, to where the links allow. `tension` (N) holds the tensions at the start of the step and takes
  /// those at its end. False, with the reason in the report, where it does not converge.
  bool solve(const Vectors& start, double h, Vectors& position, std::vector<double>& tension,
             StepReport& report);

 private:
  // Masses' and hard links' parts of a vector of the linear system.
  struct Pair {
    Vectors mass;               // m
    std::vector<double> links;  // kg m
  };

  void prepare(const Vectors& start, double h, const std::vector<double>& tension);
  void measure(const Vectors& position, double h);
  double worst_length_error(StepReport& report) const;
  double worst_imbalance() const;
  double largest_move(double h) const;
  void linearise(double h);
  void limit_push();
  bool factor(const Vectors& position, double h);
  bool factor_whole(const Vectors& position, double h);
  std::int64_t solve_whole();
  std::int64_t solve_linear(bool seek_balance);
  void precondition(const std::vector<double>& lengths, Pair& answer);
  void multiply(const Pair& change, Vectors& force) const;
  void spread(const Vectors& direction, double factor, const std::vector<double>& pull, Vectors& force) const;
  double inertia_square(const Vectors& change) const;

  const Model& model_;
  ImplicitBends bends_;
  std::optional<BalanceMatrix> whole_;   // of the linear system, where there are bends
  SystemLinks links_;                    // hard ones in the order of their matrix, then soft ones
  std::size_t hard_ = 0;                 // how many of them are hard
  LinkSystem preconditioner_;            // the hard links, between masses of inertia_
  std::vector<Index> free_;              // masses that are not pinned
  std::vector<double> inertia_;          // kg, one a mass: its own and that of its soft links; 0 for pins
  std::vector<double> inverse_inertia_;  // 1/kg; 0 for pins
  std::vector<double> mass_;             // kg, one a mass, with drag's part
  std::vector<double> inverse_length_;   // 1/m
  double tolerance_ = 0.0;               // of length errors, relative

  Vectors inertial_, start_vector_;
  // At the present round's positions, one a link: unit vector, length now, pull × h² (kg m).
  Vectors direction_;
  std::vector<double> distance_, pull_;
  std::vector<double> length_error_;  // m, one a hard link
  Vectors imbalance_;                 // kg m, one a mass
  // The linear system: direction and stiffness × h² along and across each link, compliance of hard links.
  Vectors axis_;
  std::vector<double> along_, across_, diagonal_, scale_;
  std::vector<double> push_;
  // Work space of its solution.
  Pair change_, step_, search_;
  Vectors residual_, image_, force_;
  std::vector<double> length_residual_;
};

}  // namespace taut
