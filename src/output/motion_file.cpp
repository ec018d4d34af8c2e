#include "output/motion_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "base/failure.h"
#include "base/hash.h"
#include "output/file_lock.h"
#include "output/packed.h"

namespace taut {
namespace {

constexpr std::string_view motion_begins_with = "taut motion 1\n";
constexpr std::size_t length_of_inputs = 16;
constexpr std::uint64_t record_mark = 0x3164726f63657274;  // "trecord1"

// What stands before the bytes of a moment.
struct RecordHead {
  std::uint64_t mark = record_mark;
  std::int64_t frame = 0;
  double time = 0.0;
  std::uint64_t state_hash = 0, content = 0, size = 0, packed_size = 0;
};
static_assert(sizeof(RecordHead) == 56, "no padding: it is written as it lies in memory");

[[noreturn]] void motion_file_fails(const std::filesystem::path& file, std::string_view verb, int error) {
  throw RunFailure(
      fmt::format("can't {} {}: {}", verb, file.string(), std::generic_category().message(error)));
}

// False where the file ends before.
bool read_at(int descriptor, std::uint64_t offset, void* to, std::size_t size) {
  auto* bytes = static_cast<char*>(to);
  while (size > 0) {
    const ssize_t count = ::pread(descriptor, bytes, size, static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes += count;
    offset += static_cast<std::uint64_t>(count);
    size -= static_cast<std::size_t>(count);
  }
  return true;
}

std::uint64_t size_of(int descriptor) {
  struct stat facts {};
  return ::fstat(descriptor, &facts) == 0 ? static_cast<std::uint64_t>(facts.st_size) : 0;
}

std::optional<std::string> read_header(int descriptor) {
  std::string header(motion_begins_with.size() + length_of_inputs + 1, '\0');
  if (!read_at(descriptor, 0, header.data(), header.size()) || !header.starts_with(motion_begins_with))
    return std::nullopt;
  return header;
}

std::string packed_bytes(int descriptor, const MotionRecord& record) {
  std::string bytes(record.packed_size, '\0');
  if (!read_at(descriptor, record.offset, bytes.data(), bytes.size())) return {};
  return bytes;
}

bool is_whole(int descriptor, const MotionRecord& record) {
  return Hash().add(packed_bytes(descriptor, record)).value() == record.content;
}

// Every record from an offset on, as far as they are whole; gives where they end.
template <class Accept>
std::uint64_t scan(int descriptor, std::uint64_t offset, std::map<int, MotionRecord>& records,
                   const Accept& accept) {
  const std::uint64_t end = size_of(descriptor);
  RecordHead head;
  while (read_at(descriptor, offset, &head, sizeof head) && head.mark == record_mark) {
    const std::uint64_t begin = offset + sizeof head;
    if (head.packed_size > end - begin) break;
    const MotionRecord record{head.time, head.state_hash, head.content, begin, head.packed_size, head.size};
    if (!accept(record)) break;
    records[static_cast<int>(head.frame)] = record;
    offset = begin + head.packed_size;
  }
  return offset;
}

}  // namespace

MotionWriter::MotionWriter(std::filesystem::path file, std::string_view inputs, bool overwrite)
    : file_(std::move(file)) {
  constexpr mode_t everyone_as_umask_allows = 0666;
  descriptor_ = ::open(file_.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, everyone_as_umask_allows);
  if (descriptor_ < 0) motion_file_fails(file_, "write", errno);
  try {
    open(fmt::format("{}{}\n", motion_begins_with, inputs), overwrite);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

MotionWriter::~MotionWriter() {
  ::close(descriptor_);
}

void MotionWriter::open(std::string_view header, bool overwrite) {
  if (!lock_file(descriptor_, LockWait::a_while)) {
    if (errno != EWOULDBLOCK) motion_file_fails(file_, "lock", errno);
    throw RunFailure(fmt::format("another taut is working on {}", file_.string()));
  }
  const std::uint64_t size = size_of(descriptor_);
  std::string there(std::min<std::uint64_t>(size, header.size()), '\0');
  read_at(descriptor_, 0, there.data(), there.size());
  // A beginning that was being written is as good as none.
  if (!overwrite && there == header) {
    end_ = scan(descriptor_, header.size(), records_,
                [this](const MotionRecord& record) { return is_whole(descriptor_, record); });
  } else if (!overwrite && !header.starts_with(there)) {
    throw OutputConflict(fmt::format(
        "{} {}; --overwrite replaces it, -o chooses another folder", file_.string(),
        there.starts_with(motion_begins_with) ? "holds the motion of another scene, method or settings"
                                              : "is no file of motion"));
  }
  if (::ftruncate(descriptor_, static_cast<off_t>(end_)) != 0) motion_file_fails(file_, "write", errno);
  if (end_ > 0) return;
  const ssize_t written = ::pwrite(descriptor_, header.data(), header.size(), 0);
  if (written != static_cast<ssize_t>(header.size())) motion_file_fails(file_, "write", errno);
  end_ = header.size();
}

void MotionWriter::add(int frame, const RunState& moment) {
  const std::string bytes = to_bytes(moment);
  const std::string small = packed(bytes);
  RecordHead head;
  head.frame = frame;
  head.time = moment.state.time;
  head.state_hash = state_hash(moment.state);
  head.content = Hash().add(small).value();
  head.size = bytes.size();
  head.packed_size = small.size();
  std::string record(sizeof head, '\0');
  std::memcpy(record.data(), &head, sizeof head);
  record += small;
  std::uint64_t at = end_;
  for (std::string_view left = record; !left.empty();) {
    const ssize_t written = ::pwrite(descriptor_, left.data(), left.size(), static_cast<off_t>(at));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) motion_file_fails(file_, "write", errno);
    left.remove_prefix(static_cast<std::size_t>(written));
    at += static_cast<std::uint64_t>(written);
  }
  records_[frame] = {head.time,          head.state_hash,  head.content,
                     end_ + sizeof head, head.packed_size, head.size};
  end_ = at;
}

void MotionWriter::sync() {
  if (::fdatasync(descriptor_) != 0 && errno != EINVAL) motion_file_fails(file_, "write", errno);
}

MotionReader::MotionReader(std::filesystem::path file) : file_(std::move(file)) {
  descriptor_ = ::open(file_.c_str(), O_RDONLY | O_CLOEXEC);
  const std::optional<std::string> header = descriptor_ >= 0 ? read_header(descriptor_) : std::nullopt;
  if (!header) {
    if (descriptor_ >= 0) ::close(descriptor_);
    throw BadRequest(
        fmt::format("{} is no file of motion; taut simulate SCENE -o FOLDER makes one", file_.string()));
  }
  inputs_ = header->substr(motion_begins_with.size(), length_of_inputs);
  scan(descriptor_, header->size(), records_, [](const MotionRecord&) { return true; });
  for (const auto& [frame, record] : records_) by_time_[record.time] = &record;
}

MotionReader::~MotionReader() {
  ::close(descriptor_);
}

RunState MotionReader::read(const MotionRecord& record, const Model& model) const {
  const std::string bytes = packed_bytes(descriptor_, record);
  if (Hash().add(bytes).value() != record.content)
    throw RunFailure(fmt::format("{} is damaged at t = {:.6g} s", file_.string(), record.time));
  return run_state_from(unpacked(bytes, record.size), model);
}

const MotionRecord* MotionReader::find(double time) const {
  const auto found = by_time_.find(time);
  return found == by_time_.end() ? nullptr : found->second;
}

State MotionReader::between(double time, const Model& model) const {
  const auto after = by_time_.lower_bound(time);
  if (after == by_time_.end()) return read(*std::prev(after)->second, model).state;
  State later = read(*after->second, model).state;
  if (after == by_time_.begin() || after->first == time) return later;
  return interpolate(read(*std::prev(after)->second, model).state, later, time, Interpolation::hermite);
}

}  // namespace taut
