#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace taut {

/// How many frames a film has in how many seconds: as a fraction in lowest terms, so that rates such as
/// television's 30000/1001 are exact.
struct FrameRate {
  std::int64_t frames = 30, seconds = 1;

  /// Frames a second.
  double value() const { return static_cast<double>(frames) / static_cast<double>(seconds); }
  /// As a whole number or a fraction: "30", "24000/1001".
  std::string text() const;
};

/// The rate that a text says: "30", "29.97" or "24000/1001". Nothing for any other text, for 0, and for
/// numbers of more than nine digits.
std::optional<FrameRate> frame_rate_from(std::string_view text);

}  // namespace taut
