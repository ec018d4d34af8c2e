#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include "temporary_folder.h"

namespace taut::testing {

/// Writes a shell script that can be run under that name, and gives its path.
inline std::string write_program(const TemporaryFolder& folder, const std::string& name,
                                 const std::string& script) {
  std::string file = folder.write(name, "#!/bin/sh\n" + script + "\n");
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  return file;
}

/// While it lives, programs of a folder are found before others.
class FirstOnThePath {
 public:
  explicit FirstOnThePath(const TemporaryFolder& folder) {
    ::setenv("PATH", (folder.path().string() + ":" + before_).c_str(), 1);
  }
  ~FirstOnThePath() { ::setenv("PATH", before_.c_str(), 1); }
  FirstOnThePath(const FirstOnThePath&) = delete;
  FirstOnThePath& operator=(const FirstOnThePath&) = delete;

 private:
  std::string before_ = std::getenv("PATH");
};

}  // namespace taut::testing
