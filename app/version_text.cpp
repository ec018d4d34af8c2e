#include "version_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/build_info.h"
#include "host/machine.h"
#include "host/versions.h"
#include "methods/simd.h"

namespace taut {

std::string version_text() {
  const Machine machine = this_machine();
  return fmt::format(
      "{}\n"
      "commit {}, flags {}\n"
      "moves as {}, draws as {}, judges as {}\n"
      "vector instructions: {}\n"
      "OpenGL: {}",
      build_info(), machine.commit, machine.flags, physics_version(), drawing_version(), judging_version(),
      fmt::join(simd_targets(), ", "), TAUT_GL_BACKENDS);
}

}  // namespace taut
