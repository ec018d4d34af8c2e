#pragma once

#include <string>
#include <vector>

#include "command_line.h"

namespace taut {

/// A manual page, in the language of man(7).
struct ManPage {
  std::string file;  ///< its name, such as "taut-render.1"
  std::string text;
};

/// The page of the program and one for each of its verbs, from its help.
std::vector<ManPage> man_pages(const ProgramFacts& program, const std::string& version);

}  // namespace taut
