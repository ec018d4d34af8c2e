#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "base/image.h"
#include "render/geometry.h"
#include "render/gl_context.h"
#include "render/layers.h"
#include "view/view.h"

namespace taut {

/// How much care goes into a picture.
enum class Quality { draft, standard, fine };

/// The quality called "draft", "standard" or "fine"; nothing for any other name.
std::optional<Quality> quality_named(std::string_view name);

/// What costs time in a picture.
struct RenderSettings {
  Size size;
  int samples = 4;             ///< a pixel: 1, 4 or 8
  int shadow_map_size = 1024;  ///< texels along a side; 0: no shadows
  bool transparent = false;    ///< no ground and no sky, but alpha: pictures are RGBA
  int bits = 8;                ///< of each channel: 8 or 16
};

/// The settings of a quality: draft (640×360, one sample, no shadows), standard (1280×720, four samples) or
/// fine (1920×1080, eight samples); or of that quality in another size, with a shadow map to match.
RenderSettings render_settings_for(Quality quality, std::optional<Size> size = {});

/// Draws what pictures show. Holds OpenGL objects of the context it was made with, which must outlive it;
/// the context is current only while a member function runs, so calls may come from any thread, one at a
/// time.
class Renderer {
 public:
  /// `shader_folder`: files there take the place of the built-in shaders of the same name. Throws BadRequest
  /// for a size that can't be drawn; RunFailure when OpenGL lacks something, a shader doesn't compile, or
  /// text is needed and the font is missing.
  Renderer(GlContext& context, const Look& look, const RenderSettings& settings,
           const std::filesystem::path& shader_folder = {});
  ~Renderer();

  /// Has a picture drawn, without waiting for it.
  void submit(const Geometry& geometry);
  /// The parts of the picture submitted first of those not fetched yet; there must be one. Waits for it.
  /// While one is waited for another may be drawn: who submits one or two ahead keeps what draws busy.
  std::shared_ptr<const Layers> fetch();
  /// Both in one, when nothing else is submitted.
  std::shared_ptr<const Layers> draw(const Geometry& geometry);

 private:
  struct Submitted;
  class Drawing;
  GlContext& context_;
  std::unique_ptr<Drawing> drawing_;
};

}  // namespace taut
