// Builds a chain that hangs between two pins, steps it for ten seconds, and prints how it comes to rest.
#include <cstdio>
#include <exception>
#include <string>

#include "model/description.h"
#include "model/measures.h"
#include "motion/run.h"

namespace {

taut::Description rope_between_pins() {
  taut::ChainSpec rope;
  rope.name = "rope";
  rope.from = {0.0, 2.0, 0.0};  // m
  rope.to = {2.0, 2.0, 0.0};
  rope.length = 2.4;  // m
  rope.links = 24;
  rope.mass = 0.5;  // kg
  rope.pinned = {"first", "last"};

  taut::Description scene;
  scene.drag = 1.5;  // 1/s
  scene.chains.push_back(rope);
  return scene;
}

void print_swing() {
  const taut::Built built = taut::build(rope_between_pins());
  for (const taut::Problem& problem : built.problems)
    std::printf("[%s] %s: %s\n", problem.section.c_str(), problem.key.c_str(), problem.message.c_str());
  if (!built.problems.empty()) return;

  const taut::Settings settings{"rattle", {{"steps_per_second", 600.0}}};
  taut::Run run(built.model, built.start, settings);
  for (int second = 1; second <= 10; ++second) {
    const auto state = run.at(second);
    if (!state) break;
    std::printf("%2d s: sag %.6f m, fastest %.6f m/s\n", second, taut::sag(built.model, *state),
                taut::fastest_speed(*state));
  }
  if (run.ended()) std::printf("%s\n", run.failure().c_str());
}

}  // namespace

int main() {
  try {
    print_swing();
    return 0;
  } catch (const std::exception& problem) {  // a method that refuses the run says why
    std::fprintf(stderr, "%s\n", problem.what());
    return 1;
  }
}
