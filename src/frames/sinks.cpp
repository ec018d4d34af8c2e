#include "sinks.h"

#include "base/failure.h"
#include "base/stopwatch.h"

namespace taut {

void FolderSink::take(const FinishedFrame& frame, const StopTest& /*stop*/) {
  if (gone_) return;
  try {
    write(frame);
  } catch (const RunFailure&) {
    if (!only_help_) throw;
    folder_.remove();
    gone_ = true;
  }
}

void FolderSink::write(const FinishedFrame& frame) {
  // Frames come in the order of time, so all before this one are written.
  if (frame.checkpoint) clock_.time(Stage::write, [&] { keep(*frame.checkpoint); });
  clock_.time(
      Stage::write, [&] { folder_.write(frame.frame, frame.file, frame.state_hash); }, frame.frame);
}

void FolderSink::keep(const Checkpoint& checkpoint) {
  const Stopwatch watch;
  folder_.write(checkpoint, metrics_ != nullptr ? metrics_->before(checkpoint.frame, clock_) : std::string());
  checkpoints_.written(watch.seconds());
}

}  // namespace taut
