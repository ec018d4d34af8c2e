#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "frames/painter.h"
#include "scene/scene.h"

namespace taut {

/// One picture among others: a state, and what is said of it.
struct Panel {
  const State* state = nullptr;
  std::string title;
  std::vector<std::string> lines;  ///< smaller, below the title
  bool failed = false;             ///< the lines say how: in a warning colour
  bool plain = false;  ///< without the colours that the scene's look asks for, and without their legend
};

/// Pixels that so many panels of a size take together: up to three in a row, then as near to a square as may
/// be.
Size sheet_size(Size panel, std::size_t count);

/// Draws states of one scene side by side, each with its title; one alone fills the picture and has none.
class PanelPainter {
 public:
  /// `settings` has the size of one panel. Refers to the scene from then on. Throws as Painter does.
  PanelPainter(const Scene& scene, const PictureSettings& settings);
  ~PanelPainter();

  Image draw(std::span<const Panel> panels);

 private:
  struct Captions;
  Painter& painter_for(const Panel& panel);

  const Scene& scene_;
  Painter painter_;
  PictureSettings settings_;
  std::unique_ptr<Scene> plain_scene_;  // these two made when first needed
  std::unique_ptr<Painter> plain_painter_;
  std::unique_ptr<Captions> captions_;  // made when first needed: one panel alone needs no font
};

}  // namespace taut
