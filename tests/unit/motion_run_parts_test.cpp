// In what parts a run makes steps that its method can't make whole.

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "methods/registry.h"
#include "model/description.h"
#include "motion/run.h"
#include "motion/run_state.h"

namespace taut {
namespace {

constexpr double whole_step = 0.125;                           // s, and so exact in parts
constexpr double hard_from = 0.5, hard_until = 1.5;            // s
constexpr double longest_when_hard = 1.01 * whole_step / 8.0;  // s

// Moves nothing; between two times it only makes short steps. Each try is a round.
class SometimesHard final : public Stepper {
 public:
  void load(const State& state) override { state_ = state; }
  StepReport step(double h, double end_time) override {
    StepReport report;
    report.rounds = 1;
    if (end_time > hard_from && end_time <= hard_until && h > longest_when_hard)
      report.status = StepStatus::not_converged;
    else
      state_.time = end_time;
    return report;
  }
  void undo() override {}
  const State& store() override { return state_; }

 private:
  State state_;
};

class RunParts : public ::testing::Test {
 protected:
  RunParts() {
    Description description;
    description.masses.push_back(MassSpec{});
    description.masses.back().name = "one";
    scene_ = build(description);
    method_.name = "mine";
    method_.make = [](const Model&, const Settings&, const Execution&) -> std::unique_ptr<Stepper> {
      return std::make_unique<SometimesHard>();
    };
  }

  taut::Run begin() const { return taut::Run(scene_.model, scene_.start, method_, settings_); }

  Built scene_;
  Method method_ = *find_method("newton");
  Settings settings_{"", {{"steps_per_second", 1.0 / whole_step}}};
};

// How often each of so many steps is tried.
std::vector<std::int64_t> tries(taut::Run& run, int steps) {
  std::vector<std::int64_t> counts;
  for (int i = 0; i < steps; ++i) {
    const std::int64_t before = run.report().counts.rounds;
    EXPECT_TRUE(run.step());
    counts.push_back(run.report().counts.rounds - before);
  }
  return counts;
}

TEST_F(RunParts, BeginWhereTheLastStepsEndedAndGrowAgain) {
  taut::Run run = begin();
  const std::vector<std::int64_t> whole(4, 1);
  EXPECT_EQ(tries(run, 4), whole);
  // The first one finds the depth; every fourth tries half of it, in vain.
  EXPECT_EQ(tries(run, 8), (std::vector<std::int64_t>{15, 8, 8, 8, 12, 8, 8, 8}));
  EXPECT_EQ(tries(run, 8), (std::vector<std::int64_t>{4, 4, 4, 2, 2, 2, 1, 1}));
  EXPECT_EQ(run.report().counts.halvings, 8 * 7 + 3 * 3 + 3 * 1) << "parts of parts, too";
  EXPECT_EQ(run.report().halved_steps, 8 + 6) << "what was not made whole";
  EXPECT_EQ(run.report().deepest_halving, 3);
  EXPECT_DOUBLE_EQ(run.report().first_halved_at, hard_from);
}

TEST_F(RunParts, GoOnFromASavedState) {
  taut::Run run = begin();
  const std::vector<std::int64_t> all = tries(run, 20);
  for (std::size_t made = 0; made < all.size(); ++made) {
    taut::Run first = begin();
    tries(first, static_cast<int>(made));
    const RunState saved = run_state_from(to_bytes(first.save()), scene_.model);
    taut::Run other(scene_.model, scene_.start, method_, settings_, saved);
    const std::vector<std::int64_t> rest(all.begin() + static_cast<std::ptrdiff_t>(made), all.end());
    EXPECT_EQ(tries(other, static_cast<int>(rest.size())), rest) << "after " << made;
  }
}

TEST_F(RunParts, EndTheRunWhereNoneHolds) {
  RunPolicy twice;
  twice.most_halvings = 2;
  taut::Run run(scene_.model, scene_.start, method_, settings_, twice);
  while (run.step()) {
  }
  EXPECT_DOUBLE_EQ(run.state().time, hard_from) << "nothing of the step that failed is left";
  EXPECT_EQ(run.report().end, RunEnd::step_failed);
}

}  // namespace
}  // namespace taut
