#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace taut {

/// Which part of a list of cases a program is to do: number `index` of `count`, from 1.
struct Shard {
  std::size_t index = 1, count = 1;

  bool all() const { return count == 1; }
  /// What tells its files from those of others: "-2-of-4"; nothing where there is only one.
  std::string suffix() const;
  /// Whether the case at that place, from 0, belongs to this part.
  bool has(std::size_t place) const { return place % count == index - 1; }
  /// The first of its places and the one after its last, where so many are dealt out in one piece each.
  std::pair<std::size_t, std::size_t> piece(std::size_t places) const {
    return {places * (index - 1) / count, places * index / count};
  }
};

/// The part that a text such as "2/8" means. Throws BadRequest when it is not of that form.
Shard parse_shard(std::string_view text);

/// The part that SLURM_ARRAY_TASK_ID, SLURM_ARRAY_TASK_MIN (else 1) and SLURM_ARRAY_TASK_COUNT say; all where
/// they are not set.
Shard shard_of_this_task();

}  // namespace taut
