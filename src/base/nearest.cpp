#include "base/nearest.h"

#include <algorithm>
#include <vector>

namespace taut {
namespace {

using Row = std::vector<std::size_t>;

// Optimal string alignment distance: Levenshtein with swaps of neighbours, three rows at a time, which are
// kept from word to word.
class EditDistance {
 public:
  std::size_t operator()(std::string_view a, std::string_view b) {
    for (Row* each : {&before_last_, &last_, &row_}) each->assign(b.size() + 1, 0);
    for (std::size_t j = 0; j <= b.size(); ++j) last_[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
      row_[0] = i;
      for (std::size_t j = 1; j <= b.size(); ++j) {
        const std::size_t replace = last_[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
        row_[j] = std::min({replace, last_[j] + 1, row_[j - 1] + 1});
        if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
          row_[j] = std::min(row_[j], before_last_[j - 2] + 1);
      }
      std::swap(before_last_, last_);
      std::swap(last_, row_);
    }
    return last_[b.size()];
  }

 private:
  Row before_last_, last_, row_;
};

}  // namespace

std::string_view nearest_name(std::string_view word, std::span<const std::string_view> candidates) {
  constexpr std::size_t longest_word =
      64;  // longer ones are no typing errors, and the distance costs their product
  if (word.size() > longest_word) return {};
  std::string_view best;
  std::size_t fewest = std::max<std::size_t>(2, word.size() / 3) + 1;
  EditDistance edit_distance;
  for (const std::string_view candidate : candidates) {
    const std::size_t longer = std::max(word.size(), candidate.size()),
                      shorter = std::min(word.size(), candidate.size());
    if (longer - shorter >= fewest) continue;  // so many edits it takes at least
    const std::size_t edits = edit_distance(word, candidate);
    const bool alike = edits < shorter;  // something of the word is left
    if (alike && edits < fewest) {
      fewest = edits;
      best = candidate;
    }
  }
  return best;
}

}  // namespace taut
