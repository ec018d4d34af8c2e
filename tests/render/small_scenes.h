#pragma once

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "model/description.h"
#include "render/renderer.h"

namespace taut::testing {

/// Of small pictures.
inline constexpr Size size{320, 180};

inline std::string mass_name(std::size_t i) {
  return std::string("m").append(std::to_string(i));
}

/// Masses of the given places, the first pinned, each linked to the next.
inline Built row_of_masses(const std::vector<Vec3>& positions) {
  Description description;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    MassSpec mass;
    mass.name = mass_name(i);
    mass.position = positions[i];
    mass.pinned = i == 0;
    description.masses.push_back(mass);
    if (i > 0) {
      LinkSpec link;
      link.a = mass_name(i - 1);
      link.b = mass.name;
      description.links.push_back(link);
    }
  }
  return build(description);
}

/// A sheet in the plane z = 0, from y = 1 down to y = −1 and x from −1 to 1.
inline Built upright_sheet(int rows, int columns) {
  Description description;
  SheetSpec sheet;
  sheet.name = "cloth";
  sheet.rows = rows;
  sheet.columns = columns;
  sheet.from = {-1.0, 1.0, 0.0};
  sheet.to = {1.0, 1.0, 0.0};
  sheet.down = {0.0, -2.0, 0.0};
  sheet.pinned = {"top"};
  description.sheets.push_back(sheet);
  return build(description);
}

/// The same with folds, deeper towards its foot.
inline Built folded_sheet(int rows, int columns) {
  Built built = upright_sheet(rows, columns);
  for (std::size_t i = 0; i < built.model.masses.size(); ++i) {
    const Vec3 flat = built.start.position.at(i);
    const double depth = 0.06 * (1.5 - flat.y());
    built.start.position.set(i, flat + Vec3(0.0, 1.3, depth * std::sin(2.5 * std::numbers::pi * flat.x())));
  }
  return built;
}

/// Something of all that is drawn: masses, links, cloth, a body, solids.
inline Built all_kinds() {
  Description description;
  for (int i = 0; i < 8; ++i) {
    MassSpec mass;
    mass.name = mass_name(static_cast<std::size_t>(i));
    mass.position = {-1.3 + 0.15 * i, 1.4 - 0.1 * i, 0.3};
    mass.pinned = i == 0;
    description.masses.push_back(mass);
    if (i == 0) continue;
    LinkSpec link;
    link.a = mass_name(static_cast<std::size_t>(i - 1));
    link.b = mass.name;
    description.links.push_back(link);
  }
  SheetSpec sheet;
  sheet.name = "cloth";
  sheet.rows = sheet.columns = 6;
  sheet.from = {0.2, 1.7, -0.4};
  sheet.to = {1.2, 1.7, 0.0};
  sheet.down = {0.1, -0.8, 0.3};
  sheet.pinned = {"top"};
  description.sheets.push_back(sheet);
  RagdollSpec doll;
  doll.name = "doll";
  doll.position = {0.9, 0.9, 0.6};
  doll.height = 1.0;
  description.ragdolls.push_back(doll);
  BoxSpec box;
  box.centre = {-0.6, 0.3, -0.2};
  box.size = {0.5, 0.6, 0.4};
  box.turn = {10.0, 30.0, 0.0};
  description.boxes.push_back(box);
  description.capsules = {CapsuleSpec{{0.1, 0.2, 0.5}, {0.3, 0.4, 0.1}, 0.12, 0.5, 0.0}};
  return build(description);
}

/// Looking along −z from 5 m away.
inline CameraPose straight_on() {
  return {{0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}, 38.0};
}

/// Nothing but what a test asks for.
inline Look bare_look() {
  Look look;
  look.masses = look.links = look.ground = look.shadows = look.supports = false;
  return look;
}

inline RenderSettings cut_out(Size picture) {
  return {.size = picture, .samples = 4, .shadow_map_size = 0, .transparent = true};
}

/// Draws states of a model.
class StatePainter {
 public:
  StatePainter(const Built& scene, const Look& look, const RenderSettings& settings, const GlChoice& gl = {})
      : context_(make_gl_context(gl)),
        maker_(scene.model, scene.start, look),
        renderer_(*context_, look, settings) {}

  Image draw(const State& state, const CameraPose& pose) {
    return flatten(*renderer_.draw(*maker_.make(state, pose)));
  }
  Renderer& renderer() { return renderer_; }
  GeometryMaker& maker() { return maker_; }

 private:
  std::unique_ptr<GlContext> context_;
  GeometryMaker maker_;
  Renderer renderer_;
};

inline Image draw_once(const Model& model, const State& state, const Look& look,
                       const RenderSettings& settings, const CameraPose& pose, const GlChoice& gl = {}) {
  const auto context = make_gl_context(gl);
  GeometryMaker maker(model, state, look);
  return flatten(*Renderer(*context, look, settings).draw(*maker.make(state, pose)));
}

/// One channel of one pixel.
inline int channel_at(const Image& image, int x, int y, int channel) {
  const int pixel = y * image.size.width + x;
  return image.pixels[static_cast<std::size_t>(pixel * image.channels + channel)];
}

}  // namespace taut::testing
