// A run that was saved and gone on with is the run that was not, through whatever happens in it.

#include <fmt/format.h>

#include "base/failure.h"
#include "fixtures.h"
#include "model/measures.h"
#include "motion/run.h"
#include "other_process.h"

namespace taut::test {
namespace {

std::string hash_of(const Run& run) {
  return fmt::format("{:016x} {} steps, {} broken, {} halved", state_hash(run.state()), run.steps(),
                     broken_links(run.state()), run.report().halved_steps);
}

void make_steps(Run& run, std::int64_t until) {
  while (run.steps() < until && run.step()) {
  }
}

// Saves after every so many steps, and lets another process go on from there to the end.
taut::Run expect_resumable(const Built& built, const Settings& how, std::int64_t steps, std::int64_t every) {
  taut::Run run(built.model, built.start, how);
  std::vector<std::string> saved;
  while (run.steps() < steps && !run.ended()) {
    make_steps(run, std::min(steps, run.steps() + every));
    saved.push_back(to_bytes(run.save()));
  }
  for (const std::string& bytes : saved)
    EXPECT_EQ(in_other_process([&] {
                taut::Run resumed(built.model, built.start, how, run_state_from(bytes, built.model));
                make_steps(resumed, steps);
                return hash_of(resumed);
              }),
              hash_of(run))
        << how.method;
  return run;
}

// A net that a growing load tears link by link.
TEST(Resume, ThroughBreaks) {
  Description description;
  SheetSpec net;
  net.name = "net";
  net.rows = 6;
  net.columns = 6;
  net.to = {0.5, 0.0, 0.0};
  net.down = {0.0, -0.5, 0.0};
  net.mass = 0.5;
  net.pinned = {"top"};
  net.properties.break_tension = 4.0;
  description.sheets = {net};
  description.drag = 0.5;
  description.loads = {LoadSpec{{"net.5.*"}, {0.3, -6.0, 0.0}, 0.0, 0.5}};
  for (const Method& method : all_methods()) {
    if (!method.can.break_tension) continue;
    Description variant = description;
    if (!method.can.rigid) variant.sheets[0].properties.stiffness = 2000.0;
    const Built built = build_valid(variant);
    const taut::Run run = expect_resumable(built, settings(std::string(method.name), 1920.0), 960, 96);
    EXPECT_GT(broken_links(run.state()), 3U) << method.name;
  }
  Settings lines = settings("xpbd", 1920.0);
  lines.values["relax"] = std::string("lines");
  EXPECT_GT(broken_links(expect_resumable(build_valid(description), lines, 960, 96).state()), 3U);
}

TEST(Resume, ThroughHalvings) {
  Description description = level_chain(40, 1.0 / 40.0);
  description.chains[0].last_mass = 50.0;
  const taut::Run run = expect_resumable(build_valid(description), settings("newton", 60.0), 60, 7);
  EXPECT_GT(run.report().halved_steps, 0);
}

TEST(Resume, OfAnotherSceneOrOfNothingIsRefused) {
  const Built chain = build_valid(level_chain(3, 0.1)), longer = build_valid(level_chain(4, 0.1));
  const std::string bytes = to_bytes(taut::Run(chain.model, chain.start, settings("xpbd", 60.0)).save());
  EXPECT_THROW(run_state_from(bytes, longer.model), BadRequest);
  EXPECT_THROW(run_state_from("hello", chain.model), BadRequest);
  for (std::size_t size = 0; size < bytes.size(); size += 7)
    EXPECT_THROW(run_state_from(std::string_view(bytes).substr(0, size), chain.model), BadRequest) << size;
}

}  // namespace
}  // namespace taut::test
