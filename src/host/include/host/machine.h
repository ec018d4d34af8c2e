#pragma once

#include <string>

namespace taut {

/// What a time was measured on and with.
struct Machine {
  std::string processor;  ///< as the system names it
  unsigned threads = 1;   ///< that can run at once
  std::string build;      ///< as build_info() says: version, compiler, kind of build, identifier
  std::string flags;      ///< of the compiler
  std::string commit;     ///< of the source; "unknown" where it was not built from a repository
};
Machine this_machine();

}  // namespace taut
