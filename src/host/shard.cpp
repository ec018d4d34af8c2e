#include "host/shard.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <optional>

#include "base/failure.h"

namespace taut {
namespace {

std::optional<std::size_t> whole_number(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<std::size_t> whole_number_in(const char* variable) {
  const char* text = std::getenv(variable);
  return text == nullptr ? std::nullopt : whole_number(text);
}

}  // namespace

std::string Shard::suffix() const {
  return all() ? "" : fmt::format("-{}-of-{}", index, count);
}

Shard parse_shard(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash != std::string_view::npos) {
    const auto index = whole_number(text.substr(0, slash)), count = whole_number(text.substr(slash + 1));
    if (index && count && *index >= 1 && *index <= *count) return {*index, *count};
  }
  throw BadRequest(fmt::format("a shard is i/n with i from 1 to n, such as 2/8, not \"{}\"", text));
}

Shard shard_of_this_task() {
  const auto task = whole_number_in("SLURM_ARRAY_TASK_ID"), count = whole_number_in("SLURM_ARRAY_TASK_COUNT");
  if (!task || !count || *count == 0) return {};
  const std::size_t first = whole_number_in("SLURM_ARRAY_TASK_MIN").value_or(1);
  if (*task < first || *task - first >= *count)
    throw BadRequest(
        fmt::format("SLURM_ARRAY_TASK_ID = {} is not one of SLURM_ARRAY_TASK_COUNT = {} from {} on", *task,
                    *count, first));
  return {*task - first + 1, *count};
}

}  // namespace taut
