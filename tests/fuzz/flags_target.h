#pragma once

#include <string>

namespace taut::testing {

/// Reads a text as what its first character says: a flag's number, time, size, frame rate, accuracy, a
/// selection of frames, a shard, or a --set of a small scene. What is refused is refused by a message;
/// anything else that goes wrong ends the process.
void try_flag(const std::string& text);

}  // namespace taut::testing
