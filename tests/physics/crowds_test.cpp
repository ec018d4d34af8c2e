// Bodies that come together in numbers that are not solved: the run says so and ends.

#include <fmt/format.h>

#include <cmath>

#include "fixtures.h"
#include "motion/run.h"

namespace taut::test {
namespace {

// Pins that are all driven into one place; one pair more than is solved takes 6326 of them.
Description pins_that_meet(int count) {
  Description description;
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  for (int i = 0; i < count; ++i) {
    MassSpec pin;
    pin.name = fmt::format("pin{}", i);
    pin.position = {static_cast<double>(i % side), 0.0, static_cast<double>(i / side)};
    pin.pinned = pin.collides = true;
    pin.radius = 0.05;
    pin.motion.path = {{0.0, pin.position}, {1.0, Vec3::Zero()}};
    description.masses.push_back(pin);
  }
  return description;
}

TEST(Crowds, ThatFormDuringARunEndItInWords) {
  const Built built = build_valid(pins_that_meet(6400));
  taut::Run run(built.model, built.start, settings("xpbd", 10.0));
  EXPECT_FALSE(run.at(1.0));
  EXPECT_TRUE(run.ended());
  EXPECT_NE(run.failure().find("more than 20 million pairs of its balls touch"), std::string::npos)
      << run.failure();
  EXPECT_DOUBLE_EQ(run.state().time, 0.9) << "as long as there are fewer, all is solved";
}

TEST(Crowds, ThatCanBeSolvedAre) {
  const Built built = build_valid(pins_that_meet(1000));
  taut::Run run(built.model, built.start, settings("xpbd", 10.0));
  EXPECT_TRUE(run.at(1.0)) << run.failure();
}

}  // namespace
}  // namespace taut::test
