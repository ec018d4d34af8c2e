// Small Steps (Macklin et al., 2019), section 6.1: 20 masses of 1 kg in a line, 0.01 m apart, one end pinned,
// the last mass 100,000 times as heavy, with 100 units of work per frame of 1/60 s.

#include <gtest/gtest.h>

#include <cmath>

#include "model/measures.h"
#include "physics/fixtures.h"

namespace taut::test {
namespace {

// The error in length of the whole chain, over its length, once it hangs at rest.
double length_error(const Settings& settings) {
  constexpr int links = 19;
  constexpr double length = links * 0.01;  // m
  Description description = level_chain(links, 0.01);
  description.drag = 1.0;  // 1/s
  description.chains[0].to = {0.0, -length, 0.0};
  description.chains[0].last_mass = 1e5;
  const State state = run(build_valid(description), settings, 60.0);
  EXPECT_LT(fastest_speed(state), 1e-3);
  return -state.position.y.back() / length - 1.0;
}

// The stretch falls as 1/passes and as 1/substeps²: at 100 units of work 1 % of it is left. One solve of all
// links together a frame leaves nothing but rounding: below 1e-12, more than 10¹² times less than either.
TEST(UnitsOfWork, SubstepsBeatPassesAndOneSolveOfAllBeatsBoth) {
  const double passes = length_error(settings("xpbd", 60.0, 100.0));
  const double substeps = length_error(settings("xpbd", 6000.0, 1.0));
  EXPECT_NEAR(passes / substeps, 100.0, 10.0) << passes << " against " << substeps;
  EXPECT_LT(std::abs(length_error(settings("newton", 60.0))), 1e-12);
}

}  // namespace
}  // namespace taut::test
