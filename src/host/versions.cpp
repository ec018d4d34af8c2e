#include "host/versions.h"

#include "versions_of_this_build.h"

namespace taut {

std::string physics_version() {
  return versions_of_this_build.physics;
}

std::string drawing_version() {
  return versions_of_this_build.drawing;
}

std::string judging_version() {
  return versions_of_this_build.judging;
}

}  // namespace taut
