// Shadows on cloth and solids, as wide at their edges as what throws them is far off.

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/palette.h"
#include "small_scenes.h"

namespace taut {
namespace {

using testing::bare_look;
using testing::channel_at;
using testing::draw_once;

constexpr Size wide_picture{640, 360};

double linear_green(const Image& image, const CameraPose& pose, const Vec3& place) {
  const Vec3 at = picture_position(pose, wide_picture.width, wide_picture.height, place);
  const double displayed = channel_at(image, static_cast<int>(at.x()), static_cast<int>(at.y()), 1);
  const double square = displayed * displayed / 65025.0;
  return square / (1.0 - 0.12 * square);  // see shaders/lighting.glsl
}

enum class Receiver { box, cloth };

// A thin plate that ends at x = −1, so high over something level at y = 0 on which the shadow's edge falls.
Built plate_over(Receiver receiver, double height, const Vec3& edge) {
  Description description;
  if (receiver == Receiver::cloth) {
    SheetSpec sheet;
    sheet.name = "cloth";
    sheet.rows = sheet.columns = 21;
    sheet.from = edge + Vec3(-0.6, 0.0, -0.6);
    sheet.to = edge + Vec3(0.6, 0.0, -0.6);
    sheet.down = {0.0, 0.0, 1.2};
    description.sheets = {sheet};
  } else {
    MassSpec mass;
    mass.name = "far";
    mass.position = edge + Vec3(0.5, 0.02, 0.5);
    mass.radius = 0.01;
    description.masses.push_back(mass);
    BoxSpec box;
    box.centre = edge + Vec3(0.0, -0.1, 0.0);
    box.size = {1.2, 0.2, 1.2};
    description.boxes.push_back(box);
  }
  BoxSpec plate;
  plate.centre = {-0.4, height, 0.0};
  plate.size = {1.2, 0.002, 2.0};
  description.boxes.push_back(plate);
  return build(description);
}

// How far it is (m) from where a tenth of the light is missing to where nine tenths are.
double penumbra_on(Receiver receiver, double height, double inside) {
  const glm::vec3 light = direction_to_light();
  const Vec3 edge(-1.0 - double(light.x / light.y) * height, 0.0, -double(light.z / light.y) * height);
  const CameraPose pose{edge + Vec3(0.0, 1.2, 1e-3), edge, 38.0};
  const Built scene = plate_over(receiver, height, edge);
  Look look = bare_look();
  look.surface = receiver == Receiver::cloth;
  look.pattern = Pattern::plain;
  const auto drawn = [&](bool shadows) {
    look.shadows = shadows;
    const RenderSettings settings{
        .size = wide_picture, .samples = 4, .shadow_map_size = 2048, .transparent = false};
    return draw_once(scene.model, scene.start, look, settings, pose);
  };
  const Image lit = drawn(false), shaded = drawn(true);
  const auto missing = [&](double x) {
    const Vec3 place = edge + Vec3(x, 0.0, 0.05);
    return 1.0 - linear_green(shaded, pose, place) / linear_green(lit, pose, place);
  };
  const double whole = missing(inside);
  EXPECT_GT(whole, 0.2);
  double dark = 0.0, bright = 0.0;
  for (double x = -inside; x < inside; x += 0.0005) {
    if (missing(x) / whole < 0.1) bright = x;
    if (missing(x) / whole < 0.9) dark = x;
  }
  return dark - bright;
}

void expect_wider_from_afar(Receiver receiver) {
  const double near = penumbra_on(receiver, 0.1, 0.05), far = penumbra_on(receiver, 1.2, 0.12);
  EXPECT_LT(near, 0.02);
  EXPECT_GT(far, 2.5 * near);
  // As tests of grounds reckon it.
  const glm::vec3 light = direction_to_light();
  const double stretch = std::hypot(1.0, double(light.x / light.y));
  const double expected = 2.0 * 0.687 * double(light_spread) * 1.2 / double(light.y) * stretch;
  EXPECT_NEAR(far / expected, 1.0, 0.3);
}

TEST(SoftShadow, OnABoxIsTheWiderTheFartherOffWhatThrowsIt) {
  expect_wider_from_afar(Receiver::box);
}

TEST(SoftShadow, OnClothIsTheWiderTheFartherOffWhatThrowsIt) {
  expect_wider_from_afar(Receiver::cloth);
}

}  // namespace
}  // namespace taut
