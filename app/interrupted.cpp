#include "interrupted.h"

#include <fmt/format.h>

#include <cstdio>

#include "exit_status.h"

namespace taut {

int report_interrupted(const InterruptWatch& interrupts, std::string_view what_became) {
  fmt::print(stderr, "taut: interrupted; {}\n", what_became);
  return exit_signal + interrupts.caught();
}

}  // namespace taut
