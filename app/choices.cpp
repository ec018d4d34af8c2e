#include "choices.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/failure.h"
#include "base/nearest.h"

namespace taut {

void not_one_of(std::string_view flag, std::string_view given, std::span<const std::string_view> names) {
  const std::string_view nearest = nearest_name(given, names);
  throw BadRequest(fmt::format("{} is one of {}, not \"{}\"{}", flag, fmt::join(names, ", "), given,
                               nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest)));
}

std::vector<std::string> as_words(std::span<const std::string_view> names) {
  return {names.begin(), names.end()};
}

}  // namespace taut
