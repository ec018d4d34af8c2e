#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/failure.h"
#include "methods/registry.h"
#include "model/description.h"
#include "motion/simulate.h"

// A run by a method that the registry doesn't have.

namespace taut {
namespace {

Built hanging_rope(std::optional<double> stiffness = {}) {
  ChainSpec rope;
  rope.name = "rope";
  rope.to = {1.0, 0.0, 0.0};
  rope.links = 6;
  rope.pinned = {"first"};
  rope.properties.stiffness = stiffness;
  Description description;
  description.chains.push_back(rope);
  return build(description);
}

// What a run says when it is refused; empty when it isn't.
std::string refusal_of(const Built& scene, const Method& method, const Settings& settings) {
  try {
    const taut::Run run(scene.model, scene.start, method, settings);
    return {};
  } catch (const BadRequest& refused) {
    return refused.what();
  }
}

class MethodAtHand : public ::testing::Test {
 protected:
  MethodAtHand() { mine_.name = "mine"; }

  Method mine_ = *find_method("rattle");
  Settings settings_{"", {{"steps_per_second", 500.0}}};
};

TEST_F(MethodAtHand, MovesAsTheOneThatItIsACopyOf) {
  ASSERT_EQ(find_method("mine"), nullptr);
  const Built scene = hanging_rope();
  const Settings known{"rattle", settings_.values};
  taut::Run mine(scene.model, scene.start, mine_, settings_), registered(scene.model, scene.start, known);
  EXPECT_EQ(mine.settings().method, "mine");
  EXPECT_EQ(mine.settings().values, registered.settings().values) << "defaults are filled in";
  const SampledRun a = sampled_run(std::move(mine), {0.1, 0.5, 1.0});
  const SampledRun b = sampled_run(std::move(registered), {0.1, 0.5, 1.0});
  ASSERT_EQ(a.states.size(), 3U);
  for (std::size_t i = 0; i < a.states.size(); ++i)
    EXPECT_EQ(state_hash(a.states[i]), state_hash(b.states[i])) << i;
}

TEST_F(MethodAtHand, GoesOnFromASavedState) {
  const Built scene = hanging_rope();
  taut::Run run(scene.model, scene.start, mine_, settings_);
  for (int i = 0; i < 50; ++i) run.step();
  taut::Run other(scene.model, scene.start, mine_, settings_, run.save());
  EXPECT_EQ(state_hash(run.at(0.3).value()), state_hash(other.at(0.3).value()));
}

TEST_F(MethodAtHand, SaysByItsNameWhatItIsNotToldRight) {
  const Built scene = hanging_rope();
  settings_.values["pases"] = 2.0;
  EXPECT_EQ(refusal_of(scene, mine_, settings_).rfind("method \"mine\" has no parameter \"pases\"", 0), 0U);
  settings_.values = {{"steps_per_second", -1.0}};
  EXPECT_NE(refusal_of(scene, mine_, settings_).find("steps_per_second must be from"), std::string::npos);
}

TEST_F(MethodAtHand, RefusesWhatItCannotDo) {
  mine_.can.stiffness = false;
  EXPECT_EQ(refusal_of(hanging_rope(), mine_, settings_), "");
  const std::string refusal = refusal_of(hanging_rope(100.0), mine_, settings_);
  EXPECT_EQ(refusal.rfind("method \"mine\" has no links with stiffness; these have: ", 0), 0U) << refusal;
  mine_.refusal = [](const Model&, const State&, const Settings&) { return std::string("not today"); };
  EXPECT_EQ(refusal_of(hanging_rope(), mine_, settings_), "not today");
}

TEST_F(MethodAtHand, NamesItselfWhereItFails) {
  const Built scene = hanging_rope();
  mine_.make = [](const Model&, const Settings&, const Execution&) -> std::unique_ptr<Stepper> {
    class Failing final : public Stepper {
     public:
      void load(const State& state) override { state_ = state; }
      StepReport step(double, double) override {
        StepReport report;
        report.status = StepStatus::not_finite;
        return report;
      }
      void undo() override {}
      const State& store() override { return state_; }

     private:
      State state_;
    };
    return std::make_unique<Failing>();
  };
  taut::Run run(scene.model, scene.start, mine_, settings_);
  EXPECT_FALSE(run.step());
  EXPECT_NE(run.failure().find("with method mine"), std::string::npos) << run.failure();
}

}  // namespace
}  // namespace taut
