#pragma once

#include <string>
#include <vector>

#include "model/description.h"

namespace taut::test {

/// A scene that breaks methods.
struct HardCase {
  std::string name;
  Description description;
  double duration = 0.5;                   ///< s
  std::vector<double> rates{60.0, 600.0};  ///< steps/s
  bool lightest_may_fly = false;           ///< only the energy is bounded, not how far masses get
};

/// One or several scenes of every kind that is known to break methods, with rigid links.
std::vector<HardCase> hard_cases();

/// Gives every link a stiffness (N/m) and takes away what only goes with rigid ones.
Description with_springs(Description description, double stiffness);

}  // namespace taut::test
