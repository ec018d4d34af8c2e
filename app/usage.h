#pragma once

#include <string>
#include <vector>

namespace taut {

/// A command line that the parser could make no sense of.
struct Misuse {
  std::string verb;                    ///< that was in use; empty: none
  std::vector<std::string> verbs;      ///< that there are
  std::vector<std::string> left_over;  ///< words that nothing took
  std::vector<std::string> flags;      ///< of the verb in use, with their dashes
  std::string complaint;               ///< the parser's
};

/// What is wrong with it, as a sentence: an unknown verb or flag with the nearest one there is, or what the
/// parser says; and which help to look at.
std::string usage_problem(const Misuse& misuse);

}  // namespace taut
