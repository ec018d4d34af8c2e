#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "frames/captions.h"
#include "frames/painter.h"
#include "scene/scene.h"

namespace taut {

/// Pixels that so many panels of a size take together: up to three in a row, then as near to a square as may
/// be.
Size sheet_size(Size panel, std::size_t count);

/// How pictures of one size lie on a sheet.
struct SheetGrid {
  Size panel;  ///< pixels, with its caption
  int columns = 1, rows = 1;

  Size size() const { return {panel.width * columns, panel.height * rows}; }
};

/// The grid that sheet_size() is about.
SheetGrid sheet_grid(Size panel, std::size_t count);

/// Lays pictures on a sheet, row by row, with thin lines between them; with a writer, `captions` below them,
/// and places that stay empty in its colour. `pictures` are as large as PictureSettings::drawn_size().
Image laid_out(const SheetGrid& grid, std::span<const Image> pictures, std::span<const Caption> captions,
               const CaptionWriter* writer, Theme theme);

/// Draws states of scenes that differ in method alone side by side. Where a method doesn't know what the look
/// colours by, its panel stays plain. Each of the steps may run in a thread of its own.
class PanelPainter {
 public:
  using Shapes = std::vector<std::shared_ptr<const Geometry>>;
  using Drawn = std::vector<std::shared_ptr<const Layers>>;

  /// `settings` has the size of one panel. Refers to the scenes from then on. Throws as Painter does.
  PanelPainter(std::span<const Scene> scenes, const PictureSettings& settings);
  ~PanelPainter();

  /// What is seen of a state of each scene.
  Shapes shape(std::span<const Pose> poses);
  /// Has them drawn, without waiting.
  void submit(const Shapes& shapes);
  /// The parts of the panels submitted first of those not fetched yet.
  Drawn fetch();
  /// The picture; without captions in the settings `captions` is not used.
  Image finish(const Drawn& drawn, std::span<const Caption> captions) const;

  /// What draws (GlContext::description()).
  std::string drawn_by() const;

 private:
  PictureSettings settings_;
  Theme theme_;
  std::unique_ptr<Scene> plain_scene_;                // only where a panel stays plain
  std::unique_ptr<Painter> painter_, plain_painter_;  // only where a panel needs it
  std::vector<Painter*> painter_of_;                  // of each panel
  std::optional<CaptionWriter> writer_;               // only with captions
};

}  // namespace taut
