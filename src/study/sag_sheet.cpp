#include "study/sag_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "frames/colouring.h"
#include "model/measures.h"
#include "render/camera.h"
#include "render/camera_fit.h"
#include "render/overlay.h"
#include "render/text.h"

namespace taut {
namespace {

constexpr int most_columns = 5;
constexpr int letters = 20, small_letters = 16, heading_letters = 26;  // pixels
constexpr int caption_height = 84, heading_height = 92, gap = 12;      // pixels
constexpr Colour paper{1.0, 1.0, 1.0}, ink{0.13, 0.15, 0.18}, faint_ink{0.38, 0.41, 0.45};
constexpr Colour exact_colour{0.0, 0.45, 0.70};
// More links than this would hide the picture under the exact shape: then only sheets' borders are drawn.
constexpr std::size_t most_lines = 400;
constexpr double margin = 0.08;  // of each picture

// A camera that looks along the scene's own line of sight and sees all states whole.
Camera camera_for(const Scene& scene, const SagStudy& study, double aspect) {
  const Vec3 up = up_direction(scene.camera, scene.model);
  const Vec3 towards_eye = scene.camera.eye && scene.camera.target
                               ? Vec3(*scene.camera.eye - *scene.camera.target)
                               : scene.camera.direction;
  CameraFit fit(sight_axes(towards_eye, up), scene.camera.field_of_view, aspect, margin);
  const auto include = [&](const State& state) {
    for (std::size_t i = 0; i < state.position.size(); ++i) fit.add(state.position.at(i), 0.0);
  };
  include(study.exact.state);
  for (const SagEntry& entry : study.entries)
    if (!entry.growing) include(entry.shape.state);
  const CameraFit::Place place = fit.place(0.3 * scene_size(scene.model, scene.start));
  Camera camera;
  camera.field_of_view = scene.camera.field_of_view;
  camera.up = scene.camera.up;
  camera.eye = place.eye;
  camera.target = place.target;
  return camera;
}

// How many triangles each link is an edge of.
std::vector<int> triangles_at(const Model& model) {
  std::vector<int> count(model.links.size(), 0);
  for (const Triangle& triangle : model.triangles)
    for (const Index link : triangle.links)
      if (link != no_link) ++count[link];
  return count;
}

std::vector<Index> drawn_links(const Model& model) {
  const bool all = model.links.size() <= most_lines;
  const std::vector<int> triangles = triangles_at(model);
  std::vector<Index> links;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (all || triangles[i] == 1) links.push_back(static_cast<Index>(i));
  return links;
}

void draw_exact(const Scene& scene, const State& exact, const std::vector<Index>& links, Image& panel) {
  const CameraPose pose = camera_pose(scene.camera, scene.model, scene.start, exact);
  const auto place = [&](Index mass) {
    const Vec3 at = picture_position(pose, panel.size.width, panel.size.height, exact.position.at(mass));
    return Point{at.x(), at.y()};
  };
  for (const Index link : links)
    draw_line(panel, place(scene.model.links.a[link]), place(scene.model.links.b[link]), 2.5,
              {exact_colour, 1.0});
}

using Caption = std::array<std::string, 3>;

void write_caption(const Font& font, const Caption& caption, int left, int top, Image& sheet) {
  for (int row = 0; row < 3; ++row)
    font.draw(sheet, {static_cast<double>(left), top + 22.0 + 25.0 * row},
              caption[static_cast<std::size_t>(row)], row == 0 ? letters : small_letters,
              {row == 2 ? faint_ink : ink, 1.0});
}

Caption caption_of(const SagStudy& study, const SagEntry& entry) {
  const double relative = study.exact_sag == 0.0 ? 0.0 : 100.0 * entry.sag_error / study.exact_sag;
  return {fmt::format("{} {}", entry.passes, entry.passes == 1 ? "pass" : "passes"),
          fmt::format("sag {:.4f} m, {:+.3g} %", entry.sag, relative),
          entry.growing ? fmt::format("velocities kept, at {:.3g} s: growing", entry.shape.state.time)
          : entry.shape.at_rest
              ? fmt::format("farthest mass {:.3g} m off", entry.position_error)
              : fmt::format("not at rest: {:.2g} m in 0.5 s", entry.shape.largest_movement)};
}

// One panel: a state, and what is said of it.
struct Panel {
  const State* state;
  Caption caption;
};

std::vector<Panel> panels_of(const SagStudy& study) {
  std::vector<Panel> panels;
  for (const SagEntry& entry : study.entries)
    panels.push_back({&entry.shape.state, caption_of(study, entry)});
  panels.push_back(
      {&study.exact.state, {"exact", fmt::format("sag {:.4f} m", study.exact_sag), study.exact.how}});
  return panels;
}

}  // namespace

Image sag_sheet(const Scene& scene, const SagStudy& study, const PictureSettings& settings) {
  const Size panel = settings.render.size;
  Scene posed = scene;
  posed.look.ground = false;
  posed.look.exact = false;  // drawn over the picture, below
  if (!colour_problem(scene).empty()) posed.look.colour_by = ColourBy::plain;
  posed.camera = camera_for(scene, study, static_cast<double>(panel.width) / panel.height);
  const std::vector<Panel> panels = panels_of(study);
  const auto count = static_cast<int>(panels.size());
  const int columns = std::min(most_columns, count), rows = (count + columns - 1) / columns;
  const Size whole{gap + columns * (panel.width + gap),
                   heading_height + rows * (panel.height + caption_height)};
  check_size(whole);
  Image sheet = Image::blank(whole, 3);
  fill_rectangle(sheet, {0.0, 0.0, static_cast<double>(whole.width), static_cast<double>(whole.height)},
                 {paper, 1.0});
  const Font font = Font::load();
  font.draw(sheet, {static_cast<double>(gap), 38.0}, fmt::format("{}: sag over passes", scene.title),
            heading_letters, {ink, 1.0});
  font.draw(sheet, {static_cast<double>(gap), 70.0},
            fmt::format("{} at {:.6g} steps/s; blue: the exact shape", study.settings.method,
                        study.settings.steps_per_second()),
            small_letters, {faint_ink, 1.0});
  Painter painter(posed, settings);
  const std::vector<Index> links = drawn_links(scene.model);
  for (int i = 0; i < count; ++i) {
    const auto& [state, caption] = panels[static_cast<std::size_t>(i)];
    Image picture = painter.draw(*state);
    draw_exact(posed, study.exact.state, links, picture);
    const int left = gap + (i % columns) * (panel.width + gap);
    const int top = heading_height + (i / columns) * (panel.height + caption_height);
    place_image(sheet, left, top, picture);
    write_caption(font, caption, left, top + panel.height, sheet);
  }
  return sheet;
}

}  // namespace taut
