#include "frames/panels.h"

#include <algorithm>
#include <cmath>

#include "frames/colouring.h"
#include "render/overlay.h"

namespace taut {
namespace {

Paint rule(Theme theme) {
  return theme == Theme::dark ? Paint{{0.30, 0.32, 0.36}, 0.85} : Paint{{1.0, 1.0, 1.0}, 0.85};
}

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

SheetGrid sheet_grid(Size panel, std::size_t count) {
  return {panel, columns_for(count), rows_for(count)};
}

Size sheet_size(Size panel, std::size_t count) {
  return sheet_grid(panel, count).size();
}

Image laid_out(const SheetGrid& grid, std::span<const Image> pictures, std::span<const Caption> captions,
               const CaptionWriter* writer, Theme theme) {
  Image sheet = Image::blank(grid.size(), pictures.front().channels);
  for (int i = 0; i < grid.columns * grid.rows; ++i) {
    const auto which = static_cast<std::size_t>(i);
    const int left = (i % grid.columns) * grid.panel.width, top = (i / grid.columns) * grid.panel.height;
    const double x = left, y = top, width = grid.panel.width, height = grid.panel.height;
    if (which < pictures.size()) {
      const Image& picture = pictures[which];
      place_image(sheet, left, top, picture);
      const double drawn = picture.size.height;
      if (writer != nullptr)
        writer->write(sheet, {x, y + drawn, width, height - drawn}, grid.panel, captions[which]);
    } else if (writer != nullptr) {
      writer->fill(sheet, {x, y, width, height});
    }
    if (left > 0) fill_rectangle(sheet, {x - 1.0, y, 2.0, height}, rule(theme));
    if (top > 0) fill_rectangle(sheet, {x, y - 1.0, width, 2.0}, rule(theme));
  }
  return sheet;
}

PanelPainter::PanelPainter(std::span<const Scene> scenes, const PictureSettings& settings)
    : settings_(settings), theme_(scenes.front().look.theme) {
  if (settings.captions) writer_.emplace(theme_);
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

PanelPainter::Shapes PanelPainter::shape(std::span<const Pose> poses) {
  Shapes shapes;
  for (std::size_t i = 0; i < poses.size(); ++i) shapes.push_back(painter_of_[i]->shape(poses[i]));
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

Image PanelPainter::finish(const Drawn& drawn, std::span<const Caption> captions) const {
  if (drawn.size() == 1 && !writer_) return flatten(*drawn.front());
  // One legend says it for all.
  std::vector<Image> pictures;
  bool told = false;
  for (const auto& layers : drawn) {
    pictures.push_back(flatten(*layers, !told));
    told = told || has_legend(*layers);
  }
  return laid_out(sheet_grid(settings_.render.size, drawn.size()), pictures, captions,
                  writer_ ? &*writer_ : nullptr, theme_);
}

}  // namespace taut
