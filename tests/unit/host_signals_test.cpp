#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>

#include "host/signals.h"

namespace taut {
namespace {

constexpr int ended_at_once = 7;

// Says which signal it was and ends the process, as a program does that takes away what is half made.
void say_and_end(int signal) {
  fmt::print(stderr, "by {}\n", signal);
  ::_exit(ended_at_once);
}

// Work that never asks whether it should end, a step that takes a minute for example.
void work_that_never_asks(int signal) {
  const InterruptWatch watch(say_and_end);
  std::raise(signal);
  while (true) ::sleep(60);
}

// Work that asks at once, and needs no help to end.
void work_that_asks(int signal) {
  {
    const InterruptWatch watch(say_and_end);
    std::raise(signal);
    if (watch.caught() != signal) ::_exit(EXIT_FAILURE);
  }
  ::sleep(1);
  ::_exit(EXIT_SUCCESS);
}

TEST(InterruptWatchDeathTest, EndsWhatNeverAsks) {
  for (const int signal : {SIGINT, SIGTERM})
    EXPECT_EXIT(work_that_never_asks(signal), ::testing::ExitedWithCode(ended_at_once),
                fmt::format("by {}", signal));
}

TEST(InterruptWatchDeathTest, LeavesWhatEndsByItselfAlone) {
  EXPECT_EXIT(work_that_asks(SIGTERM), ::testing::ExitedWithCode(EXIT_SUCCESS), "^$");
}

void work_that_gets_two(int signal) {
  const InterruptWatch watch(say_and_end);
  std::raise(signal);
  std::raise(signal);
  while (true) ::sleep(60);
}

TEST(InterruptWatchDeathTest, IsTheSystemsAgainAtTheSecondSignal) {
  EXPECT_EXIT(work_that_gets_two(SIGTERM), ::testing::KilledBySignal(SIGTERM), "^$");
}

}  // namespace
}  // namespace taut
