// How much light from all around reaches cloth past what is near it.

#include "geometry/openness.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "geometry/occluders.h"

namespace taut {
namespace {

constexpr float spacing = 0.05F, reach = 0.2F;  // m

// Sheets of masses, and what openness_of() takes of them.
struct Masses {
  std::vector<Index> triangles, groups;
  std::vector<glm::vec3> places, normals;

  ClothMasses cloth() const { return {triangles, places, normals, groups}; }
};

// Adds a sheet of 21 × 21 masses around the y axis; `place` says where each is, by its way from the middle
// (m).
template <typename Place>
void add_sheet_of(Masses& masses, const Place& place) {
  constexpr Index side = 21;
  const auto first = static_cast<Index>(masses.places.size());
  for (Index row = 0; row < side; ++row)
    for (Index column = 0; column < side; ++column) {
      const glm::vec2 way = spacing * (glm::vec2(column, row) - 0.5F * static_cast<float>(side - 1));
      const glm::vec3 along = place(way + glm::vec2(1e-3F, 0.0F)) - place(way);
      const glm::vec3 across = place(way + glm::vec2(0.0F, 1e-3F)) - place(way);
      masses.places.push_back(place(way));
      masses.normals.push_back(glm::normalize(glm::cross(across, along)));
      masses.groups.push_back(first + row / 2 * 2 * side + column / 2 * 2);
      if (row == 0 || column == 0) continue;
      const Index here = first + row * side + column;
      for (const Index corner : {here - side - 1, here - 1, here, here - side - 1, here, here - side})
        masses.triangles.push_back(corner);
    }
}
constexpr std::size_t middle_mass = 220;

void add_flat(Masses& masses, float height) {
  add_sheet_of(masses, [height](const glm::vec2& way) { return glm::vec3(way.x, height, way.y); });
}

const Bodies no_bodies;
const std::vector<GroundPatch> no_grounds;

glm::vec2 in_the_middle(const Masses& masses, const Bodies& bodies = no_bodies,
                        const std::vector<GroundPatch>& grounds = no_grounds) {
  return openness_of(masses.cloth(), {bodies, grounds}, reach)[middle_mass];
}

TEST(Openness, OfAFlatSheetAloneIsWhole) {
  Masses masses;
  add_flat(masses, 0.0F);
  for (const glm::vec2& open : openness_of(masses.cloth(), {no_bodies, no_grounds}, reach)) {
    EXPECT_NEAR(open.x, 1.0F, 1e-4F);
    EXPECT_NEAR(open.y, 1.0F, 1e-4F);
  }
}

TEST(Openness, OfSheetsThatFaceEachOtherIsTheLessTheNearerTheyAre) {
  float before = 0.0F;
  for (const float apart : {0.03F, 0.05F, 0.08F, 0.14F}) {
    Masses masses;
    add_flat(masses, 0.0F);
    add_flat(masses, apart);
    const glm::vec2 open = in_the_middle(masses);
    EXPECT_GT(open.x, before) << apart;
    EXPECT_GE(open.y, 1.0F - 1e-4F) << "its other side is free";
    before = open.x;
  }
  EXPECT_LT(before, 0.99F);
  Masses touching;
  add_flat(touching, 0.0F);
  add_flat(touching, 0.01F);
  EXPECT_LT(in_the_middle(touching).x, 0.7F) << "nearer than masses are to each other";
  Masses far;
  add_flat(far, 0.0F);
  add_flat(far, reach + 1e-3F);
  EXPECT_NEAR(in_the_middle(far).x, 1.0F, 1e-4F);
}

TEST(Openness, OfFoldsIsLessInHollowsThanOnRidges) {
  for (const float depth : {0.01F, 0.03F, 0.06F}) {
    Masses masses;
    // A hollow in the middle, seen from above.
    add_sheet_of(masses, [depth](const glm::vec2& way) {
      return glm::vec3(way.x, -depth * std::cos(2.0F * std::numbers::pi_v<float> * way.x / 0.4F), way.y);
    });
    const glm::vec2 open = in_the_middle(masses);
    EXPECT_LT(open.x, 1.0F - 3.0F * depth) << depth;
    EXPECT_GT(open.y, 1.0F) << depth;
  }
}

// Clear of a box, a ball, a ground: the side that faces it is the darker the nearer it is, and from some way
// on not.
template <typename Measure>
void expect_darker_when_near(const Measure& facing) {
  float before = 0.0F;
  for (const float away : {0.002F, 0.05F, 0.1F, 0.15F, 0.19F}) {
    EXPECT_GT(facing(away), before) << away;
    before = facing(away);
  }
  EXPECT_LT(facing(0.002F), 0.4F);
  EXPECT_NEAR(facing(reach + 0.01F), 1.0F, 1e-4F);
}

TEST(Openness, IsLessBesideBoxesBallsAndGrounds) {
  Masses masses;
  add_flat(masses, 0.0F);
  expect_darker_when_near([&](float away) {
    Bodies bodies;
    bodies.boxes.push_back(
        {{0.0F, -away - 0.5F, 0.0F}, {{0.5F, 0.0F, 0.0F}, {0.0F, 0.5F, 0.0F}, {0.0F, 0.0F, 0.5F}}, {}});
    EXPECT_NEAR(in_the_middle(masses, bodies).x, 1.0F, 1e-4F);
    return in_the_middle(masses, bodies).y;
  });
  expect_darker_when_near([&](float away) {
    Bodies bodies;
    bodies.rods.push_back(
        tapered_rod({0.0, -double(away) - 0.4, 0.0}, 0.4, {0.0, -double(away) - 0.4, 0.0}, 0.4, {}));
    return in_the_middle(masses, bodies).y;
  });
  expect_darker_when_near([&](float away) {
    GroundPatch ground;
    ground.solid = true;
    ground.height = away;
    return in_the_middle(masses, no_bodies, {ground}).y;
  });
}

TEST(Occluders, HideWhatASumOverAllOfThemSays) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> any(0.0F, 1.0F);
  std::vector<glm::vec3> places(500);
  std::vector<float> areas(places.size());
  for (glm::vec3& place : places) place = {any(random), 0.3F * any(random), any(random)};
  for (float& area : areas) area = 0.01F * any(random) - 0.001F;
  // One that has fallen far away, for which there are not cells enough.
  places.back() = {0.0F, -1e4F, 0.0F};
  areas.back() = 0.01F;
  const Occluders balls(places, areas, reach);
  for (int i = 0; i < 50; ++i) {
    const glm::vec3 place = places[static_cast<std::size_t>(i)];
    const glm::vec3 normal = glm::normalize(glm::vec3(any(random), any(random), any(random)) - 0.5F);
    glm::dvec2 sum(0.0);
    for (std::size_t ball = 0; ball < places.size(); ++ball) {
      const glm::dvec3 way = glm::dvec3(places[ball]) - glm::dvec3(place);
      const double away = glm::length(way);
      if (away >= double(reach) || away == 0.0 || areas[ball] <= 0.0F) continue;
      const double near = 1.0 - away * away / double(reach * reach);
      const double covered = double(areas[ball]) / (std::numbers::pi * away * away + double(areas[ball]));
      const double share = near * near * covered * glm::dot(glm::dvec3(normal), way) / away;
      (share > 0.0 ? sum.x : sum.y) += std::abs(share);
    }
    const glm::vec2 hidden = balls.hidden(place, normal);
    EXPECT_NEAR(double(hidden.x), sum.x, 1e-4 * (1.0 + sum.x));
    EXPECT_NEAR(double(hidden.y), sum.y, 1e-4 * (1.0 + sum.y));
  }
}

}  // namespace
}  // namespace taut
