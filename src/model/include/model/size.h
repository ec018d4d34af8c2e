#pragma once

#include "model/description.h"

namespace taut {

/// How much there is, as real numbers so that no count overflows.
struct Counts {
  double masses = 0.0, links = 0.0, triangles = 0.0;
  double knots = 0.0;  ///< of the ways that pins are driven along

  Counts& operator+=(const Counts& other);
};

/// What a description asks for, counted without building it.
Counts count(const Description& description);

/// About how much memory (bytes) so much takes to be built, moved and drawn.
double bytes_needed(const Counts& counts);

/// About how long (s) building so much takes on an ordinary machine.
double seconds_to_build(const Counts& counts);

}  // namespace taut
