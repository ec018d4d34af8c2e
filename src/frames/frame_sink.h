#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/image.h"
#include "base/stop.h"
#include "output/checkpoint.h"

namespace taut {

/// A frame that is done.
struct FinishedFrame {
  int frame = 0;
  std::string state_hash;
  Image image;
  std::vector<std::uint8_t> file;                ///< the image as a file; empty where no sink wants that
  std::shared_ptr<const Checkpoint> checkpoint;  ///< from which it could be simulated again; mostly null
};

/// Where frames go.
class FrameSink {
 public:
  FrameSink() = default;
  FrameSink(const FrameSink&) = delete;
  FrameSink& operator=(const FrameSink&) = delete;
  virtual ~FrameSink() = default;

  /// Called first of all, in the thread of take(). Throws RunFailure, and Interrupted.
  virtual void begin(const StopTest& stop) = 0;
  /// Whether it wants this frame, asked before it is drawn, and from another thread than take()'s.
  virtual bool wants(int frame, const std::string& state_hash) const = 0;
  virtual bool wants_file() const = 0;
  /// Takes a frame it wants, in the order of time. Throws RunFailure, and Interrupted.
  virtual void take(const FinishedFrame& frame, const StopTest& stop) = 0;
};

}  // namespace taut
