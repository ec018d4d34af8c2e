#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "base/image.h"
#include "render/geometry.h"
#include "render/gl_context.h"
#include "render/layers.h"
#include "render/renderer.h"
#include "render/trails.h"
#include "scene/scene.h"

namespace taut {

/// How pictures are to be made, beyond what the scene says.
struct PictureSettings {
  RenderSettings render;
  GlChoice gl;
  std::filesystem::path shader_folder;  ///< takes the place of the built-in shaders; empty: those
  bool captions = false;  ///< whether each picture has a caption (captions.h), as a part of its size

  /// What of a picture's size is drawn by the renderer.
  Size drawn_size() const;
};

/// Throws BadRequest for a size that is not from 16 to 16384 pixels each way.
void check_size(Size size);

/// How much memory (bytes) drawing pictures takes at most, from OpenGL's buffers to what is on its way to a
/// file.
double picture_bytes(const RenderSettings& settings);

/// The settings as text in which any difference that shows in a picture shows.
std::string settings_text(const PictureSettings& settings);

/// What a picture is of: a state, and the trails that lead to it, which may be none.
struct Pose {
  const State* state = nullptr;
  const Trails* trails = nullptr;
};

/// Draws the states of one scene. Each step may run in a thread of its own, one at a time in each.
class Painter {
 public:
  /// Refers to the scene, whose view is settled, from then on. Throws BadRequest for pictures that memory
  /// can't hold, RunFailure when there is no way to draw.
  Painter(const Scene& scene, const PictureSettings& settings);
  ~Painter();
  Painter(const Painter&) = delete;
  Painter& operator=(const Painter&) = delete;

  /// What is seen of a state.
  std::shared_ptr<const Geometry> shape(const Pose& pose);
  /// Has it drawn, without waiting.
  void submit(const Geometry& geometry);
  /// The parts of the picture submitted first of those not fetched yet; flatten() lays them over each other.
  std::shared_ptr<const Layers> fetch();
  /// All steps in one, when nothing is submitted; without what colours mean for one of several pictures that
  /// share it.
  Image draw(const State& state, const Trails* trails = nullptr, bool with_legend = true);

  /// What draws (GlContext::description()).
  std::string drawn_by() const;

 private:
  struct Tools;
  const Scene& scene_;
  std::unique_ptr<Tools> tools_;
};

}  // namespace taut
