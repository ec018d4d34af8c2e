#include "sinks.h"

#include <chrono>

namespace taut {

void FolderSink::take(const FinishedFrame& frame, const StopTest& /*stop*/) {
  clock_.time(Stage::write, [&] {
    // Frames come in the order of time, so all before this one are written.
    if (frame.checkpoint) {
      const auto start = std::chrono::steady_clock::now();
      folder_.write(*frame.checkpoint);
      checkpoints_.written(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    folder_.write(frame.frame, frame.png, frame.state_hash);
  });
}

}  // namespace taut
