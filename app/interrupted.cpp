#include "interrupted.h"

#include <fmt/format.h>

#include "base/abrupt_end.h"
#include "exit_status.h"
#include "host/standard_streams.h"

namespace taut {

void end_at_once(int signal) {
  tell("taut: interrupted in the middle of a step that takes long; what was whole is kept\n");
  end_abruptly(exit_signal + signal);
}

StopTest stop_test(const InterruptWatch& interrupts) {
  return [&interrupts] { return interrupts.caught() != 0; };
}

int report_interrupted(const InterruptWatch& interrupts, std::string_view what_became) {
  tell("taut: interrupted; {}\n", what_became);
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
