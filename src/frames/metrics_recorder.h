#pragma once

#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "frames/metrics.h"
#include "render_job.h"
#include "stage_clock.h"

namespace taut {

/// Writes what was measured of a job's frames, and remembers the file as films are remembered; of a run that
/// ended early, so far as it went. Throws RunFailure.
void leave_metrics(RenderJob& job, const std::vector<FrameMetrics>& rows);

/// Collects what is measured of frames as they pass, in the order of time; frames' stages may end later, in
/// other threads.
class MetricsRecorder {
 public:
  /// Goes on from what before() gave.
  void restore(std::string_view bytes) { rows_ = metrics_from_bytes(bytes); }

  void add(FrameMetrics row) {
    const std::lock_guard lock(mutex_);
    rows_.push_back(std::move(row));
  }

  /// All rows so far, with what the clock says of their frames.
  std::vector<FrameMetrics> rows(const StageClock& clock) const {
    const std::lock_guard lock(mutex_);
    std::vector<FrameMetrics> rows = rows_;
    for (FrameMetrics& row : rows)
      if (row.stage_seconds.empty()) row.stage_seconds = clock.seconds_of(row.frame);
    return rows;
  }

  /// Those of frames before one that all stages are done with, as bytes.
  std::string before(int frame, const StageClock& clock) const {
    std::vector<FrameMetrics> done = rows(clock);
    std::erase_if(done, [frame](const FrameMetrics& row) { return row.frame >= frame; });
    return metrics_to_bytes(done);
  }

 private:
  mutable std::mutex mutex_;
  std::vector<FrameMetrics> rows_;
};

}  // namespace taut
