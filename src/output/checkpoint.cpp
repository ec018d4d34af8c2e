#include "output/checkpoint.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "base/bytes.h"
#include "base/failure.h"
#include "base/hash.h"
#include "output/atomic_file.h"
#include "output/content_hash.h"

namespace taut {
namespace {

constexpr std::string_view checkpoint_begins_with = "taut checkpoint 2\n";
constexpr double least_seconds_between = 0.5, most_of_the_run = 1.0 / 150.0;

std::string checkpoint_hash(std::string_view inputs, const Checkpoint& checkpoint, std::string_view metrics) {
  return Hash()
      .add(inputs)
      .add(fmt::format(" {} ", checkpoint.frame))
      .add(checkpoint.state)
      .add(metrics)
      .hex();
}

}  // namespace

void write_checkpoint(const std::filesystem::path& file, std::string_view inputs,
                      const Checkpoint& checkpoint, std::string_view metrics) {
  // Hash, inputs, frame, state and metrics, each list with its length; the state of a large scene not copied.
  std::string before(checkpoint_begins_with), behind;
  append_bytes(checkpoint_hash(inputs, checkpoint, metrics), before);
  append_bytes(inputs, before);
  append_bytes(checkpoint.frame, before);
  append_bytes(static_cast<std::uint64_t>(checkpoint.state.size()), before);
  append_bytes(metrics, behind);
  PendingFile pending(file);
  for (const std::string_view part :
       {std::string_view(before), std::string_view(checkpoint.state), std::string_view(behind)})
    pending.write(std::as_bytes(std::span(part)));
  pending.commit();
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  sync_files(std::array{file, folder});
}

std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& file, std::string_view inputs) {
  const std::optional<std::string> bytes = bytes_of_file(file);
  if (!bytes || !bytes->starts_with(checkpoint_begins_with)) return std::nullopt;
  std::string hash, made_from;
  Checkpoint checkpoint;
  try {
    ByteReader reader(std::string_view(*bytes).substr(checkpoint_begins_with.size()));
    reader.take(hash);
    reader.take(made_from);
    reader.take(checkpoint.frame);
    reader.take(checkpoint.state);
    reader.take(checkpoint.metrics);
  } catch (const BadRequest&) {
    return std::nullopt;
  }
  if (hash != checkpoint_hash(made_from, checkpoint, checkpoint.metrics)) return std::nullopt;
  if (made_from != inputs)
    throw OutputConflict(
        fmt::format("{} is the checkpoint of a run of another scene, method or settings; "
                    "--overwrite replaces it, -o chooses another folder",
                    file.string()));
  return checkpoint;
}

void sync_files(std::span<const std::filesystem::path> files) {
  for (const std::filesystem::path& file : files) {
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    const bool synced = descriptor >= 0 && ::fsync(descriptor) == 0;
    const int error = errno;
    if (descriptor >= 0) ::close(descriptor);
    // Some file systems know no such thing, of folders above all.
    if (!synced && error != EINVAL && error != EROFS)
      throw RunFailure(
          fmt::format("can't write {}: {}", file.string(), std::generic_category().message(error)));
  }
}

bool CheckpointClock::due() const {
  const double passed = std::chrono::duration<double>(Clock::now() - last_.load()).count();
  return passed >= std::max(least_seconds_between, cost_.load() / most_of_the_run);
}

void CheckpointClock::begun(double seconds) {
  cost_ = seconds;
  last_ = Clock::now();
}

void CheckpointClock::written(double seconds) {
  cost_ = cost_.load() + seconds;
  last_ = Clock::now();
}

}  // namespace taut
