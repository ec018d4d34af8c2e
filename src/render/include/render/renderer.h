#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "base/image.h"
#include "model/model.h"
#include "model/state.h"
#include "render/camera.h"
#include "render/gl_context.h"
#include "view/view.h"

namespace taut {

/// How much care goes into a picture.
enum class Quality { draft, standard, fine };

/// The quality called "draft", "standard" or "fine"; nothing for any other name.
std::optional<Quality> quality_named(std::string_view name);

/// What costs time in a picture.
struct RenderSettings {
  Size size;
  int samples = 4;             ///< a pixel, 1 or 4
  int shadow_map_size = 1024;  ///< texels along a side; 0: no shadows
  bool transparent = false;    ///< no ground and no sky, but alpha: pictures are RGBA
};

RenderSettings render_settings_for(Quality quality);

/// Draws states of one model. Holds OpenGL objects of the context it was made with, which must outlive it;
/// the context is current only while a member function runs, so calls may come from any thread, one at a
/// time.
class Renderer {
 public:
  /// `shader_folder`: files there take the place of the built-in shaders of the same name. Throws BadRequest
  /// for a size that can't be drawn; RunFailure when OpenGL lacks something, a shader doesn't compile, or
  /// text is needed and the font is missing.
  Renderer(GlContext& context, const Model& model, const State& start, const Look& look,
           const RenderSettings& settings, const std::filesystem::path& shader_folder = {});
  ~Renderer();

  /// The picture of a state: RGB, or RGBA with straight alpha when transparent.
  Image draw(const State& state, const CameraPose& pose);

 private:
  class Drawing;
  GlContext& context_;
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace taut
