#pragma once

#include <string_view>

#include "host/signals.h"

namespace taut {

/// Says on stderr, whatever --quiet asks for, that a signal ended the run and what became of what it made.
/// Returns the exit status.
int report_interrupted(const InterruptWatch& interrupts, std::string_view what_became);

}  // namespace taut
