#pragma once

#include <string>
#include <string_view>

#include "base/frame_rate.h"
#include "base/image.h"

namespace taut {

// Values of flags. Each throws BadRequest that names the flag when the text is not such a value.

/// A finite number, such as 29.97.
double parse_number(std::string_view flag, std::string_view text);

/// Frames a second: 30, 29.97 or 24000/1001; above 0 and at most 1000.
FrameRate parse_frame_rate(std::string_view flag, std::string_view text);

/// A time in seconds: 1, 2.5s, 500ms, 2min, 1h.
double parse_seconds(std::string_view flag, std::string_view text);

/// A size in pixels: 1280x720.
Size parse_size(std::string_view flag, std::string_view text);

}  // namespace taut
