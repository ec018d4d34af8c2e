#include "metrics_recorder.h"

#include "frames/frame_selection.h"
#include "output/atomic_file.h"

namespace taut {

// As with a film, the manifest knows the file before it has its name.
void leave_metrics(RenderJob& job, const std::vector<FrameMetrics>& rows) {
  if (job.metrics_file.has_parent_path()) make_folder(job.metrics_file.parent_path());
  PendingFile file(job.metrics_file);
  const std::vector<std::string_view> stages = StageClock::frame_stage_names();
  file.replace(metrics_text(rows, stages, are_lines(job.metrics_file)));
  std::vector<int> frames;
  frames.reserve(rows.size());
  for (const FrameMetrics& row : rows)
    if (frames.empty() || frames.back() != row.frame) frames.push_back(row.frame);
  job.metrics.frames = frames.empty() ? std::string("none") : selection_text(frames);
  job.record(job.metrics, &Manifest::metrics, file.temporary_name());
  file.commit();
  job.keep(job.metrics, &Manifest::metrics);
}

}  // namespace taut
