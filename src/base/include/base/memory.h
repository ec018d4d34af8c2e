#pragma once

#include <string>

namespace taut {

/// Bytes of physical memory in this machine.
double physical_memory();

/// Bytes of addresses that this process may still take (see `ulimit -v`); infinite where there is no limit.
double room_for_addresses();

/// A number of bytes for people, such as "3.2 GB".
std::string format_bytes(double bytes);

}  // namespace taut
