#pragma once

#include <string>

namespace taut {

/// Bytes of physical memory in this machine.
double physical_memory();

/// Bytes of addresses that this process may still take (see `ulimit -v`); infinite where there is no limit.
double room_for_addresses();
/// Bytes of memory that this process may have: those of the machine, or fewer where a limit on the process or
/// on the group it runs in says so.
double usable_memory();
/// Bytes of it that this process doesn't have yet.
double memory_left();

/// A number of bytes for people, such as "3.2 GB".
std::string format_bytes(double bytes);

}  // namespace taut
