// Cloth: that tears part it and lose none of it, that smooth curves go where they should, and what lies on
// it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/fineness.h"
#include "geometry/geometry.h"
#include "geometry/palette.h"
#include "geometry/surface_topology.h"
#include "geometry/tears.h"
#include "small_scenes.h"

namespace taut {
namespace {

using testing::bare_look;
using testing::channel_at;
using testing::cut_out;
using testing::draw_once;
using testing::size;
using testing::straight_on;
using testing::upright_sheet;

Look cloth_look() {
  Look look = bare_look();
  look.surface = true;
  return look;
}

// A picture in which a metre is so many pixels.
Sight sight_of(int pixels_a_metre) {
  const double height = 5.0 * 2.0 * std::tan(19.0 * std::numbers::pi / 180.0) * pixels_a_metre;
  return {straight_on(), Size{16, static_cast<int>(std::lround(height))}};
}

// As coarse as the masses, and in parts.
const std::array<Sight, 2> sights{sight_of(1), sight_of(2000)};

std::shared_ptr<const Geometry> geometry_at(const Built& scene, const Sight& sight) {
  return GeometryMaker(scene.model, scene.start, cloth_look(), sight).make(scene.start, sight.pose);
}

// A sheet of which so many in a hundred links are broken.
Built riddled_sheet(Index percent) {
  Built scene = upright_sheet(9, 12);
  for (Index link = 0; link < scene.model.links.size(); ++link)
    if (50.0F + 50.0F * jitter(link, 77) < static_cast<float>(percent)) scene.start.broken_at[link] = 0.0;
  return scene;
}

// A sheet torn in two between its columns 2 and 3, so far apart (m).
Built parted_sheet(double apart) {
  Built scene = upright_sheet(6, 6);
  const SheetLattice sheet = sheet_lattices(scene.model).front();
  for (Index row = 0; row < sheet.rows; ++row) {
    scene.start.broken_at[sheet.link_across(row, 2)] = 0.0;
    for (Index column = 3; column < sheet.columns; ++column)
      scene.start.position.add(sheet.mass(row, column), {apart, 0.0, 0.0});
  }
  return scene;
}

// Calls visit(numbers of the corners) for each triangle.
template <typename Visit>
void for_each_triangle(const SurfaceMesh& mesh, const Visit& visit) {
  for (std::size_t i = 0; i < mesh.indices->size(); i += 3)
    visit((*mesh.indices)[i], (*mesh.indices)[i + 1], (*mesh.indices)[i + 2]);
}

TEST(Tears, LoseNothingOfTheCloth) {
  for (const Index percent : {0U, 3U, 30U, 80U, 101U}) {
    for (const Sight& sight : sights) {
      const auto geometry = geometry_at(riddled_sheet(percent), sight);
      const SurfaceMesh& mesh = geometry->surface;
      ASSERT_EQ(mesh.places->size(), mesh.vertices.size());
      double drawn = 0.0, turned_over = 0.0, seen = 0.0;
      for_each_triangle(mesh, [&](Index a, Index b, Index c) {
        const glm::vec2 ab = (*mesh.places)[b].pattern - (*mesh.places)[a].pattern;
        const glm::vec2 ac = (*mesh.places)[c].pattern - (*mesh.places)[a].pattern;
        const double area = 0.5 * static_cast<double>(ab.y * ac.x - ab.x * ac.y);
        (area >= -1e-6 ? drawn : turned_over) += area;
        const glm::vec3 at = mesh.vertices[a].position;
        seen += 0.5 * static_cast<double>(glm::length(
                          glm::cross(mesh.vertices[b].position - at, mesh.vertices[c].position - at)));
      });
      EXPECT_EQ(turned_over, 0.0) << percent << " % broken";
      // The pattern has eighty threads along the shorter side, and the sheet is 2 m by 2 m.
      EXPECT_NEAR(drawn, 80.0 * 80.0, 0.5) << percent << " % broken";
      EXPECT_NEAR(seen, 4.0, 0.04) << percent << " % broken";
    }
  }
}

TEST(Tears, BothSidesFitWhereNothingHasMovedYet) {
  const Built scene = riddled_sheet(30);
  const Cloth cloth = cloth_of(scene.model, scene.start, cloth_look(), 1.0F);
  const auto topology = surface_topology(cloth, scene.start);
  ASSERT_GT(topology->edges.size(), 60U);
  const std::vector<glm::vec3> places = places_of_tears(*topology, cloth.at_start, glm::mat3(1.0F));
  for (std::size_t i = 0; i < topology->edges.size(); i += 2)
    EXPECT_LT(glm::distance(places[i], places[i + 1]), 1e-5F) << i;
}

TEST(Tears, AreBridgedByNothing) {
  constexpr float cell = 0.4F;  // m
  for (const Sight& sight : sights) {
    float longest = 0.0F;
    const auto geometry = geometry_at(parted_sheet(3.0), sight);
    const SurfaceMesh& mesh = geometry->surface;
    for_each_triangle(mesh, [&](Index a, Index b, Index c) {
      for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
        longest = std::max(longest, glm::distance(mesh.vertices[from].position, mesh.vertices[to].position));
    });
    EXPECT_LT(longest, 1.5F * cell);
    EXPECT_GT(longest, 0.2F * cell);
  }
}

TEST(Tears, AScrapThatIsAloneKeepsItsSize) {
  Built scene = upright_sheet(3, 3);
  const SheetLattice sheet = sheet_lattices(scene.model).front();
  for (const Index link :
       {sheet.link_across(1, 0), sheet.link_across(1, 1), sheet.link_down(0, 1), sheet.link_down(1, 1)})
    scene.start.broken_at[link] = 0.0;
  GeometryMaker maker(scene.model, scene.start, cloth_look());
  State moved = scene.start;
  moved.position.add(sheet.mass(1, 1), {0.3, -0.2, 2.0});
  const auto geometry = maker.make(moved, straight_on());
  double area = 0.0;  // m², of what is far in front
  for_each_triangle(geometry->surface, [&](Index a, Index b, Index c) {
    const auto at = [&](Index i) { return geometry->surface.vertices[i].position; };
    const auto in_front = [&](Index i) { return at(i).z > -4.0F; };
    EXPECT_EQ(in_front(a), in_front(b));
    EXPECT_EQ(in_front(a), in_front(c));
    if (in_front(a)) area += 0.5 * static_cast<double>(glm::length(glm::cross(at(b) - at(a), at(c) - at(a))));
  });
  EXPECT_NEAR(area, 1.0, 0.1) << "a cell of 1 m by 1 m";
}

TEST(Tears, ShowWhatIsBehind) {
  const Image whole =
      draw_once(parted_sheet(0.0).model, parted_sheet(0.0).start, cloth_look(), cut_out(size), straight_on());
  const Built scene = parted_sheet(0.8);
  const Image torn = draw_once(scene.model, scene.start, cloth_look(), cut_out(size), straight_on());
  // The tear runs down the middle of the sheet, where x = 0; its right side has gone to x = 0.8.
  for (const double y : {-0.6, 0.0, 0.6}) {
    const Vec3 middle = picture_position(straight_on(), size.width, size.height, {0.4, y, 0.0});
    EXPECT_EQ(channel_at(torn, static_cast<int>(middle.x()), static_cast<int>(middle.y()), 3), 0);
    EXPECT_EQ(channel_at(whole, static_cast<int>(middle.x()), static_cast<int>(middle.y()), 3), 255);
    for (const double x : {-0.12, 0.92}) {
      const Vec3 cloth = picture_position(straight_on(), size.width, size.height, {x, y, 0.0});
      EXPECT_EQ(channel_at(torn, static_cast<int>(cloth.x()), static_cast<int>(cloth.y()), 3), 255) << x;
    }
  }
}

TEST(Tears, AreLitAsTheClothTheyBelongTo) {
  for (const Sight& sight : sights) {
    const auto geometry = geometry_at(parted_sheet(3.0), sight);
    const SurfaceMesh& mesh = geometry->surface;
    const auto width = static_cast<std::size_t>(mesh.spread->places.width);
    // Where light is looked up for a vertex, between the four places around.
    const auto looked_up = [&](const glm::vec2& light) {
      const glm::vec2 low = glm::min(
          glm::floor(light), glm::vec2(mesh.spread->places.width - 2, mesh.spread->places.height - 2));
      const glm::vec2 share = light - low;
      const auto at = [&](std::size_t right, std::size_t down) {
        return mesh
            .vertices[(static_cast<std::size_t>(low.y) + down) * width + static_cast<std::size_t>(low.x) +
                      right]
            .position;
      };
      return glm::mix(glm::mix(at(0, 0), at(1, 0), share.x), glm::mix(at(0, 1), at(1, 1), share.x), share.y);
    };
    for_each_triangle(mesh, [&](Index a, Index b, Index c) {
      for (const Index vertex : {a, b, c})
        EXPECT_LT(glm::distance(looked_up((*mesh.places)[vertex].light), mesh.vertices[vertex].position),
                  0.4F)
            << vertex;
    });
  }
}

TEST(LooseThreads, HangFromBrokenLinksOnly) {
  const auto whole = geometry_at(parted_sheet(0.0), sights[0]);
  Built unbroken = parted_sheet(0.0);
  std::ranges::fill(unbroken.start.broken_at, infinity);
  EXPECT_TRUE(geometry_at(unbroken, sights[0])->links.empty());
  Built apart = parted_sheet(3.0);
  const auto torn = geometry_at(apart, sights[0]);
  ASSERT_FALSE(torn->links.empty());
  EXPECT_EQ(torn->links.size(), whole->links.size()) << "as many, wherever the parts are";
  int beside = 0;
  float sag = 0.0F;  // m, of all pieces
  for (const RodRecord& piece : torn->links) {
    sag += piece.start.y - piece.end.y;
    // The tear is half a cell of 0.4 m from either side's masses: around x = 0 and x = 3.
    if (std::min(std::abs(piece.start.x), std::abs(piece.start.x - 3.0F)) > 1.2F) ++beside;
  }
  EXPECT_EQ(beside, 0);
  EXPECT_GT(sag, 0.0F) << "they hang down";
}

TEST(SurfaceMesh, SharesWhatHasNotChanged) {
  Built scene = upright_sheet(5, 5);
  GeometryMaker maker(scene.model, scene.start, cloth_look());
  const auto first = maker.make(scene.start, straight_on()), second = maker.make(scene.start, straight_on());
  EXPECT_EQ(first->surface.indices, second->surface.indices);
  EXPECT_EQ(first->surface.places, second->surface.places);
  scene.start.broken_at[8] = 0.0;
  const auto torn = maker.make(scene.start, straight_on());
  EXPECT_NE(torn->surface.indices, first->surface.indices);
  EXPECT_GT(torn->surface.vertices.size(), first->surface.vertices.size());
}

TEST(SpreadSheets, HaveAPlaceForEachVertexOfEachSheet) {
  Description description;
  for (int i = 0; i < 2; ++i) {
    SheetSpec sheet;
    sheet.name = std::string("cloth").append(std::to_string(i));
    sheet.rows = 3 + i;
    sheet.columns = 4 + 2 * i;
    sheet.from = {0.0, 1.0, static_cast<double>(i)};
    sheet.to = {3.0, 1.0, static_cast<double>(i)};
    sheet.down = {0.0, -1.0, 0.0};
    description.sheets.push_back(sheet);
  }
  const Built scene = build(description);
  const Cloth cloth = cloth_of(scene.model, scene.start, cloth_look(), 12.0F);
  ASSERT_EQ(cloth.fineness, (Fineness{2, 1})) << "cells of 12 by 6 pixels";
  EXPECT_EQ(cloth.spread->places.width, 11);
  EXPECT_EQ(cloth.spread->places.height, 7);
  EXPECT_FLOAT_EQ(cloth.spread->cell_size.x, 0.5F);
  EXPECT_FLOAT_EQ(cloth.spread->cell_size.y, 0.5F);
  std::vector<std::pair<float, float>> places;
  const auto topology = surface_topology(cloth, scene.start);
  for (const SurfacePlace& place : *topology->places) places.emplace_back(place.light.x, place.light.y);
  EXPECT_EQ(places.size(), 3U * 7U + 4U * 11U);
  std::ranges::sort(places);
  EXPECT_EQ(std::ranges::adjacent_find(places), places.end()) << "two in one place";
}

TEST(LightPlaces, AreLiftedTowardsTheSideThatIsLit) {
  const auto geometry = geometry_at(upright_sheet(3, 3), sights[1]);
  const SurfaceMesh& mesh = geometry->surface;
  const glm::vec3 to_light = direction_to_light();
  const float texel = 0.01F;
  for (const glm::vec3& light : {to_light, -to_light}) {
    const std::vector<glm::vec4> places = light_places(mesh, glm::mat4(1.0F), light, texel);
    ASSERT_EQ(places.size(), 81U);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      const glm::vec2& at = (*mesh.places)[i].light;
      const glm::vec3 lifted =
          glm::vec3(places[static_cast<std::size_t>(9.0F * at.y + at.x)]) - mesh.vertices[i].position;
      EXPECT_GT(glm::dot(lifted, light), texel) << i;
      EXPECT_LT(glm::length(lifted), 2.6F * texel) << i;
    }
  }
}

TEST(Fineness, FollowsTheSizeInThePictureEachWay) {
  const std::vector<SheetLattice> sheets = sheet_lattices(upright_sheet(61, 121).model);  // 2/120 by 2/60 m
  EXPECT_EQ(fineness_for(sheets, 500.0F), (Fineness{1, 1}));
  EXPECT_EQ(fineness_for(sheets, 600.0F), (Fineness{1, 2}));
  EXPECT_EQ(fineness_for(sheets, 1500.0F), (Fineness{2, 4}));
  EXPECT_EQ(fineness_for(sheets, 50000.0F), (Fineness{4, 4}));
  // Smaller ones are drawn finer.
  EXPECT_EQ(fineness_for(sheet_lattices(upright_sheet(13, 25).model), 110.0F), (Fineness{2, 2}));
  // Not more vertices than anyone could see, however near the eye.
  const std::vector<SheetLattice> large = sheet_lattices(upright_sheet(400, 400).model);
  const Fineness fineness = fineness_for(large, 1e6F);
  EXPECT_LT(fine_size(large[0], fineness).x * fine_size(large[0], fineness).y, 400'001U);
}

// A sheet bent round a pole of 1 m: rows go round it.
std::vector<glm::vec3> bent(const SheetLattice& sheet) {
  std::vector<glm::vec3> places;
  for (Index row = 0; row < sheet.rows; ++row)
    for (Index column = 0; column < sheet.columns; ++column) {
      const float angle = 0.5F * static_cast<float>(column);
      places.emplace_back(std::sin(angle), -0.3F * static_cast<float>(row), std::cos(angle));
    }
  return places;
}

TEST(SmoothPlaces, LieOnTheCurveThatMassesLieOn) {
  const Built scene = upright_sheet(4, 7);
  const SheetLattice sheet = sheet_lattices(scene.model).front();
  const std::vector<bool> whole(scene.model.links.size(), false);
  const std::vector<glm::vec3> masses = bent(sheet);
  const std::vector<glm::vec3> places = smooth_places(sheet, {4, 2}, whole, masses);
  ASSERT_EQ(places.size(), 25U * 7U);
  for (std::size_t y = 0; y < 7; ++y)
    for (std::size_t x = 0; x < 25; ++x) {
      const glm::vec3& place = places[y * 25 + x];
      if (x % 4 == 0 && y % 2 == 0) {
        EXPECT_LT(glm::distance(place, masses[y / 2 * 7 + x / 4]), 1e-6F);
      }
      EXPECT_NEAR(place.y, -0.15F * static_cast<float>(y), 1e-5F);
      // The middle of a chord is 0.031 m inside; at the ends of a row the curve knows one side only.
      const bool inner = x >= 4 && x <= 20;
      EXPECT_NEAR(std::hypot(place.x, place.z), 1.0F, inner ? 0.003F : 0.02F) << x << ", " << y;
    }
}

TEST(SmoothPlaces, KnowNothingOfWhatIsBeyondATear) {
  const Built scene = upright_sheet(4, 7);
  const SheetLattice sheet = sheet_lattices(scene.model).front();
  std::vector<bool> broken(scene.model.links.size(), false);
  for (Index row = 0; row < 4; ++row) broken[sheet.link_across(row, 3)] = true;
  std::vector<glm::vec3> masses = bent(sheet);
  const auto before = smooth_places(sheet, {2, 2}, broken, masses);
  for (Index row = 0; row < 4; ++row)
    for (Index column = 4; column < 7; ++column) masses[row * 7 + column].y += 5.0F;
  const auto after = smooth_places(sheet, {2, 2}, broken, masses);
  for (std::size_t y = 0; y < 7; ++y)
    for (std::size_t x = 0; x <= 6; ++x)
      EXPECT_LT(glm::distance(before[y * 13 + x], after[y * 13 + x]), 1e-6F) << x << ", " << y;
}

// Mean and standard deviation of a channel over the middle of a picture.
std::pair<double, double> brightness(const Image& image) {
  double sum = 0.0, squares = 0.0;
  int count = 0;
  for (int y = size.height / 2 - 30; y < size.height / 2 + 30; ++y)
    for (int x = size.width / 2 - 30; x < size.width / 2 + 30; ++x, ++count) {
      const double value = channel_at(image, x, y, 0);
      sum += value;
      squares += value * value;
    }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(squares / count - mean * mean, 0.0))};
}

TEST(Weave, ThreadsTooFineToSeeAreTheirMean) {
  const Built scene = upright_sheet(5, 5);
  const auto drawn = [&](Pattern pattern, double pitch) {
    Look look = cloth_look();
    look.pattern = pattern;
    look.thread_pitch = pitch;
    return brightness(draw_once(scene.model, scene.start, look, cut_out(size), straight_on()));
  };
  // A pixel is 0.019 m wide.
  const auto plain = drawn(Pattern::plain, 0.0);
  const auto coarse = drawn(Pattern::woven, 0.16);
  EXPECT_GT(coarse.second, 10.0) << "threads are seen";
  for (const double pitch : {0.03, 0.019, 0.0187, 0.01, 0.001}) {
    const auto fine = drawn(Pattern::woven, pitch);
    EXPECT_NEAR(fine.first, plain.first, 3.0) << pitch;
    EXPECT_LT(fine.second, plain.second + 1.0) << pitch << ": no moiré";
  }
  EXPECT_NEAR(coarse.first, plain.first, 8.0) << "as bright on the whole";
}

TEST(Hem, RunsAlongTheBorderOnly) {
  const Built scene = upright_sheet(5, 5);
  const auto drawn = [&](double width) {
    Look look = cloth_look();
    look.hem_width = width;
    return draw_once(scene.model, scene.start, look, cut_out(size), straight_on());
  };
  const Image none = drawn(0.0), hemmed = drawn(0.25);
  int at_border = 0, inside = 0;
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      if (channel_at(none, x, y, 3) != 255 || channel_at(none, x, y, 0) == channel_at(hemmed, x, y, 0))
        continue;
      const double metre = 2.0 * 5.0 * std::tan(19.0 * std::numbers::pi / 180.0) / size.height;
      const double right = std::abs(x + 0.5 - 0.5 * size.width) * metre,
                   up = std::abs(y + 0.5 - 0.5 * size.height) * metre;
      (std::max(right, up) > 0.70 ? at_border : inside) += 1;
    }
  EXPECT_GT(at_border, 1000);
  EXPECT_EQ(inside, 0);
}

}  // namespace
}  // namespace taut
