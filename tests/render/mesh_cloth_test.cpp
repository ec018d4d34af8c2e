// Meshes as cloth: that every triangle is drawn once, rounded or not, that tears part it and lose none of it,
// and that its light goes with it.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <span>

#include "geometry/geometry.h"
#include "mesh_texts.h"
#include "model/description.h"
#include "small_scenes.h"

namespace taut {
namespace {

using testing::bare_look;
using testing::straight_on;

constexpr int rows = 5, columns = 7;
constexpr double step = 0.3;  // m

// Upright and flat, beside an ordinary sheet; of quads, or of their halves.
Built scene_of(bool quads) {
  std::string text = testing::grid_obj(rows, columns, step);
  if (!quads) {
    text = text.substr(0, text.find("f "));
    for (int row = 0; row + 1 < rows; ++row)
      for (int column = 0; column + 1 < columns; ++column) {
        const int corner = row * columns + column + 1;
        text += fmt::format("f {} {} {}\nf {} {} {}\n", corner, corner + columns, corner + 1, corner + 1,
                            corner + columns, corner + columns + 1);
      }
  }
  const testing::MeshFiles files;
  MeshSpec mesh;
  mesh.name = "mesh";
  mesh.file = "grid.obj";
  mesh.position = {-0.9, 0.6, 0.0};
  mesh.data = files.read("grid.obj", text, mesh).data;
  SheetSpec sheet;
  sheet.name = "sheet";
  sheet.rows = sheet.columns = 3;
  sheet.from = {-0.5, 1.5, -0.5};
  sheet.to = {0.5, 1.5, -0.5};
  sheet.down = {0.0, -0.5, 0.0};
  Description description;
  description.sheets = {sheet};
  description.meshes = {mesh};
  Built built = build(description);
  EXPECT_TRUE(built.problems.empty());
  return built;
}

Look mesh_look() {
  Look look = bare_look();
  look.surface = true;
  return look;
}

// A metre is so many pixels.
std::shared_ptr<const Geometry> geometry_at(const Built& scene, int pixels_a_metre,
                                            const Look& look = mesh_look()) {
  const double height = 5.0 * 2.0 * std::tan(19.0 * 3.14159265358979 / 180.0) * pixels_a_metre;
  const Sight sight{straight_on(), Size{16, static_cast<int>(std::lround(height))}};
  GeometryMaker maker(scene.model, scene.start, look, sight);
  return maker.make(scene.start, sight.pose);
}

double area_of(const SurfaceMesh& mesh) {
  double area = 0.0;
  const std::vector<Index>& corners = *mesh.indices;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const glm::vec3 a = mesh.vertices[corners[i]].position;
    area += 0.5 * glm::length(glm::cross(mesh.vertices[corners[i + 1]].position - a,
                                         mesh.vertices[corners[i + 2]].position - a));
  }
  return area;
}

const double whole_area = step * step * (rows - 1) * (columns - 1) + 0.5;

const Sheet& mesh_in(const Built& scene) {
  return scene.model.sheets.back();
}

TEST(MeshCloth, IsDrawnOnceFlatOrInParts) {
  for (const bool quads : {true, false})
    for (const int pixels : {1, 2000}) {
      const Built scene = scene_of(quads);
      const auto geometry = geometry_at(scene, pixels);
      const SurfaceMesh& surface = geometry->surface;
      EXPECT_NEAR(area_of(surface), whole_area, 1e-4);
      EXPECT_EQ(surface.vertices.size(), surface.places->size());
      for (const SurfaceVertex& vertex : surface.vertices) {
        EXPECT_NEAR(glm::length(vertex.normal), 1.0F, 1e-5F);
        EXPECT_NEAR(std::abs(vertex.normal.z), 1.0F, 1e-4F);  // flat, and rounding keeps it so
      }
      for (const Index corner : *surface.indices) ASSERT_LT(corner, surface.vertices.size());
    }
}

// Whatever tears, all of it is still there, each corner with what is around it.
TEST(MeshCloth, TearsLoseNoneOfIt) {
  for (const bool quads : {true, false})
    for (const int pixels : {1, 2000})
      for (const int percent : {5, 30, 100}) {
        Built scene = scene_of(quads);
        const Sheet mesh = mesh_in(scene);
        for (Index link = mesh.first_link; link < mesh.first_link + mesh.link_count; ++link)
          if (50.0F + 50.0F * jitter(link, 77) < static_cast<float>(percent))
            scene.start.broken_at[link] = 0.0;
        const auto geometry = geometry_at(scene, pixels);
        EXPECT_NEAR(area_of(geometry->surface), whole_area, 0.02 * whole_area) << quads << pixels << percent;
        for (const SurfaceVertex& vertex : geometry->surface.vertices) {
          EXPECT_TRUE(std::isfinite(vertex.position.x + vertex.normal.x + vertex.open.x));
          EXPECT_NEAR(std::abs(vertex.normal.z), 1.0F, 1e-3F);
        }
      }
}

// Torn between two columns and pulled apart: nothing is drawn in between.
TEST(MeshCloth, TearsPartIt) {
  for (const bool quads : {true, false}) {
    Built scene = scene_of(quads);
    const Sheet mesh = mesh_in(scene);
    const auto column_of = [&](Index mass) { return (mass - mesh.first_mass) % columns; };
    for (Index link = mesh.first_link; link < mesh.first_link + mesh.link_count; ++link)
      if ((column_of(scene.model.links.a[link]) <= 2) != (column_of(scene.model.links.b[link]) <= 2))
        scene.start.broken_at[link] = 0.0;
    constexpr double apart = 4.0;
    Vectors& position = scene.start.position;
    for (Index mass = mesh.first_mass; mass < mesh.first_mass + mesh.mass_count; ++mass)
      if (column_of(mass) > 2) position.set(mass, position.at(mass) + Vec3(apart, 0.0, 0.0));
    // The start of the maker is torn already and pulled apart, so it is told of the true one.
    Built before = scene_of(quads);
    const Sight sight{straight_on(), Size{16, 9}};
    GeometryMaker maker(before.model, before.start, mesh_look(), sight);
    const auto geometry = maker.make(scene.start, sight.pose);
    EXPECT_NEAR(area_of(geometry->surface), whole_area, 0.02 * whole_area);
    const double left = -0.9 + 2 * step, right = -0.9 + 3 * step + apart;
    const Vec3 eye = sight.pose.eye;
    const std::size_t of_sheet = 9;
    for (const SurfaceVertex& vertex : std::span(geometry->surface.vertices).subspan(of_sheet)) {
      const double x = vertex.position.x + eye.x();
      EXPECT_TRUE(x < left + step || x > right - step) << x;
    }
  }
}

TEST(MeshCloth, HasAPlaceOfItsOwnForLight) {
  for (const int pixels : {1, 2000}) {
    Built scene = scene_of(false);
    scene.start.broken_at[mesh_in(scene).first_link + 3] = 0.0;
    const auto geometry = geometry_at(scene, pixels);
    const SurfaceMesh& surface = geometry->surface;
    const glm::mat4 same(1.0F);
    const std::vector<glm::vec4> light = light_places(surface, same, glm::vec3(0, 0, 1), 0.0F);
    const auto width = static_cast<std::size_t>(surface.spread->places.width);
    // What a vertex of a whole triangle looks up was worked out for its own place.
    std::size_t same_place = 0;
    for (std::size_t i = 0; i < surface.vertices.size(); ++i) {
      const glm::vec2 at = (*surface.places)[i].light;
      const glm::vec4 found =
          light.at(static_cast<std::size_t>(at.y) * width + static_cast<std::size_t>(at.x));
      if (glm::length(glm::vec3(found) - surface.vertices[i].position) < 1e-5F) ++same_place;
      EXPECT_LT(glm::length(glm::vec3(found) - surface.vertices[i].position), 0.8 * step);
    }
    EXPECT_GT(same_place, surface.vertices.size() * 8 / 10);
  }
}

TEST(MeshCloth, HasItsOwnColourAndCanBeHidden) {
  const Built scene = scene_of(true);
  Look look = mesh_look();
  look.objects.meshes = {ObjectLook{}};
  look.objects.meshes[0].colour = Colour{0.0, 1.0, 0.0};
  const auto green = geometry_at(scene, 1, look);
  const std::size_t of_sheet = 9;
  ASSERT_EQ(green->surface.tints.size(), green->surface.vertices.size());
  EXPECT_EQ(green->surface.tints.back().front, (Rgba{0, 255, 0, 255}));
  EXPECT_NE(green->surface.tints.front().front, (Rgba{0, 255, 0, 255}));
  look.objects.meshes[0].visible = false;
  EXPECT_EQ(geometry_at(scene, 1, look)->surface.vertices.size(), of_sheet);
}

}  // namespace
}  // namespace taut
