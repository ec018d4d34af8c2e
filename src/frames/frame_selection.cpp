#include "frames/frame_selection.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>

#include "base/failure.h"

namespace taut {
namespace {

constexpr int most_frames = 999'999;  // six digits in a frame's name

struct Range {
  int first = 0, last = 0, stride = 1;
};

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 1) return std::nullopt;
  return value;
}

// "5", "5-9" or "5-9:2".
std::optional<Range> parse_range(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view ends = text.substr(0, colon);
  const std::size_t dash = ends.find('-');
  const auto first = whole_number(ends.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : whole_number(ends.substr(dash + 1));
  const auto stride =
      colon == std::string_view::npos ? std::optional(1) : whole_number(text.substr(colon + 1));
  if (!first || !last || !stride || *last < *first) return std::nullopt;
  return Range{*first, *last, *stride};
}

}  // namespace

int frame_count(double duration, const FrameRate& rate) {
  // The slack keeps 0.1 s at 30 frames/s, a little less than 3 in binary, at 3.
  const double count = std::floor(duration * rate.value() + 1e-6);
  if (!(count >= 1.0))
    throw BadRequest(fmt::format("{} s at {} frames/s is not even one frame", duration, rate.text()));
  if (count > most_frames)
    throw BadRequest(fmt::format("{} s at {} frames/s are {:.0f} frames; at most {} have room in a folder",
                                 duration, rate.text(), count, most_frames));
  return static_cast<int>(count);
}

double frame_time(int frame, const FrameRate& rate) {
  return static_cast<double>((frame - 1) * rate.seconds) / static_cast<double>(rate.frames);
}

std::vector<int> select_frames(std::string_view text, int count) {
  std::set<int> chosen;
  std::string_view rest = text;
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    const std::optional<Range> range = parse_range(rest.substr(0, comma));
    if (!range)
      throw BadRequest(fmt::format(
          "\"{}\" chooses no frames; write them as 7 or 1-100 or 1-100:2, with commas between", text));
    if (range->last > count)
      throw BadRequest(fmt::format("there is no frame {}: frames go from 1 to {}", range->last, count));
    for (int frame = range->first; frame <= range->last; frame += range->stride) {
      chosen.insert(frame);
      if (range->stride > count) break;  // or the sum could leave the range of int
    }
    more = comma != std::string_view::npos;
    if (more) rest.remove_prefix(comma + 1);
  }
  return {chosen.begin(), chosen.end()};
}

std::vector<int> all_frames(int count) {
  std::vector<int> frames(static_cast<std::size_t>(count));
  std::iota(frames.begin(), frames.end(), 1);
  return frames;
}

FrameRate rate_of_selection(const std::vector<int>& frames, const FrameRate& rate) {
  std::int64_t least = 0;
  for (std::size_t i = 0; i + 1 < frames.size(); ++i) {
    const std::int64_t step = frames[i + 1] - frames[i];
    least = least == 0 ? step : std::min(least, step);
  }
  if (least <= 1) return rate;
  const std::int64_t seconds = rate.seconds * least, common = std::gcd(rate.frames, seconds);
  return {rate.frames / common, seconds / common};
}

std::string selection_text(const std::vector<int>& frames) {
  std::string text;
  for (std::size_t i = 0; i < frames.size();) {
    std::size_t last = i;
    while (last + 1 < frames.size() && frames[last + 1] == frames[last] + 1) ++last;
    if (!text.empty()) text += ',';
    text += last == i ? fmt::format("{}", frames[i]) : fmt::format("{}-{}", frames[i], frames[last]);
    i = last + 1;
  }
  return text;
}

}  // namespace taut
