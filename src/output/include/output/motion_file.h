#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "motion/run_state.h"

namespace taut {

/// Where a file of motion has one of its moments.
struct MotionRecord {
  double time = 0.0;                                    ///< s
  std::uint64_t state_hash = 0;                         ///< state_hash() of the state
  std::uint64_t content = 0;                            ///< hash of its packed bytes
  std::uint64_t offset = 0, packed_size = 0, size = 0;  ///< bytes
};

// A file of motion begins with a line that says so and one that names its inputs. Then comes a record a
// frame: seven numbers of eight bytes (a mark, frame, time, hash of the state, hash of the packed bytes, size
// before packing, size packed), and to_bytes() of the run at that moment, packed(). Each says how long it is,
// so any is found without unpacking another, and a last one that is cut short is known as such.

/// Adds moments to a file of motion. It is locked while the object lives.
class MotionWriter {
 public:
  /// Opens the file, or begins it, and cuts off what is damaged. `inputs` is a hash of all that decides the
  /// motion. Throws OutputConflict where the file was made from other inputs or is no such file, unless told
  /// to overwrite; RunFailure where it can't be written, or another program holds it.
  MotionWriter(std::filesystem::path file, std::string_view inputs, bool overwrite);
  ~MotionWriter();
  MotionWriter(const MotionWriter&) = delete;
  MotionWriter& operator=(const MotionWriter&) = delete;

  const std::map<int, MotionRecord>& records() const { return records_; }
  /// Appends a frame. Throws RunFailure with the system's reason.
  void add(int frame, const RunState& moment);
  /// Has the system bring all of it to the disk. Throws RunFailure with its reason.
  void sync();

 private:
  void open(std::string_view header, bool overwrite);

  std::filesystem::path file_;
  int descriptor_ = -1;
  std::uint64_t end_ = 0;
  std::map<int, MotionRecord> records_;
};

/// Reads moments of a file of motion, by frame or by time.
class MotionReader {
 public:
  /// Throws BadRequest where there is no such file. What is damaged at its end is left out.
  explicit MotionReader(std::filesystem::path file);
  ~MotionReader();
  MotionReader(const MotionReader&) = delete;
  MotionReader& operator=(const MotionReader&) = delete;

  const std::map<int, MotionRecord>& records() const { return records_; }
  /// What the file's second line says.
  const std::string& inputs() const { return inputs_; }
  /// A moment. Throws RunFailure where it is damaged, and BadRequest where it is of another model.
  RunState read(const MotionRecord& record, const Model& model) const;
  /// The record of exactly that time (s); none where there is none.
  const MotionRecord* find(double time) const;
  /// The state at a time between two moments, along a cubic through both; as at the nearest one outside.
  State between(double time, const Model& model) const;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::string inputs_;
  std::map<int, MotionRecord> records_;
  std::map<double, const MotionRecord*> by_time_;
};

}  // namespace taut
