#pragma once

#include <cstddef>
#include <future>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bounded_queue.h"
#include "frame_sink.h"
#include "frames/captions.h"
#include "frames/panels.h"
#include "output/checkpoint.h"
#include "panel_runs.h"
#include "scene/scene.h"

namespace taut {

// What stages hand on to each other (frames.cpp).

/// So many frames at most wait before a stage: two, so that none is held up by one that takes longer; but one
/// of large scenes, whose states and shapes take a few hundred bytes a mass each.
inline std::size_t most_waiting(std::span<const Scene> scenes) {
  constexpr std::size_t many_masses = 200'000;
  std::size_t masses = 0;
  for (const Scene& scene : scenes) masses += scene.model.masses.size();
  return masses < many_masses ? 2 : 1;
}

/// A moment on its way from the simulation to what is seen of it.
struct Posed {
  int frame = 0;
  std::string hash;
  std::shared_ptr<const Checkpoint> checkpoint;  // from which it can be simulated; mostly none
  std::vector<PanelState> panels;
  std::vector<Caption> captions;  // one a panel, where they are wanted
};

/// What is seen of a moment, on its way to OpenGL.
struct Shaped {
  int frame = 0;
  std::string hash;
  std::shared_ptr<const Checkpoint> checkpoint;
  PanelPainter::Shapes shapes;
  std::vector<Caption> captions;
};

using Finished = std::shared_ptr<const FinishedFrame>;

/// Waits for a frame; null where whoever was to draw it failed, and says so itself. Throws what went wrong
/// later.
inline Finished unless_lost(const std::shared_future<Finished>& frame) {
  try {
    return frame.get();
  } catch (const std::future_error&) {
    return nullptr;
  }
}

/// A sink, and the frames on their way to it: in order, and not all of them done.
struct Lane {
  explicit Lane(FrameSink& where) : sink(where) {}

  FrameSink& sink;
  BoundedQueue<std::shared_future<Finished>> frames{4};
  std::size_t let_go = 0;  // when told to stop: at the size of a cinema's screen waiting takes too long
};

/// What OpenGL has been told to draw. Whoever waits for it is told when it is lost, too.
struct Submitted : Shaped {
  std::promise<Finished> finished;
  bool as_file = false;
};

/// Parts of pictures, to be laid together and compressed.
struct DrawnFrame {
  Submitted frame;
  PanelPainter::Drawn panels;
};

}  // namespace taut
