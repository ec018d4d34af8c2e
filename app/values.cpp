#include "values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "base/failure.h"

namespace taut {
namespace {

// A longer name stands before one that it ends with. 0.001 s is no number of the machine, 1000 is.
struct UnitOfTime {
  std::string_view name;
  double seconds = 1.0, parts = 1.0;
};
constexpr std::array<UnitOfTime, 4> units_of_time{
    {{"ms", 1.0, 1000.0}, {"min", 60.0, 1.0}, {"s", 1.0, 1.0}, {"h", 3600.0, 1.0}}};

template <class Number>
std::optional<Number> whole_text_as(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

double parse_number(std::string_view flag, std::string_view text) {
  const auto value = whole_text_as<double>(text);
  if (!value || !std::isfinite(*value))
    throw BadRequest(fmt::format("{} needs a number, not \"{}\"", flag, text));
  return *value;
}

FrameRate parse_frame_rate(std::string_view flag, std::string_view text) {
  constexpr double most = 1000.0;
  const std::optional<FrameRate> rate = frame_rate_from(text);
  if (!rate || rate->value() > most)
    throw BadRequest(fmt::format(
        "{} needs frames per second such as 30, 29.97 or 24000/1001, more than 0 and at most {}, not \"{}\"",
        flag, most, text));
  return *rate;
}

double parse_seconds(std::string_view flag, std::string_view text) {
  const auto unit = std::ranges::find_if(units_of_time, [&](const auto& each) {
    return text.size() > each.name.size() && text.ends_with(each.name);
  });
  const UnitOfTime plain, &used = unit == units_of_time.end() ? plain : *unit;
  const auto value = whole_text_as<double>(text.substr(0, text.size() - used.name.size()));
  const double seconds = value.value_or(0.0) * used.seconds / used.parts;
  if (!value || !std::isfinite(seconds))
    throw BadRequest(fmt::format("{} needs a time such as 2.5, 2.5s, 500ms or 2min, not \"{}\"", flag, text));
  return seconds;
}

Size parse_size(std::string_view flag, std::string_view text) {
  const std::size_t cross = text.find('x');
  const auto width = whole_text_as<int>(text.substr(0, cross));
  const auto height =
      cross == std::string_view::npos ? std::nullopt : whole_text_as<int>(text.substr(cross + 1));
  if (!width || !height)
    throw BadRequest(
        fmt::format("{} needs a width and a height in pixels such as 1280x720, not \"{}\"", flag, text));
  return {*width, *height};
}

}  // namespace taut
