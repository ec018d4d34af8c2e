#include "frames/film_frames.h"

#include <algorithm>

#include "frames/film_time.h"
#include "frames/frame_selection.h"

namespace taut {

int film_frame_count(const Scene& scene, const FrameRate& rate) {
  return frame_count(film_duration(scene.look, scene.duration), rate);
}

double shown_time(const Scene& scene, int frame, const FrameRate& rate) {
  return std::min(scene_time(scene.look, frame_time(frame, rate)), scene.duration);
}

}  // namespace taut
