#include "interrupted.h"

#include <fmt/format.h>

#include <cstdio>

#include "exit_status.h"

namespace taut {

StopTest stop_test(const InterruptWatch& interrupts) {
  return [&interrupts] { return interrupts.caught() != 0; };
}

int report_interrupted(const InterruptWatch& interrupts, std::string_view what_became) {
  fmt::print(stderr, "taut: interrupted; {}\n", what_became);
  return exit_signal + interrupts.caught();
}

int unless_interrupted(const InterruptWatch& interrupts, std::string_view what_became,
                       const std::function<int()>& work) {
  try {
    return work();
  } catch (const Interrupted&) {
    return report_interrupted(interrupts, what_became);
  }
}

}  // namespace taut
