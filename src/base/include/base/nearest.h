#pragma once

#include <span>
#include <string>
#include <string_view>

namespace taut {

/// The candidate that is the fewest edits (insert, delete, replace, swap of neighbours) away from `word`;
/// empty when none is near enough to be meant (more than a third of the word's length, at least 2, edits
/// away, or as many as the shorter of the two has letters).
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> candidates);

}  // namespace taut
