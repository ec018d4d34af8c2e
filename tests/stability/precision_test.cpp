// Single precision beside double: at which step does rounding win?

#include <gtest/gtest.h>

#include <cmath>

#include "base/failure.h"
#include "measure/reference.h"
#include "model/measures.h"
#include "physics/fixtures.h"

namespace taut::test {
namespace {

Settings in_precision(const char* precision, double h) {
  Settings given = settings("xpbd", 1.0 / h, 1.0);
  given.values["precision"] = precision;
  return given;
}

class Precision : public ::testing::Test {
 protected:
  // The position error after half a second (m).
  double error(const char* precision, double h) const {
    return position_error(run(chain_, in_precision(precision, h), 0.5), truth_.states.back());
  }

  Built chain_ = build_valid(level_chain(10, 0.1));
  Reference truth_ = make_reference(chain_.model, chain_.start, {0.5}, 1e-6);
};

TEST_F(Precision, SingleIsAsGoodWhereTheStepIsTheLargerError) {
  ASSERT_TRUE(truth_.certified());
  for (const double h : {5e-3, 1e-3}) EXPECT_NEAR(error("single", h) / error("double", h), 1.0, 0.1) << h;
}

TEST_F(Precision, RoundingWinsAtTinySteps) {
  ASSERT_TRUE(truth_.certified());
  EXPECT_LT(error("double", 1e-5), 0.02 * error("double", 1e-3));
  EXPECT_GT(error("single", 1e-5), 10.0 * error("double", 1e-5));
}

// A mass at a height of 1 m whose fall within a step, g h², is less than half of ε = 2⁻²³ does not move at
// all.
TEST(SinglePrecision, LosesGravityBelowItsLastPlace) {
  Description description;
  MassSpec ball;
  ball.name = "ball";
  ball.position = {0.0, 1.5, 0.0};
  description.masses = {ball};
  const Built built = build_valid(description);
  const double limit = std::sqrt(0.5 * std::ldexp(1.0, -23) / 9.81);
  for (const double share : {0.5, 2.0}) {
    State state = built.start;
    simulate(built.model, state, in_precision("single", share * limit), 1000);
    const double exact = 0.5 * 9.81 * std::pow(1000.0 * share * limit, 2.0);
    if (share < 1.0) {
      EXPECT_EQ(state.position.y[0], 1.5);
    } else {
      EXPECT_NEAR((1.5 - state.position.y[0]) / exact, 1.0, 0.5);
    }
  }
}

TEST(SinglePrecision, RefusesWhatItDoesNotModel) {
  Built built = build_valid(level_chain(2, 0.1));
  built.model.wind.emplace();
  EXPECT_THROW(simulate(built.model, built.start, in_precision("single", 1e-3), 1), BadRequest);
}

}  // namespace
}  // namespace taut::test
