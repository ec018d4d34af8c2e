#pragma once

#include <map>
#include <string>
#include <vector>

namespace taut {

/// A command line that the parser could make no sense of.
struct Misuse {
  std::string verb;                                       ///< that was in use; empty: none
  std::map<std::string, std::vector<std::string>> flags;  ///< of each verb there is, with their dashes
  std::vector<std::string> left_over;                     ///< words that nothing took
  std::vector<std::string> arguments;                     ///< words that were taken for what no flag names
  std::string complaint;                                  ///< the parser's
};

/// What is wrong with it, as a sentence: an unknown verb or flag with the nearest one there is or the verbs
/// that have it, a change without a --set of its own, or what the parser says; and which help to look at.
std::string usage_problem(const Misuse& misuse);

/// A complaint, and which help to look at; no verb: the program's own.
std::string with_help(const std::string& complaint, const std::string& verb);

/// What to write in place of a word that stands where --set would have to be repeated.
std::string set_hint(const std::string& change);

}  // namespace taut
