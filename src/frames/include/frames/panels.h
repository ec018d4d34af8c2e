#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "frames/painter.h"
#include "scene/scene.h"

namespace taut {

/// What is said of one picture among others.
struct PanelText {
  std::string title;
  std::vector<std::string> lines;  ///< smaller, below the title
  bool failed = false;             ///< the lines say how: in a warning colour
};

/// Pixels that so many panels of a size take together: up to three in a row, then as near to a square as may
/// be.
Size sheet_size(Size panel, std::size_t count);

/// Draws states of scenes that differ in method alone side by side, each with a title; one alone fills the
/// picture and has none. Where a method doesn't know what the look colours by, its panel stays plain. Each of
/// the steps may run in a thread of its own.
class PanelPainter {
 public:
  using Shapes = std::vector<std::shared_ptr<const Geometry>>;
  using Drawn = std::vector<std::shared_ptr<const Layers>>;

  /// `settings` has the size of one panel. Refers to the scenes from then on. Throws as Painter does.
  PanelPainter(std::span<const Scene> scenes, const PictureSettings& settings);
  ~PanelPainter();

  /// What is seen of a state of each scene.
  Shapes shape(std::span<const State* const> states);
  /// Has them drawn, without waiting.
  void submit(const Shapes& shapes);
  /// The parts of the panels submitted first of those not fetched yet.
  Drawn fetch();
  /// The picture; `texts` is not used for one panel alone.
  Image finish(const Drawn& drawn, std::span<const PanelText> texts) const;

  /// What draws (GlContext::description()).
  std::string drawn_by() const;

 private:
  struct Captions;

  PictureSettings settings_;
  std::unique_ptr<Scene> plain_scene_;                // only where a panel stays plain
  std::unique_ptr<Painter> painter_, plain_painter_;  // only where a panel needs it
  std::vector<Painter*> painter_of_;                  // of each panel
  std::unique_ptr<Captions> captions_;                // one panel alone needs no font
};

}  // namespace taut
