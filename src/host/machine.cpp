#include "host/machine.h"

#include <fstream>
#include <thread>

#include "host/build_info.h"

namespace taut {
namespace {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.find(':') + 2, line.size()));
  return "unknown";
}

}  // namespace

Machine this_machine() {
  return {processor_name(), std::thread::hardware_concurrency(), build_info(), TAUT_FLAGS, TAUT_COMMIT};
}

}  // namespace taut
