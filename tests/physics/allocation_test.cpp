// A step allocates nothing, but for the first few: they make the room that the later ones work in. What
// Eigen's factorisations and small matrices take is not seen here (they call malloc). spring-implicit, which
// puts its matrix together anew each round, is left out.

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "fixtures.h"
#include "methods/registry.h"
#include "motion/run.h"
#include "sanitized.h"
#include "scenes_of_the_program.h"

#ifndef TAUT_SANITIZED  // sanitizers have operators of their own

namespace {

std::atomic<bool> counting{false};
std::atomic<int> allocations{0};

void* allocated(std::size_t size, std::size_t alignment) {
  if (counting.load()) ++allocations;
  void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

// Not inlined: g++ 12 takes the pair of new here and free there for a mistake.
[[gnu::noinline]] void* operator new(std::size_t size) {
  return allocated(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocated(size, static_cast<std::size_t>(alignment));
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace taut::test {
namespace {

class Allocation : public ::testing::TestWithParam<std::string> {};

// Every method as it is unless told otherwise, and xpbd with lines.
std::vector<Settings> ways() {
  std::vector<Settings> all{complete_settings({"xpbd", {{"relax", std::string("lines")}}})};
  for (const Method& method : all_methods()) all.push_back(complete_settings({std::string(method.name), {}}));
  return all;
}

TEST_P(Allocation, NoStepAfterTheFirstFew) {
  const Scene scene = scene_called(GetParam());
  for (const Settings& settings : ways()) {
    const Method& method = *find_method(settings.method);
    // Which stops are held changes from step to step, and what holds them with it; and the work of pins and
    // loads in long steps is summed over states between their ends.
    const bool looks_between =
        !scene.model.limits.empty() || !scene.model.loads.empty() || !scene.model.driven_pins.empty();
    if (method.can.chooses_steps && looks_between) continue;
    if (method.name == "spring-implicit" || !refusals(scene.model, scene.start, settings).empty()) continue;
    taut::Run run(scene.model, scene.start, settings, {}, {std::make_shared<Workers>(2)});
    for (int step = 0; step < 5; ++step) run.step();
    allocations = 0;
    counting = true;
    for (int step = 0; step < 10; ++step) run.step();
    counting = false;
    EXPECT_FALSE(run.ended()) << run.failure();
    EXPECT_EQ(allocations, 0) << method.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Allocation,
                         ::testing::Values("chain-20", "heavy-tip", "loaded-net", "curtain", "ragdoll-hang",
                                           "chain-on-ground", "flag", "net-catch"),
                         case_name);

}  // namespace
}  // namespace taut::test

#endif
