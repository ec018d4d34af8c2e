// States that no method has made: NaN and infinity put in from outside, and linked masses at one point.

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "physics/fixtures.h"
#include "stability/hard_cases.h"
#include "stability/same_bits.h"

namespace taut::test {
namespace {

// A pin, four masses in a chain, a pin driven beside them, and a free and a pinned mass that no link holds.
Description small_scene(bool rigid) {
  Description description = level_chain(4, 0.1);
  for (const char* name : {"alone", "nail", "hand"}) {
    MassSpec mass;
    mass.name = name;
    mass.position = {0.4, 0.1 * static_cast<double>(description.masses.size() + 1), 0.0};
    mass.pinned = mass.name != "alone";
    description.masses.push_back(mass);
  }
  description.masses[2].motion.sinusoid = SinusoidSpec{{0.0, 0.1, 0.0}, 1.0, 0.0};
  return rigid ? description : with_springs(description, 1e4);
}

class BadState : public ::testing::TestWithParam<std::string> {
 protected:
  const Method& method() const { return *find_method(GetParam()); }
  Built built() const { return build_valid(small_scene(method().can.rigid)); }
};

TEST_P(BadState, NumbersThatAreNoneAreAnErrorAndNothingIsChanged) {
  const Built scene = built();
  const Settings complete = complete_settings({GetParam(), {}});
  const double h = complete.chooses_steps() ? 1.0 / 60.0 : 1.0 / complete.steps_per_second();
  const std::size_t masses = scene.model.masses.size();
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity}) {
    // Place 0 is the time; then come the coordinates of positions, then those of velocities, of every mass. A
    // driven pin is put in its place at every step, whatever stood there.
    for (std::size_t place = 0; place <= 2 * masses; ++place) {
      const std::size_t mass = (place + masses - 1) % masses;
      if (place > 0 && scene.model.masses.name[mass] == "hand") continue;
      SCOPED_TRACE(std::to_string(bad) + " at place " + std::to_string(place));
      const auto stepper = method().make(scene.model, complete, {});
      stepper->load(scene.start);
      ASSERT_EQ(stepper->step(h, h).status, StepStatus::done);
      State state = stepper->store();
      (place == 0 ? state.time : (place <= masses ? state.position : state.velocity).y[mass]) = bad;
      stepper->load(state);
      const StepReport report = stepper->step(h, state.time + h);
      EXPECT_EQ(report.status, StepStatus::not_finite) << static_cast<int>(report.status);
      EXPECT_TRUE(same_bits(stepper->store(), state));
    }
  }
}

// With no direction between them a link can't be solved along it: the masses stay finite, or it is an error.
TEST_P(BadState, LinkedMassesAtOnePointStayFiniteOrAreAnError) {
  const Built scene = built();
  const Settings complete = complete_settings({GetParam(), {}});
  State state = scene.start;
  state.position.set(2, state.position.at(1));
  if (!refusals(scene.model, state, complete).empty()) return;  // by name, before the run
  taut::Run run(scene.model, state, complete);
  for (int step = 0; step < 100; ++step) {
    const State before = run.state();
    if (!run.step()) {
      EXPECT_TRUE(same_bits(run.state(), before));
      return;
    }
    ASSERT_TRUE(all_finite(run.state())) << "step " << step;
    EXPECT_LT(run.state().position.at(1).norm(), 1.0);
  }
}

TEST(BadDescription, ALinkWithoutLengthIsRefused) {
  Description description = pendulum();
  description.links[0].length = 0.0;
  const Built refused = build(description);
  ASSERT_EQ(refused.problems.size(), 1U);
  EXPECT_EQ(refused.problems[0].key, "length");
}

INSTANTIATE_TEST_SUITE_P(Methods, BadState, ::testing::ValuesIn(every_method()), case_name);

}  // namespace
}  // namespace taut::test
