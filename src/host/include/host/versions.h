#pragma once

#include <string>

namespace taut {

// What decides a result, as against what made it (build_info.h): a program that was built anew, by another
// compiler or after a change elsewhere, goes on with what another left where these are the same.

/// Hash of the states that the tests hold every method to (tests/golden/state-hashes.txt): it decides what a
/// scene's motion is, bit for bit.
std::string physics_version();

/// Hash of the sources of what draws: it decides what a picture of a state looks like.
std::string drawing_version();

/// Hash of the sources of what judges runs: it decides, with physics_version(), what a case of a chart or a
/// map, a reference and a plan come to.
std::string judging_version();

}  // namespace taut
