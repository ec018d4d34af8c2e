#include <cstdint>

#include "flags_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  taut::testing::try_flag(std::string(reinterpret_cast<const char*>(data), size));
  return 0;
}
