#pragma once

#include <string>

namespace taut {

/// Bytes of physical memory in this machine.
double physical_memory();

/// A number of bytes for people, such as "3.2 GB".
std::string format_bytes(double bytes);

}  // namespace taut
