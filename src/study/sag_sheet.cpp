#include "study/sag_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/split.h"
#include "frames/colouring.h"
#include "model/measures.h"
#include "picture_behind.h"
#include "render/camera.h"
#include "render/camera_fit.h"
#include "render/overlay.h"
#include "render/support_reach.h"
#include "render/text.h"

namespace taut {
namespace {

constexpr int most_columns = 5;
constexpr int letters = 20, small_letters = 16, heading_letters = 26;  // pixels
constexpr int caption_height = 84, gap = 12;                           // pixels
constexpr Colour paper{1.0, 1.0, 1.0}, ink{0.13, 0.15, 0.18}, faint_ink{0.38, 0.41, 0.45};
constexpr Colour exact_colour{0.0, 0.33, 0.56};
constexpr double exact_width = 3.0;  // pixels
// More links than this would hide the picture under the exact shape: then only sheets' borders are drawn.
constexpr std::size_t most_lines = 400;
constexpr double sheet_margin = 0.08;  // of each picture

// A camera that looks along the scene's own line of sight and sees all states whole, and what holds them.
Camera camera_for(const Scene& scene, const SagStudy& study, double aspect) {
  const Vec3 up = up_direction(scene.camera, scene.model);
  const Vec3 towards_eye = scene.camera.eye && scene.camera.target
                               ? Vec3(*scene.camera.eye - *scene.camera.target)
                               : scene.camera.direction;
  CameraFit fit(sight_axes(towards_eye, up), scene.camera.field_of_view, aspect, sheet_margin);
  const SupportReach supports = reach_of_supports(scene.model, scene.start, scene.look, up);
  for (const auto& [place, radius] : supports.fixed) fit.add(place, radius);
  const auto include = [&](const State& state) {
    for (std::size_t i = 0; i < state.position.size(); ++i) fit.add(state.position.at(i), 0.0);
    for (const auto& [mass, reach] : supports.carried)
      fit.add(state.position.at(mass) + reach.place, reach.radius);
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

// The scene without all that moves: what is seen behind it.
Image backdrop_of(const Scene& posed, const PictureSettings& settings) {
  Scene empty = posed;
  empty.look.masses = empty.look.links = empty.look.surface = empty.look.bones = empty.look.colliders = false;
  empty.look.colour_by = ColourBy::plain;
  return Painter(empty, settings).draw(empty.start);
}

// The exact shape over the backdrop.
Image exact_lines(const Scene& scene, const State& exact, const std::vector<Index>& links, Image backdrop) {
  const CameraPose pose = camera_pose(scene.camera, scene.model, scene.start, exact);
  const auto place = [&](Index mass) {
    const Vec3 at =
        picture_position(pose, backdrop.size.width, backdrop.size.height, exact.position.at(mass));
    return Point{at.x(), at.y()};
  };
  for (const Index link : links)
    draw_line(backdrop, place(scene.model.links.a[link]), place(scene.model.links.b[link]), exact_width,
              {exact_colour, 1.0});
  return backdrop;
}

// As large as wanted, or as small as it takes to fit a width; what would be too small to read is cut short.
void write_fitted(const Font& font, Image& sheet, const Point& baseline, std::string text, double size,
                  double width, const Colour& colour) {
  constexpr double smallest = 0.7;  // of the size
  const double share = width / std::max(1.0, font.width(text, size));
  size *= std::clamp(share, smallest, 1.0);
  if (font.width(text, size) > width) {
    while (!text.empty() && font.width(text + "…", size) > width) {
      while (text.size() > 1 && (static_cast<unsigned char>(text.back()) & 0xc0U) == 0x80U) text.pop_back();
      text.pop_back();
    }
    text += "…";
  }
  font.draw(sheet, baseline, text, size, {colour, 1.0});
}

// Lines of words that fit a width.
std::vector<std::string> wrapped_to(const Font& font, const std::string& text, double size, double width) {
  std::vector<std::string> lines;
  for (const std::string_view word : split(text, ' ')) {
    std::string longer = lines.empty() ? std::string(word) : fmt::format("{} {}", lines.back(), word);
    if (!lines.empty() && font.width(longer, size) <= width)
      lines.back() = std::move(longer);
    else
      lines.emplace_back(word);
  }
  return lines;
}

using Caption = std::array<std::string, 3>;

void write_caption(const Font& font, const Caption& caption, int left, int top, double width, Image& sheet) {
  for (int row = 0; row < 3; ++row)
    write_fitted(font, sheet, {static_cast<double>(left), top + 22.0 + 25.0 * row},
                 caption[static_cast<std::size_t>(row)], row == 0 ? letters : small_letters, width,
                 row == 2 ? faint_ink : ink);
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
  posed.camera = camera_for(posed, study, static_cast<double>(panel.width) / panel.height);
  const std::vector<Panel> panels = panels_of(study);
  const auto count = static_cast<int>(panels.size());
  const int columns = std::min(most_columns, count), rows = (count + columns - 1) / columns;
  const Font font = Font::load();
  const int width = gap + columns * (panel.width + gap);
  const double room = width - 2.0 * gap;
  const std::vector<std::string> heading =
      wrapped_to(font, fmt::format("{}: sag over passes", scene.title), heading_letters, room);
  constexpr int heading_line = 34, legend_rows = 58;
  const int heading_height = heading_line * static_cast<int>(heading.size()) + legend_rows;
  const Size whole{width, heading_height + rows * (panel.height + caption_height)};
  check_size(whole);
  Image sheet = Image::blank(whole, 3);
  fill_rectangle(sheet, {0.0, 0.0, static_cast<double>(whole.width), static_cast<double>(whole.height)},
                 {paper, 1.0});
  double y = 38.0;
  for (const std::string& line : heading) {
    write_fitted(font, sheet, {static_cast<double>(gap), y}, line, heading_letters, room, ink);
    y += heading_line;
  }
  constexpr double swatch = 34.0;
  draw_line(sheet, {gap + 2.0, y - 7.0}, {gap + swatch, y - 7.0}, exact_width, {exact_colour, 1.0});
  write_fitted(font, sheet, {gap + swatch + 10.0, y},
               fmt::format("the exact shape, behind what {} settles to at {:.6g} steps/s",
                           study.settings.method, study.settings.steps_per_second()),
               small_letters, room - swatch - 10.0, ink);
  const std::vector<Index> links = drawn_links(scene.model);
  const Image backdrop = backdrop_of(posed, settings);
  const Image lines = exact_lines(posed, study.exact.state, links, backdrop);
  Painter painter(posed, settings);
  for (int i = 0; i < count; ++i) {
    const auto& [state, caption] = panels[static_cast<std::size_t>(i)];
    Image picture = painter.draw(*state, nullptr, i == 0);
    show_behind(backdrop, lines, picture);
    const int left = gap + (i % columns) * (panel.width + gap);
    const int top = heading_height + (i / columns) * (panel.height + caption_height);
    place_image(sheet, left, top, picture);
    write_caption(font, caption, left, top + panel.height, panel.width, sheet);
  }
  return sheet;
}

}  // namespace taut
