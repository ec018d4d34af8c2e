#pragma once

#include <string>

namespace taut {

/// What this program is, in lines: build_info(), the source and the compiler's flags, what decides results
/// (host/versions.h), the vector instructions of this processor that it uses, best first, and what it can
/// draw with.
std::string version_text();

}  // namespace taut
