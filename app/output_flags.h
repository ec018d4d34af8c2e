#pragma once

#include <optional>
#include <span>
#include <string>

#include "command_line.h"
#include "flags.h"
#include "frames/frames.h"
#include "host/signals.h"
#include "measure/plan.h"

namespace taut {

/// Where frames and films go, and what is told of them.
struct OutputFlags {
  PictureFlags picture;
  std::string folder, film, metrics, selection, rate, slow, depth, shard;
  bool certify = false;
  bool no_frames = false, overwrite = false, json = false, quiet = false, verbose = false;

  void add_to(Verb& verb, const std::string& usual_folder);
  /// Puts what the flags say about colours and speed into a scene. Throws BadRequest.
  void apply_to(Scene& scene) const;
  /// Throws BadRequest. `usual` is the size of a picture where neither size nor quality is given.
  RenderRequest request(const std::string& usual_folder, std::optional<Size> usual = {}) const;
};

/// Renders a scene, run in one way or in several, until a signal comes, says what came of it, and returns the
/// exit status.
int render_and_report(std::span<Scene> scenes, const RenderRequest& request, const OutputFlags& flags,
                      const InterruptWatch& interrupts, const std::optional<Plan>& plan = {});

}  // namespace taut
