#include "sinks.h"

#include "base/stopwatch.h"

namespace taut {

void FolderSink::take(const FinishedFrame& frame, const StopTest& /*stop*/) {
  clock_.time(Stage::write, [&] {
    // Frames come in the order of time, so all before this one are written.
    if (frame.checkpoint) {
      const Stopwatch watch;
      folder_.write(*frame.checkpoint);
      checkpoints_.written(watch.seconds());
    }
    folder_.write(frame.frame, frame.file, frame.state_hash);
  });
}

}  // namespace taut
