// What a method says that its system takes, beside what the heap has grown by once a step is made.

#include <gtest/gtest.h>

#include "sanitized.h"

#ifndef TAUT_SANITIZED  // of the heap of sanitizers mallinfo2() knows nothing

#include <malloc.h>

#include <ostream>
#include <string>

#include "fixtures.h"
#include "methods/registry.h"
#include "motion/run.h"

namespace taut::test {
namespace {

double bytes_of_heap() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

struct Net {
  std::string method;
  bool diagonals = false, bends = false;

  friend std::ostream& operator<<(std::ostream& out, const Net& net) {
    return out << net.method << (net.diagonals ? ", diagonals" : "") << (net.bends ? ", bends" : "");
  }
};

Description sheet_of(const Net& net, int side) {
  Description description;
  SheetSpec sheet;
  sheet.name = "cloth";
  sheet.rows = sheet.columns = side;
  sheet.from = {0.0, 2.0, 0.0};
  sheet.to = {2.0, 2.0, 0.0};
  sheet.down = {0.0, -2.0, 0.0};
  sheet.pinned = {"top"};
  if (net.method == "spring-implicit") sheet.properties.stiffness = 1000.0;
  if (net.diagonals) sheet.diagonals = sheet.properties;
  if (net.bends) {
    sheet.bending.emplace();
    sheet.bending->stiffness = 1e-3;
  }
  description.sheets = {sheet};
  return description;
}

taut::Run run_of(const Built& built, const std::string& method) {
  const bool chooses = find_method(method)->can.chooses_steps;
  return {built.model, built.start, chooses ? Settings{method, {}} : settings(method, 960.0)};
}

double grown_by_a_step(const Built& built, const std::string& method) {
  taut::Run run = run_of(built, method);
  const double before = bytes_of_heap();
  EXPECT_TRUE(run.step()) << run.failure();
  return bytes_of_heap() - before;
}

class SolveMemory : public ::testing::TestWithParam<Net> {};

// A peak, which is what is foretold, is up to twice of what stays.
TEST_P(SolveMemory, IsForetold) {
  const Method& method = *find_method(GetParam().method);
  for (const int side : {48, 96}) {
    const Built built = build_valid(sheet_of(GetParam(), side));
    const double grown = grown_by_a_step(built, GetParam().method), foretold = method.memory(built.model);
    EXPECT_GT(foretold, 0.8 * grown) << side;
    EXPECT_LT(foretold, 2.5 * grown) << side;
  }
}

// Pictures of a start make no step.
TEST_P(SolveMemory, IsTakenWhenAStepIsMade) {
  const std::string& name = GetParam().method;
  const Built built = build_valid(sheet_of(GetParam(), 96));
  const double before = bytes_of_heap();
  const taut::Run run = run_of(built, name);
  EXPECT_EQ(run.state().time, 0.0);
  EXPECT_LT(bytes_of_heap() - before, 0.2 * find_method(name)->memory(built.model));
}

INSTANTIATE_TEST_SUITE_P(Nets, SolveMemory,
                         ::testing::Values(Net{"newton"}, Net{"newton", true}, Net{"newton", false, true},
                                           Net{"rattle"}, Net{"rattle", true}, Net{"dop853"},
                                           Net{"spring-implicit"}, Net{"spring-implicit", true}));

TEST(SolveMemoryOf, ChainsAndMethodsThatGoLinkByLinkTakeNone) {
  const Built chain = build_valid(level_chain(1000, 0.1));
  for (const char* method : {"newton", "rattle", "dop853"})
    EXPECT_EQ(find_method(method)->memory(chain.model), 0.0) << method;
  EXPECT_EQ(find_method("xpbd")->memory, nullptr);
}

// Links with stiffness are forces to these, and rows to newton.
TEST(SolveMemoryOf, SpringsAreNoneToMethodsThatHaveThemAsForces) {
  const Built springs = build_valid(sheet_of({"spring-implicit"}, 48));
  for (const char* method : {"rattle", "dop853"})
    EXPECT_EQ(find_method(method)->memory(springs.model), 0.0) << method;
  EXPECT_GT(find_method("newton")->memory(springs.model), 1e6);
}

}  // namespace
}  // namespace taut::test

#endif
