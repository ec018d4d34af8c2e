// Every method on every scene that is known to break methods. Each run must end in a finite state within a
// stated bound, or in one clear error that keeps the last good state bit for bit; never in NaN, never in a
// hang.

#include "stability/hard_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>

#include "base/failure.h"
#include "motion/run.h"
#include "physics/fixtures.h"
#include "stability/same_bits.h"

namespace taut::test {
namespace {

// How far the masses of a scene can get (m): all links in a row, a free fall, their own speed, the pins' way.
double farthest(const Built& built, double duration) {
  double reach = total_link_length(built.model) + 0.5 * built.model.gravity.norm() * duration * duration;
  double speed = 0.0, pins = 0.0, apart = 0.0;
  for (std::size_t i = 0; i < built.start.position.size(); ++i) {
    speed = std::max(speed, built.start.velocity.at(i).norm());
    apart = std::max(apart, (built.start.position.at(i) - built.start.position.at(0)).norm());
  }
  for (const DrivenPin& pin : built.model.driven_pins)
    for (int i = 0; i <= 100; ++i)
      pins = std::max(pins,
                      (position_at(pin.motion, duration * i / 100.0) - position_at(pin.motion, 0.0)).norm());
  return reach + speed * duration + apart + 2.0 * pins;
}

double farthest_moved(const State& start, const State& end) {
  double moved = 0.0;
  for (std::size_t i = 0; i < start.position.size(); ++i)
    moved = std::max(moved, (end.position.at(i) - start.position.at(i)).norm());
  return moved;
}

class HardCases : public ::testing::TestWithParam<std::string> {
 protected:
  const Method& method() const { return *find_method(GetParam()); }

  // Runs a scene. Returns what a person would be told where it did not run to its end, else nothing.
  std::optional<std::string> run_hard(const Built& built, double rate, const HardCase& hard) {
    const Settings complete = complete_settings(settings(GetParam(), rate));
    const std::vector<std::string> problems = refusals(built.model, built.start, complete);
    if (!problems.empty()) return problems.front();
    taut::Run run(built.model, built.start, complete);
    const auto steps = std::llround(hard.duration * rate);
    while (run.steps() < steps) {
      const State before = run.state();
      if (!run.step()) {
        if (run.report().end == RunEnd::step_failed) {
          EXPECT_TRUE(same_bits(run.state(), before)) << "the last good state is not kept";
        }
        EXPECT_TRUE(all_finite(run.state()));
        return run.failure();
      }
      if (!all_finite(run.state())) {
        ADD_FAILURE() << "not finite after step " << run.steps();
        return std::nullopt;
      }
    }
    if (!run.holds_together()) return run.failure();
    const State& state = run.state();
    const RunMeasures measures = run.measures(state);
    if (hard.lightest_may_fly) {
      EXPECT_LE(measures.energy_error, 1e3);
    } else {
      EXPECT_LE(farthest_moved(built.start, state), farthest(built, hard.duration));
    }
    return std::nullopt;
  }
};

TEST_P(HardCases, EndInAFiniteStateOrOneClearError) {
  for (const HardCase& hard : hard_cases()) {
    for (const double stiffness : {infinity, 1e4}) {
      const Description description =
          stiffness == infinity ? hard.description : with_springs(hard.description, stiffness);
      const Built built = build_valid(description);
      for (const double rate : hard.rates) {
        SCOPED_TRACE(hard.name + (stiffness == infinity ? ", rigid" : ", elastic") +
                     ", steps/s: " + std::to_string(rate));
        const auto error = run_hard(built, rate, hard);
        if (error) {
          EXPECT_GT(error->size(), 20U);
          EXPECT_NE(error->find(GetParam()), std::string::npos) << *error;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, HardCases, ::testing::ValuesIn(every_method()), case_name);

}  // namespace
}  // namespace taut::test
