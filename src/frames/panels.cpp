#include "frames/panels.h"

#include <algorithm>
#include <cmath>

#include "frames/colouring.h"
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

  void write(const PanelText& panel, Size size, Image& picture) const {
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

PanelPainter::PanelPainter(std::span<const Scene> scenes, const PictureSettings& settings)
    : settings_(settings), captions_(scenes.size() > 1 ? new Captions : nullptr) {
  for (const Scene& scene : scenes) {
    const bool plain = scenes.size() > 1 && !colour_problem(scene).empty();
    if (plain && !plain_painter_) {
      plain_scene_ = std::make_unique<Scene>(scene);
      plain_scene_->look.colour_by = ColourBy::plain;
      plain_painter_ = std::make_unique<Painter>(*plain_scene_, settings);
    }
    if (!plain && !painter_) painter_ = std::make_unique<Painter>(scene, settings);
    painter_of_.push_back(plain ? plain_painter_.get() : painter_.get());
  }
}

PanelPainter::~PanelPainter() = default;

std::string PanelPainter::drawn_by() const {
  return painter_of_.front()->drawn_by();
}

PanelPainter::Shapes PanelPainter::shape(std::span<const State* const> states) {
  Shapes shapes;
  for (std::size_t i = 0; i < states.size(); ++i) shapes.push_back(painter_of_[i]->shape(*states[i]));
  return shapes;
}

void PanelPainter::submit(const Shapes& shapes) {
  for (std::size_t i = 0; i < shapes.size(); ++i) painter_of_[i]->submit(*shapes[i]);
}

PanelPainter::Drawn PanelPainter::fetch() {
  Drawn drawn;
  for (Painter* painter : painter_of_) drawn.push_back(painter->fetch());
  return drawn;
}

Image PanelPainter::finish(const Drawn& drawn, std::span<const PanelText> texts) const {
  if (drawn.size() == 1) return flatten(*drawn.front());
  const Size panel = settings_.render.size;
  Image sheet = Image::blank(sheet_size(panel, drawn.size()), settings_.render.transparent ? 4 : 3);
  const int columns = columns_for(drawn.size());
  for (int i = 0; i < static_cast<int>(drawn.size()); ++i) {
    const auto which = static_cast<std::size_t>(i);
    Image picture = flatten(*drawn[which]);
    captions_->write(texts[which], panel, picture);
    const int left = (i % columns) * panel.width, top = (i / columns) * panel.height;
    place_image(sheet, left, top, picture);
    const double x = left, y = top, width = panel.width, height = panel.height;
    if (left > 0) fill_rectangle(sheet, {x - 1.0, y, 2.0, height}, rule);
    if (top > 0) fill_rectangle(sheet, {x, y - 1.0, width, 2.0}, rule);
  }
  return sheet;
}

}  // namespace taut
