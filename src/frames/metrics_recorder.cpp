#include "metrics_recorder.h"

#include "frames/frame_selection.h"
#include "side_files.h"

namespace taut {

void leave_metrics(RenderJob& job, const std::vector<FrameMetrics>& rows) {
  std::vector<int> frames;
  frames.reserve(rows.size());
  for (const FrameMetrics& row : rows)
    if (frames.empty() || frames.back() != row.frame) frames.push_back(row.frame);
  job.metrics.record.frames = frames.empty() ? std::string("none") : selection_text(frames);
  const std::vector<std::string_view> stages = StageClock::frame_stage_names();
  leave_text(job.metrics, job.book(), metrics_text(rows, stages, are_lines(job.metrics.file)));
}

}  // namespace taut
