#include <cstdint>
#include <functional>

#include "scene_target.h"

// To make an OpenGL context takes a hundred times as long as all the rest, so only one text in so many is
// drawn, always the same ones.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t one_in = 32;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const bool drawn = std::hash<std::string>()(text) % one_in == 0;
  taut::testing::try_scene(text, drawn ? taut::testing::Depth::picture : taut::testing::Depth::geometry);
  return 0;
}
