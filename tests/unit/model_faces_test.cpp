// What faces are made of, what of them is near, and what of them may not be.

#include <random>

#include "contact/face_sweep.h"
#include "model/box_tree.h"
#include "model/face_depth.h"
#include "model/face_pairs.h"
#include "model/parts.h"
#include "model/tangles.h"
#include "physics/exact_faces.h"
#include "physics/fixtures.h"

namespace taut::test {
namespace {

Vec3 random_place(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> within(-size, size);
  const double x = within(random), y = within(random);
  return {x, y, within(random)};
}

TEST(BoxTree, FindsWhatMeetsAndNothingTwice) {
  std::mt19937 random(3);
  for (const std::size_t count : {0U, 1U, 3U, 4U, 5U, 33U, 200U}) {
    std::vector<Bounds> boxes(count);
    for (Bounds& box : boxes) box.take_in(random_place(random, 1.0), std::abs(random_place(random, 0.3).x()));
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found, all;
    BoxTree tree;
    tree.fill(boxes);
    tree.visit_pairs([&](std::uint32_t i, std::uint32_t j) { found.emplace_back(i, j); });
    for (std::uint32_t i = 0; i < count; ++i)
      for (std::uint32_t j = i + 1; j < count; ++j)
        if (boxes[i].meets(boxes[j])) all.emplace_back(i, j);
    std::ranges::sort(found);
    EXPECT_EQ(found, all) << count;

    std::vector<Bounds> others(17);
    for (Bounds& box : others) box.take_in(random_place(random, 1.0), 0.1);
    BoxTree other;
    other.fill(others);
    std::size_t between = 0, met = 0;
    tree.visit_pairs(other, [&](std::uint32_t i, std::uint32_t j) {
      EXPECT_TRUE(boxes[i].meets(others[j]));
      ++between;
    });
    for (const Bounds& one : boxes)
      for (const Bounds& two : others) met += one.meets(two) ? 1U : 0U;
    EXPECT_EQ(between, met) << count;
  }
}

// The least distance between places all over both.
double sampled_distance(bool edges, const std::array<Vec3, 4>& c) {
  constexpr int steps = 60;
  double least = infinity;
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) {
      const double u = static_cast<double>(i) / steps, v = static_cast<double>(j) / steps;
      const Vec3 apart = edges ? Vec3(c[0] + u * (c[1] - c[0]) - c[2] - v * (c[3] - c[2]))
                               : Vec3(c[0] - c[1] - u * ((1.0 - v) * (c[2] - c[1]) + v * (c[3] - c[1])));
      least = std::min(least, apart.norm());
    }
  return least;
}

TEST(FaceGaps, AreTheLeastDistances) {
  std::mt19937 random(5);
  for (const bool edges : {false, true})
    for (int round = 0; round < 300; ++round) {
      std::array<Vec3, 4> corners;
      for (Vec3& corner : corners) corner = random_place(random, 1.0);
      if (round % 3 == 1) corners[3] = corners[2] + corners[1] - corners[0];  // parallel edges
      if (round % 10 == 2) corners[3] = 0.5 * (corners[1] + corners[2]);      // a triangle that is a line
      const FaceGap gap = nearest_gap(edges, corners);
      const double sampled = sampled_distance(edges, corners);
      EXPECT_LE(gap.distance, sampled + 1e-12);
      EXPECT_GT(gap.distance, sampled - 0.05);
      Vec3 apart = Vec3::Zero();
      for (std::size_t k = 0; k < 4; ++k) apart += gap.weights[k] * corners[k];
      EXPECT_LT((apart - gap.apart).norm(), 1e-12);
      EXPECT_NEAR(gap.apart.norm(), gap.distance, 1e-15);
    }
}

// Against a look at a thousand moments: no way that comes nearer is let through, and none that stays clear is
// stopped.
TEST(FaceSweeps, NeverMissAMeeting) {
  std::mt19937 random(11);
  int meetings = 0, passings = 0;
  for (const bool edges : {false, true})
    for (int round = 0; round < 400; ++round) {
      std::vector<Vec3> start(4), end(4);
      for (std::size_t k = 0; k < 4; ++k) {
        start[k] = random_place(random, 1.0);
        end[k] = start[k] + random_place(random, round % 2 == 0 ? 2.0 : 0.3);
      }
      const FacePair pair{{0, 1, 2, 3}, edges};
      const double at_start = nearest_gap(pair, start).distance, stop = 0.02;
      if (at_start <= 2.0 * stop) continue;
      double least = infinity;
      for (int moment = 0; moment <= 1000; ++moment) {
        std::array<Vec3, 4> corners;
        for (std::size_t k = 0; k < 4; ++k) corners[k] = start[k] + 0.001 * moment * (end[k] - start[k]);
        least = std::min(least, nearest_gap(edges, corners).distance);
      }
      const FaceMeeting meeting = first_meeting(pair, start, end, at_start, stop);
      if (least < stop) {
        EXPECT_TRUE(meeting.met) << round;
        ++meetings;
      } else if (least > stop + 0.11 * (at_start - stop)) {
        EXPECT_FALSE(meeting.met) << round << ": came to " << least;
        ++passings;
      }
      if (meeting.met) {
        EXPECT_GE(meeting.gap.distance, stop);
      }
    }
  EXPECT_GT(meetings, 20);
  EXPECT_GT(passings, 100);
}

TEST(Piercings, AreThoseOfExactArithmetic) {
  std::mt19937 random(17);
  int through = 0;
  for (int round = 0; round < 3000; ++round) {
    std::array<Vec3, 2> edge{random_place(random, 1.0), random_place(random, 1.0)};
    const std::array<Vec3, 3> triangle{random_place(random, 1.0), random_place(random, 1.0),
                                       random_place(random, 1.0)};
    if (round % 4 == 0)
      edge[1] = 0.25 * triangle[0] + 0.5 * triangle[1] + 0.25 * triangle[2];  // nearly on it
    const bool exact = goes_through(edge[0], edge[1], triangle);
    const Piercing found = piercing(edge, triangle);
    EXPECT_FALSE(found == Piercing::none && exact) << round;
    EXPECT_FALSE(found == Piercing::through && !exact) << round;
    through += exact ? 1 : 0;
  }
  EXPECT_GT(through, 200);
}

TEST(Piercings, WhatLiesBesideInThePlaneDoesNotPierce) {
  const std::array<Vec3, 3> triangle{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  EXPECT_EQ(piercing({Vec3(2, 0, 0), Vec3(2, 1, 0)}, triangle), Piercing::none);
  EXPECT_EQ(piercing({Vec3(0.2, 0.2, 0), Vec3(0.3, 0.3, 0)}, triangle), Piercing::unclear);
  EXPECT_EQ(piercing({Vec3(0.2, 0.2, -1), Vec3(0.2, 0.2, 1)}, triangle), Piercing::through);
}

// Against places all over the triangle.
TEST(FaceDepth, IsTheLeastDistanceFromASolid) {
  std::mt19937 random(23);
  const std::array<Shape, 4> shapes{HalfSpace{{0.0, -0.2, 0.0}, Vec3(0.6, 0.8, 0.0)},
                                    Sphere{Vec3::Zero(), 0.4}, Capsule{{-0.5, 0, 0}, {0.5, 0.1, 0}, 0.1},
                                    Box{Vec3::Zero(), {0.3, 0.2, 0.5}}};
  for (const Shape& shape : shapes)
    for (int round = 0; round < 100; ++round) {
      const std::array<Vec3, 3> t{random_place(random, 1.0), random_place(random, 1.0),
                                  random_place(random, 1.0)};
      double least = infinity;
      for (int i = 0; i <= 60; ++i)
        for (int j = 0; i + j <= 60; ++j)
          least = std::min(
              least, nearest_surface(shape, t[0] + (t[1] - t[0]) * (i / 60.0) + (t[2] - t[0]) * (j / 60.0))
                         .distance);
      const double found = least_distance(shape, t);
      EXPECT_LE(found, least + 1e-9);
      EXPECT_GT(found, least - 0.03);
      EXPECT_TRUE(may_be_within(found + 1e-6, shape, t));
    }
}

SheetSpec level_sheet(std::string name, double height, int cells = 4) {
  SheetSpec sheet;
  sheet.name = std::move(name);
  sheet.rows = sheet.columns = cells + 1;
  sheet.from = {-0.5, height, -0.5};
  sheet.to = {0.5, height, -0.5};
  sheet.down = {0.0, 0.0, 1.0};
  sheet.collides = true;
  sheet.faces = FacesSpec{0.02, 0.5, true};
  return sheet;
}

// A sheet's edges are those of its triangles, each once; a box adds its corners, edges and triangles.
TEST(FaceMeshes, HaveEveryPartOnce) {
  Description description;
  description.sheets = {level_sheet("cloth", 1.0)};
  description.boxes = {BoxSpec{}};
  description.spheres = {SphereSpec{{5.0, 0.0, 0.0}, 1.0}};
  description.capsules = {CapsuleSpec{{-5.0, 0.0, 0.0}, {-6.0, 0.0, 0.0}}};
  description.planes = {PlaneSpec{{0.0, -9.0, 0.0}}};
  const Built built = build_valid(description);
  const FaceMesh mesh(built.model);
  EXPECT_EQ(mesh.size(), 25U + 8U + 1U + 2U);
  EXPECT_EQ(mesh.triangles.size(), 32U + 12U);
  EXPECT_EQ(mesh.edges.size(), 20U + 20U + 16U + 12U + 1U);
  EXPECT_EQ(mesh.model_triangle.size(), 32U);
  const WholeFaces whole = whole_faces(mesh, built.model, built.start.broken_at);
  EXPECT_EQ(whole.points.size(), mesh.size());
  EXPECT_EQ(whole.edges.size(), mesh.edges.size());
  EXPECT_EQ(whole.triangles.size(), mesh.triangles.size());
}

TEST(FaceMeshes, LoseWhatIsTorn) {
  Description description;
  description.sheets = {level_sheet("cloth", 1.0, 1)};
  const Built built = build_valid(description);
  const FaceMesh mesh(built.model);
  std::vector<double> broken_at = built.start.broken_at;
  broken_at[0] = 0.5;  // the top edge: with it goes the triangle at the top left, and the corner of only that
  const WholeFaces whole = whole_faces(mesh, built.model, broken_at);
  EXPECT_EQ(whole.triangles.size(), 1U);
  EXPECT_EQ(whole.edges.size(), 3U);
  EXPECT_EQ(whole.points.size(), 3U);
}

// Looking everywhere finds the same pairs, and rooms only add to them.
TEST(FacePairs, AreAllThatAreNear) {
  std::mt19937 random(29);
  Description description;
  description.sheets = {level_sheet("one", 0.0), level_sheet("other", 0.5)};
  description.boxes = {BoxSpec{{0.0, -0.9, 0.0}, {0.5, 0.5, 0.5}}};
  const Built built = build_valid(description);
  const FaceMesh mesh(built.model);
  const WholeFaces whole = whole_faces(mesh, built.model, built.start.broken_at);
  std::vector<Vec3> places;
  mesh.places(built.start.position, 0.0, places);
  for (std::size_t node = 0; node < mesh.mass.size(); ++node) places[node] += random_place(random, 0.4);
  std::vector<FacePair> pairs, roomy;
  find_face_pairs(mesh, whole, places, std::vector<double>(mesh.size(), 0.0), 1'000'000, pairs);
  find_face_pairs(mesh, whole, places, std::vector<double>(mesh.size(), 0.05), 1'000'000, roomy);
  std::size_t expected = 0;
  const auto count = [&](const FacePair& pair) {
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j)
        if (pair.nodes[i] == pair.nodes[j]) return;
    if (mesh.meet(mesh.group[pair.nodes[0]], mesh.group[pair.nodes[3]]) &&
        nearest_gap(pair, places).distance <= watched_apart(mesh, pair))
      ++expected;
  };
  for (std::uint32_t point = 0; point < mesh.size(); ++point)
    for (const auto& [a, b, c] : mesh.triangles) count({{point, a, b, c}, false});
  for (std::size_t i = 0; i < mesh.edges.size(); ++i)
    for (std::size_t j = i + 1; j < mesh.edges.size(); ++j)
      count({{mesh.edges[i].nodes[0], mesh.edges[i].nodes[1], mesh.edges[j].nodes[0], mesh.edges[j].nodes[1]},
             true});
  EXPECT_EQ(pairs.size(), expected);
  EXPECT_GT(expected, 40U);
  EXPECT_GT(roomy.size(), pairs.size());
}

// --- what is refused ---

struct BadFaces {
  std::string label;
  std::function<void(Description&)> make;
  std::string key;
  std::vector<std::string> parts;  // of the message
};

void PrintTo(const BadFaces& mistake, std::ostream* out) {
  *out << mistake.label;
}

class OneBadSheet : public ::testing::TestWithParam<BadFaces> {};

TEST_P(OneBadSheet, IsRefusedByName) {
  Description description;
  description.sheets = {level_sheet("other", 3.0), level_sheet("cloth", 0.0)};
  GetParam().make(description);
  const std::vector<Problem> problems = build(description).problems;
  ASSERT_EQ(problems.size(), 1U) << (problems.empty() ? "" : problems.back().message);
  EXPECT_EQ(problems[0].section, "sheet");
  EXPECT_EQ(problems[0].index, 1U);
  EXPECT_EQ(problems[0].key, GetParam().key);
  for (const std::string& part : GetParam().parts)
    EXPECT_NE(problems[0].message.find(part), std::string::npos) << problems[0].message;
}

using D = Description;
constexpr double nan_number = std::numeric_limits<double>::quiet_NaN();

std::vector<BadFaces> bad_faces() {
  return {
      {"thickness_zero", [](D& d) { d.sheets[1].faces->thickness = 0.0; }, "faces", {"above 0 m thick"}},
      {"thickness_negative",
       [](D& d) { d.sheets[1].faces->thickness = -0.1; },
       "faces",
       {"above 0 m", "-0.1"}},
      {"thickness_nan", [](D& d) { d.sheets[1].faces->thickness = nan_number; }, "faces", {"not nan"}},
      {"friction", [](D& d) { d.sheets[1].faces->friction = -1.0; }, "faces", {"0  or more"}},
      {"too_thick",
       [](D& d) { d.sheets[1].faces->thickness = 0.1; },
       "faces",
       {"at most half as thick", "0.08839 m", "0.1 m"}},
      {"radius", [](D& d) { d.sheets[1].radius = 0.01; }, "radius", {"thickness in place of a radius"}},
      {"in_a_box",
       [](D& d) {
         d.boxes = {BoxSpec{Vec3::Zero(), Vec3::Constant(5.0)}};
       },
       "faces",
       {"the face of \"cloth.", "starts inside the [[box]] number 1", "there are 32 such places"}},
      {"through_a_box",
       [](D& d) {
         d.boxes = {BoxSpec{{0.1, 0.0, 0.13}, Vec3::Constant(0.3)}};
       },
       "faces",
       {"goes through", "the [[box]] number 1", "such places"}},
      {"on_the_ground",
       [](D& d) {
         d.planes = {PlaneSpec{{0.0, -0.005, 0.0}}};
       },
       "faces",
       {"starts 0.005 m from the [[plane]] number 1, nearer than half its thickness, 0.01 m"}},
      {"ball_between_masses",
       [](D& d) {
         d.spheres = {SphereSpec{{0.13, 0.0, 0.13}, 0.02}};
       },
       "faces",
       {"starts inside the [[sphere]] number 1"}},
      {"rod_through_a_face",
       [](D& d) {
         d.capsules = {CapsuleSpec{{0.15, -1.0, 0.12}, {0.15, 1.0, 0.12}, 0.01}};
       },
       "faces",
       {"the [[capsule]] number 1 goes through the face of \"cloth."}},
  };
}
INSTANTIATE_TEST_SUITE_P(All, OneBadSheet, ::testing::ValuesIn(bad_faces()),
                         [](const auto& each) { return each.param.label; });

// Two sheets through each other, or nearer than their thickness: told of once, at the one that comes first.
TEST(FaceStarts, ThroughAnotherSheetAreRefused) {
  Description description;
  description.sheets = {level_sheet("cloth", 0.0), level_sheet("upright", 0.0)};
  description.sheets[1].down = {0.0, 1.0, 0.1};
  description.sheets[1].from = {-0.5, -0.4, 0.07};
  description.sheets[1].to = {0.5, -0.4, 0.07};
  const std::vector<Problem> problems = build(description).problems;
  ASSERT_GE(problems.size(), 1U);
  EXPECT_EQ(problems[0].key, "faces");
  EXPECT_NE(problems[0].message.find("through each other"), std::string::npos) << problems[0].message;
  EXPECT_NE(problems[0].message.find("\"upright."), std::string::npos) << problems[0].message;
  description.sheets[1].collides = false;  // then it is no business of theirs
  EXPECT_TRUE(build(description).problems.empty());
}

TEST(FaceStarts, NearerThanTheirThicknessAreRefused) {
  Description description;
  description.sheets = {level_sheet("cloth", 0.0), level_sheet("above", 0.019)};
  const std::vector<Problem> problems = build(description).problems;
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].message.find("at least their thickness apart, 0.02 m"), std::string::npos)
      << problems[0].message;
  EXPECT_NE(problems[0].message.find("0.019 m apart"), std::string::npos) << problems[0].message;
  description.sheets[1] = level_sheet("above", 0.02);
  EXPECT_TRUE(build(description).problems.empty());
}

// A pleated sheet whose pleats run into each other.
TEST(FaceStarts, ThroughThemselvesAreRefused) {
  Description description;
  SheetSpec curtain = level_sheet("curtain", 0.0);
  curtain.columns = 49;
  curtain.down = {0.0, -1.0, 0.0};
  curtain.fullness = 4.9;
  curtain.hooks.every = 4;
  description.sheets = {curtain};
  const std::vector<Problem> problems = build(description).problems;
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_NE(problems[0].message.find("goes through the face of \"curtain."), std::string::npos)
      << problems[0].message;
  description.sheets[0].faces->self_collides = false;
  EXPECT_TRUE(build(description).problems.empty());
}

TEST(Faces, AreTakenAwayAsAPart) {
  Description description;
  description.sheets = {level_sheet("cloth", 0.0)};
  Built built = build_valid(description);
  for (const Part& part : model_parts())
    if (part.name == "faces") {
      EXPECT_EQ(part.extent(built.model), "32 triangles that touch");
      part.remove(built.model);
      EXPECT_EQ(part.extent(built.model), "");
    }
  EXPECT_TRUE(built.model.faces.empty());
}

}  // namespace
}  // namespace taut::test
