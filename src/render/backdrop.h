#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/frame_block.h"
#include "geometry/region.h"
#include "gl/program.h"
#include "gl/targets.h"
#include "ground_shades.h"

namespace taut {

/// Sky and ground seen from one place, without shadows.
class LitBackdrop {
 public:
  LitBackdrop(const Geometry& geometry, Readback drawn)
      : pose_(geometry.pose), grounds_(geometry.grounds), drawn_(std::move(drawn)) {}

  bool shows(const Geometry& geometry) const {
    return pose_ == geometry.pose && grounds_ == geometry.grounds;
  }
  /// The picture (RGB). Waits for it.
  const std::shared_ptr<const Image>& image();

 private:
  CameraPose pose_;
  std::vector<GroundPatch> grounds_;
  std::optional<Readback> drawn_;  // until it is asked for
  std::shared_ptr<const Image> image_;
};

/// Draws sky and ground. All but the shadows is drawn once and kept for as long as the camera stands still.
class Backdrop {
 public:
  /// `cut_out`: without sky and ground, only the shadows on it.
  Backdrop(const Gl& gl, const ShaderLibrary& library, Size size, bool cut_out, int bits);

  /// The whole backdrop without shadows. Where it isn't kept it is drawn with the block that is loaded.
  std::shared_ptr<LitBackdrop> lit(const Geometry& geometry, const FrameBlock& block);

  /// The grounds in a region of it, seen with the block that is loaded, in the shade that was worked out for
  /// them: empty where there is no ground. Of a cut-out, the shade alone.
  Readback shaded(const Geometry& geometry, const Region& region, const GroundShades& shades);

  /// Gives whatever is being drawn the depth of the grounds.
  void draw_depth(const Geometry& geometry) const;

 private:
  const Program& ground(const GroundPatch& patch, bool shadows);
  void draw(const Program& program, const GroundPatch& patch) const;
  void draw_sky(const Geometry& geometry, const FrameBlock& block) const;

  const Gl* gl_;
  const ShaderLibrary* library_;
  Size size_;
  bool cut_out_;
  std::array<std::optional<Program>, 8> grounds_;
  Program ground_depth_, sky_;
  GlObject no_attributes_;
  PictureTarget target_;
  std::shared_ptr<LitBackdrop> kept_;
};

}  // namespace taut
