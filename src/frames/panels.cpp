#include "frames/panels.h"

#include <algorithm>
#include <cmath>

#include "render/overlay.h"
#include "render/text.h"

namespace taut {
namespace {

constexpr Paint ink{{0.10, 0.12, 0.15}, 1.0}, faint_ink{{0.27, 0.30, 0.34}, 1.0};
constexpr Paint warning{{0.76, 0.22, 0.05}, 1.0}, rule{{1.0, 1.0, 1.0}, 0.85};

int columns_for(std::size_t count) {
  constexpr std::size_t row = 3;
  if (count <= row) return static_cast<int>(count);
  return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
}

int rows_for(std::size_t count) {
  const int columns = columns_for(count);
  return (static_cast<int>(count) + columns - 1) / columns;
}

}  // namespace

struct PanelPainter::Captions {
  Font font = Font::load();

  void write(const Panel& panel, Size size, Image& picture) const {
    const double letters = std::clamp(size.height / 18.0, 11.0, 34.0), margin = 0.6 * letters;
    double baseline = margin + letters;
    font.draw(picture, {margin, baseline}, panel.title, letters, ink);
    for (const std::string& line : panel.lines) {
      baseline += letters;
      font.draw(picture, {margin, baseline}, line, 0.72 * letters, panel.failed ? warning : faint_ink);
    }
  }
};

Size sheet_size(Size panel, std::size_t count) {
  return {panel.width * columns_for(count), panel.height * rows_for(count)};
}

PanelPainter::PanelPainter(const Scene& scene, const PictureSettings& settings)
    : scene_(scene), painter_(scene, settings), settings_(settings) {}

PanelPainter::~PanelPainter() = default;

Painter& PanelPainter::painter_for(const Panel& panel) {
  if (!panel.plain) return painter_;
  if (!plain_painter_) {
    plain_scene_ = std::make_unique<Scene>(scene_);
    plain_scene_->look.colour_by = ColourBy::plain;
    plain_painter_ = std::make_unique<Painter>(*plain_scene_, settings_);
  }
  return *plain_painter_;
}

Image PanelPainter::draw(std::span<const Panel> panels) {
  if (panels.size() == 1) return painter_for(panels.front()).draw(*panels.front().state);
  if (!captions_) captions_ = std::make_unique<Captions>();
  const Size panel = settings_.render.size;
  Image sheet = Image::blank(sheet_size(panel, panels.size()), settings_.render.transparent ? 4 : 3);
  const int columns = columns_for(panels.size());
  for (int i = 0; i < static_cast<int>(panels.size()); ++i) {
    const Panel& shown = panels[static_cast<std::size_t>(i)];
    Image picture = painter_for(shown).draw(*shown.state);
    captions_->write(shown, panel, picture);
    const int left = (i % columns) * panel.width, top = (i / columns) * panel.height;
    place_image(sheet, left, top, picture);
    const double x = left, y = top, width = panel.width, height = panel.height;
    if (left > 0) fill_rectangle(sheet, {x - 1.0, y, 2.0, height}, rule);
    if (top > 0) fill_rectangle(sheet, {x, y - 1.0, width, 2.0}, rule);
  }
  return sheet;
}

}  // namespace taut
