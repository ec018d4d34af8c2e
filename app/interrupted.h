#pragma once

#include <functional>
#include <string_view>

#include "base/stop.h"
#include "host/signals.h"

namespace taut {

/// For an InterruptWatch: takes away what is half made, says so on stderr and ends the process.
[[noreturn]] void end_at_once(int signal);

/// True once a signal has come.
StopTest stop_test(const InterruptWatch& interrupts);

/// Says on stderr, whatever --quiet asks for, that a signal ended the run and what became of what it made.
/// Returns the exit status.
int report_interrupted(const InterruptWatch& interrupts, std::string_view what_became);

/// The exit status of `work`; where it throws Interrupted, what report_interrupted() gives.
int unless_interrupted(const InterruptWatch& interrupts, std::string_view what_became,
                       const std::function<int()>& work);

}  // namespace taut
