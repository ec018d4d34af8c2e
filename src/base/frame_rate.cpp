#include "base/frame_rate.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace taut {
namespace {

constexpr std::size_t most_digits = 9;           // behind the point
constexpr std::int64_t largest = 1'000'000'000;  // so that what has all of them reads back as a fraction

std::optional<std::int64_t> whole_number(std::string_view digits) {
  if (digits.empty() || digits.size() > most_digits + 1) return std::nullopt;
  std::int64_t number = 0;
  for (const char digit : digits) {
    if (digit < '0' || digit > '9') return std::nullopt;
    number = 10 * number + (digit - '0');
  }
  return number <= largest ? std::optional(number) : std::nullopt;
}

std::optional<FrameRate> in_lowest_terms(std::optional<std::int64_t> frames,
                                         std::optional<std::int64_t> seconds) {
  if (!frames || !seconds || *frames == 0 || *seconds == 0) return std::nullopt;
  const std::int64_t common = std::gcd(*frames, *seconds);
  return FrameRate{*frames / common, *seconds / common};
}

}  // namespace

std::string FrameRate::text() const {
  return seconds == 1 ? fmt::format("{}", frames) : fmt::format("{}/{}", frames, seconds);
}

std::optional<FrameRate> frame_rate_from(std::string_view text) {
  if (const std::size_t slash = text.find('/'); slash != std::string_view::npos)
    return in_lowest_terms(whole_number(text.substr(0, slash)), whole_number(text.substr(slash + 1)));
  const std::size_t point = std::min(text.find('.'), text.size());
  const std::string_view after = text.substr(std::min(point + 1, text.size()));
  if (point < text.size() && after.empty()) return std::nullopt;
  std::int64_t seconds = 1;
  for (std::size_t i = 0; i < std::min(after.size(), most_digits); ++i) seconds *= 10;
  return in_lowest_terms(whole_number(std::string(text.substr(0, point)) + std::string(after)), seconds);
}

}  // namespace taut
