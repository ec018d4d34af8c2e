#include "base/memory.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <limits>

namespace taut {

namespace {

struct Taken {
  double addresses = 0.0, memory = 0.0;  // bytes
};

Taken taken() {
  const auto page = static_cast<double>(sysconf(_SC_PAGESIZE));
  double all = 0.0, resident = 0.0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return {all * page, resident * page};
}

}  // namespace

double physical_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double room_for_addresses() {
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return std::numeric_limits<double>::infinity();
  return std::max(0.0, static_cast<double>(limit.rlim_cur) - taken().addresses);
}

double usable_memory() {
  double usable = physical_memory();
  rlimit limit{};
  if (::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY)
    usable = std::min(usable, static_cast<double>(limit.rlim_cur));
  // The word "max" where there is no limit reads as none.
  if (double of_group = 0.0; std::ifstream("/sys/fs/cgroup/memory.max") >> of_group && of_group > 0.0)
    usable = std::min(usable, of_group);
  return usable;
}

double memory_left() {
  return std::min(room_for_addresses(), std::max(0.0, usable_memory() - taken().memory));
}

std::string format_bytes(double bytes) {
  constexpr std::array units{"B", "kB", "MB", "GB", "TB", "PB", "EB"};
  std::size_t unit = 0;
  while (bytes >= 1000.0 && unit + 1 < units.size()) {
    bytes /= 1000.0;
    ++unit;
  }
  return fmt::format("{:.3g} {}", bytes, units[unit]);
}

}  // namespace taut
