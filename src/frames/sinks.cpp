#include "sinks.h"

#include <fmt/format.h>

#include <chrono>

#include "base/failure.h"
#include "output/content_hash.h"
#include "output/png_read.h"

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

void FilmSink::begin(const StopTest& stop, const std::function<void(int)>& added) {
  int count = 0;
  for (const int frame : done_) {
    stop_if_told(stop);
    const std::filesystem::path file = folder_->frame_file(frame);
    const std::optional<std::string> bytes = bytes_of_file(file);
    if (!bytes) throw RunFailure(fmt::format("{} has gone", file.string()));
    clock_.time(Stage::feed, [&] { film_.add(decode_png(*bytes, file), stop); });
    if (added) added(++count);
  }
}

}  // namespace taut
