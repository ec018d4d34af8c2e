#pragma once

#include <string>

namespace taut {

/// Version, compiler, kind of build, and an identifier that differs between any two different builds.
std::string build_info();

/// The version, such as "0.1.0".
std::string version();

}  // namespace taut
