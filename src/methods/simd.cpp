#include "methods/simd.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "base/failure.h"
#include "base/nearest.h"

namespace taut {
namespace {

std::string name_of(std::int64_t target) {
  std::string name = hwy::TargetName(target);
  std::ranges::transform(name, name.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name;
}

}  // namespace

std::vector<std::string> simd_targets() {
  std::vector<std::string> names;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) names.push_back(name_of(target));
  return names;
}

void force_simd(std::string_view name) {
  hwy::SetSupportedTargetsForTest(0);
  if (name.empty()) return;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets())
    if (name_of(target) == name) return hwy::SetSupportedTargetsForTest(target);
  const std::vector<std::string> targets = simd_targets();
  const std::vector<std::string_view> names(targets.begin(), targets.end());
  const std::string_view nearest = nearest_name(name, names);
  throw BadRequest(fmt::format(
      "this processor, or this program, has no vector instructions \"{}\"; there are {}{}", name,
      fmt::join(targets, ", "), nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest)));
}

}  // namespace taut
