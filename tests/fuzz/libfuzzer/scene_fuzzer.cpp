#include <cstdint>
#include <cstdlib>
#include <string>

#include "base/failure.h"
#include "scene/scene.h"

namespace {

// True where some number is so large that building the scene would take all the time there is: more than
// three digits in a row, an exponent, or a number in another base.
bool may_be_huge(const std::string& text) {
  int digits = 0;
  for (const char c : text) {
    const bool counts = (c >= '0' && c <= '9') || c == '_';
    digits = counts ? digits + 1 : 0;
    if (digits > 3 || (digits > 0 && (c == 'x' || c == 'e' || c == 'E'))) return true;
  }
  return text.find("0x") != std::string::npos;
}

}  // namespace

// Whatever the bytes: either a scene whose resolved text is a scene again, or a BadRequest with a message.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (may_be_huge(text)) return 0;
  taut::Scene scene;
  try {
    scene = taut::parse_scene(text, "fuzz.toml");
  } catch (const taut::BadRequest& failure) {
    if (std::string(failure.what()).empty()) std::abort();
    return 0;
  }
  const std::string resolved = taut::resolved_toml(scene);
  if (taut::resolved_toml(taut::parse_scene(resolved, "fuzz.toml")) != resolved) std::abort();
  return 0;
}
