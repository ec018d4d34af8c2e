// Ropes, chains, weights, loads and ghosts: what is drawn of them, worked out without OpenGL, and that it is
// drawn.

#include "geometry/lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/geometry.h"
#include "geometry/link_runs.h"
#include "geometry/load_arrows.h"
#include "geometry/mass_weight.h"
#include "geometry/region.h"
#include "small_scenes.h"

namespace taut {
namespace {

using testing::bare_look;
using testing::row_of_masses;
using testing::size;
using testing::straight_on;
using testing::upright_sheet;

std::vector<bool> all_links(const Model& model) {
  return std::vector<bool>(model.links.size(), true);
}

std::vector<std::vector<Index>> links_of(const std::vector<LinkRun>& runs) {
  std::vector<std::vector<Index>> links;
  for (const LinkRun& run : runs) links.push_back(run.links);
  return links;
}

using Runs = std::vector<std::vector<Index>>;

LinkSpec link_between(std::size_t a, std::size_t b) {
  LinkSpec link;
  link.a = testing::mass_name(a);
  link.b = testing::mass_name(b);
  return link;
}

Built masses_and_links(int masses, const std::vector<std::array<std::size_t, 2>>& links) {
  Description description;
  for (int i = 0; i < masses; ++i) {
    MassSpec mass;
    mass.name = testing::mass_name(static_cast<std::size_t>(i));
    mass.position = {std::cos(1.0 * i), std::sin(1.0 * i), 0.1 * i};
    description.masses.push_back(mass);
  }
  for (const auto& [a, b] : links) description.links.push_back(link_between(a, b));
  return build(description);
}

Built chain_of(int links, double mass = 1.0, double last_mass = 0.0) {
  Description description;
  ChainSpec chain;
  chain.name = "rope";
  chain.from = {-1.0, 0.0, 0.0};
  chain.to = {1.0, 0.0, 0.0};
  chain.links = links;
  chain.mass = mass;
  chain.last_mass = last_mass;
  chain.pinned = {"first"};
  description.chains.push_back(chain);
  return build(description);
}

TEST(LinkRuns, GoOnThroughMassesOfTwoLinksInWhicheverOrderTheyStand) {
  const Built scene = masses_and_links(5, {{2, 3}, {1, 0}, {4, 3}, {1, 2}});
  EXPECT_EQ((Runs{{1, 3, 0, 2}}), links_of(link_runs(scene.model, all_links(scene.model))));
  const LinkRun run = link_runs(scene.model, all_links(scene.model)).front();
  EXPECT_EQ((std::vector<Index>{0, 1, 2, 3, 4}), run.masses);
  EXPECT_FALSE(run.closed());
}

TEST(LinkRuns, EndWhereThreeMeetAndWhereALinkIsGone) {
  const Built star = masses_and_links(4, {{0, 1}, {0, 2}, {0, 3}});
  EXPECT_EQ((Runs{{0}, {1}, {2}}), links_of(link_runs(star.model, all_links(star.model))));
  EXPECT_EQ((std::vector<Index>{0}), knots(star.model, link_runs(star.model, all_links(star.model))));
  const Built chain = chain_of(5);
  EXPECT_EQ((Runs{{0, 1}, {3, 4}}), links_of(link_runs(chain.model, {true, true, false, true, true})));
}

TEST(LinkRuns, CloseWhereTheyComeRound) {
  const Built ring = masses_and_links(4, {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  const std::vector<LinkRun> runs = link_runs(ring.model, all_links(ring.model));
  ASSERT_EQ(1U, runs.size());
  EXPECT_TRUE(runs[0].closed());
  EXPECT_EQ(4U, runs[0].links.size());
  EXPECT_TRUE(knots(ring.model, runs).empty());
}

TEST(LinkRuns, OfANetAreItsRowsAndColumnsTiedAtEveryMass) {
  const Built net = upright_sheet(3, 4);
  const std::vector<LinkRun> runs = link_runs(net.model, all_links(net.model));
  ASSERT_EQ(7U, runs.size());
  EXPECT_EQ((std::vector<Index>{4, 5, 6, 7}), runs[1].masses);
  EXPECT_EQ((std::vector<Index>{1, 5, 9}), runs[4].masses);
  EXPECT_EQ(12U, knots(net.model, runs).size());
}

TEST(LinkRuns, OfAChainGoOnWhereALinkIsTiedToIt) {
  Description description;
  ChainSpec chain;
  chain.name = "rope";
  chain.to = {2.0, 0.0, 0.0};
  chain.links = 4;
  description.chains.push_back(chain);
  MassSpec mass;
  mass.name = "weight";
  mass.position = {1.0, -1.0, 0.0};
  description.masses.push_back(mass);
  LinkSpec link;
  link.a = "rope.2";
  link.b = "weight";
  description.links.push_back(link);
  const Built scene = build(description);
  const std::vector<LinkRun> runs = link_runs(scene.model, all_links(scene.model));
  EXPECT_EQ((Runs{{0, 1, 2, 3}, {4}}), links_of(runs));
  EXPECT_EQ((std::vector<Index>{2}), knots(scene.model, runs));
}

Look look_of(LinkShape shape) {
  Look look = bare_look();
  look.links = true;
  look.link_shape = shape;
  return look;
}

std::shared_ptr<const Geometry> seen(const Built& scene, const Look& look) {
  return GeometryMaker(scene.model, scene.start, look).make(scene.start, straight_on());
}

// Masses on a half circle of radius 1 about the origin.
Built bow() {
  std::vector<Vec3> places;
  for (int i = 0; i <= 12; ++i) {
    const double angle = std::numbers::pi * (1.0 + i / 12.0);
    places.emplace_back(std::cos(angle), std::sin(angle), 0.0);
  }
  return row_of_masses(places);
}

TEST(Rope, IsSmoothAndKeepsToTheBowThatItsMassesLieOn) {
  Look look = look_of(LinkShape::rope);
  look.link_radius = 0.02;
  const auto geometry = seen(bow(), look);
  const std::vector<RopeRecord>& pieces = geometry->lines.ropes;
  ASSERT_GT(pieces.size(), 20U);
  double length = 0.0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const glm::vec3 middle = pieces[i].end + glm::vec3(0.0F, 0.0F, 5.0F);  // the eye is the origin
    EXPECT_NEAR(1.0, glm::length(middle), 0.004) << "piece " << i;
    length += glm::length(pieces[i].end - pieces[i].start);
    if (i == 0) continue;
    EXPECT_EQ(pieces[i - 1].end, pieces[i].start);
    EXPECT_EQ(pieces[i - 1].end_tangent, pieces[i].start_tangent);
    EXPECT_GT(glm::dot(pieces[i].start_tangent, pieces[i].end_tangent), std::cos(0.16F));
    const double step = std::remainder(pieces[i].phases.x - pieces[i - 1].phases.y, 2.0 * std::numbers::pi);
    EXPECT_NEAR(0.0, step, 1e-3) << "strands break at piece " << i;
  }
  EXPECT_NEAR(std::numbers::pi, length, 0.005);
}

TEST(Rope, ItsStrandsGoRoundAsOftenWhenItIsStretched) {
  Look look = look_of(LinkShape::rope);
  look.link_radius = 0.02;
  const auto turned = [&](double stretch) {
    Built scene = row_of_masses({{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}});
    for (std::size_t i = 0; i < 3; ++i) scene.start.position.set(i, stretch * scene.start.position.at(i));
    double phase = 0.0;
    const auto geometry = seen(scene, look);
    for (const RopeRecord& piece : geometry->lines.ropes) phase += piece.phases.y - piece.phases.x;
    return phase / (2.0 * std::numbers::pi);
  };
  EXPECT_NEAR(-3.0 * 2.0 / (8.5 * 0.02), turned(1.0), 1e-3);  // strands, metres, metres to go round
  EXPECT_NEAR(turned(1.0), turned(1.5), 1e-3);
}

TEST(Rope, EndsInLooseStrandsWhereALinkBroke) {
  Built scene = chain_of(4);
  const Look look = look_of(LinkShape::rope);
  const std::size_t whole = seen(scene, look)->lines.ropes.size();
  EXPECT_EQ(4U, whole);  // straight: a piece a link
  scene.start.broken_at[1] = 0.0;
  EXPECT_EQ(3U + 2U * 15U, seen(scene, look)->lines.ropes.size());
}

TEST(Rope, ShowsPinsAndHeavyMassesAlone) {
  Look look = look_of(LinkShape::rope);
  look.masses = true;
  look.link_radius = 0.01;
  look.mass_radius = 0.03;
  // A pin, the ball and two rounded ends.
  const auto heavy = seen(chain_of(10, 1.0, 9.0), look);
  EXPECT_EQ(4U, heavy->spheres.size());
  EXPECT_EQ(3U, seen(chain_of(10), look)->spheres.size());
}

TEST(Rope, KeepsTheColoursOfLinks) {
  Built scene = row_of_masses({{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}});
  Look look = look_of(LinkShape::rope);
  look.colour_by = ColourBy::tension;
  look.colour_range = 10.0;
  scene.start.tension = {2.0, 8.0};
  const ColourScale scale{10.0, Theme::light};
  const std::vector<RopeRecord> pieces = seen(scene, look)->lines.ropes;
  ASSERT_EQ(4U, pieces.size());
  EXPECT_EQ(opaque(scale.at(2.0)), pieces[0].end_colour);
  EXPECT_EQ(opaque(scale.at(5.0)), pieces[1].end_colour);
  EXPECT_EQ(opaque(scale.at(8.0)), pieces[2].end_colour);
}

// Places along the middle of a ring's wire.
std::vector<glm::vec3> wire_of(const RingRecord& ring) {
  const glm::vec3 axis = glm::normalize(ring.end - ring.start);
  const float straight = 0.5F * glm::length(ring.end - ring.start) + ring.wire_radius - ring.bend_radius;
  std::vector<glm::vec3> places;
  for (int i = 0; i < 120; ++i) {
    const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / 120.0F;
    const float half = std::cos(angle) >= 0.0F ? 1.0F : -1.0F;
    places.push_back(0.5F * (ring.start + ring.end) +
                     axis * (half * straight + ring.bend_radius * std::cos(angle)) +
                     ring.side * (ring.bend_radius * std::sin(angle)));
  }
  return places;
}

TEST(ChainRings, AreTurnedByARightAngleAndTouchWithoutCutting) {
  for (const double pitch : {0.0, 0.08}) {
    Look look = look_of(LinkShape::chain);
    look.chain_pitch = pitch;
    const auto geometry = seen(chain_of(10), look);
    const std::vector<RingRecord>& rings = geometry->lines.rings;
    ASSERT_EQ(pitch > 0.0 ? 25U : 10U, rings.size());
    EXPECT_TRUE(geometry->spheres.empty());
    for (std::size_t i = 1; i < rings.size(); ++i) {
      EXPECT_NEAR(0.0, glm::dot(rings[i - 1].side, rings[i].side), 1e-5);
      EXPECT_NEAR(0.0, glm::length(rings[i - 1].end - rings[i].start), 1e-6);
      float nearest = 1e9F;
      for (const glm::vec3& one : wire_of(rings[i - 1]))
        for (const glm::vec3& other : wire_of(rings[i]))
          nearest = std::min(nearest, glm::length(one - other));
      EXPECT_NEAR(2.0 * rings[i].wire_radius, nearest, 0.05 * rings[i].wire_radius);
    }
  }
}

TEST(MassWeights, AreCubeRootsOfShares) {
  const Built heavy = chain_of(100, 1.0, 1.0);  // the last one 101 times as heavy
  Look look;
  const std::vector<MassWeight> weights = mass_weights(heavy.model, look);
  EXPECT_NEAR(std::cbrt(101.0), weights.back().size, 1e-9);
  EXPECT_LT(weights.back().shade, 0.4);
  EXPECT_NEAR(1.0, weights[50].size, 1e-12);
  EXPECT_NEAR(1.0, weights[50].shade, 1e-12);
  EXPECT_EQ(1.0, weights[0].size) << "a pin";
  look.weights = false;
  EXPECT_EQ(1.0, mass_weights(heavy.model, look).back().size);
}

TEST(MassWeights, AreDrawnUnlessAMassHasARadiusOrAQuantityItsColour) {
  Built scene = chain_of(10, 1.0, 8.0);
  Look look;
  look.mass_radius = 0.01;
  const auto ball = [&] { return seen(scene, look)->spheres.back(); };
  EXPECT_NEAR(0.01 * std::cbrt(88.0), ball().radius, 1e-6);
  EXPECT_LT(ball().colour[0], opaque(look.mass_colour)[0] / 2);
  look.colour_by = ColourBy::speed;
  look.colour_range = 1.0;
  EXPECT_EQ(opaque(ColourScale{1.0, Theme::light}.at(0.0)), ball().colour);
  look.colour_by = ColourBy::plain;
  scene.model.masses.radius.back() = 0.02;
  EXPECT_NEAR(0.02, ball().radius, 1e-6);
  EXPECT_EQ(opaque(look.mass_colour), ball().colour);
}

Built loaded(std::vector<std::string> masses) {
  Description description;
  ChainSpec chain;
  chain.name = "rope";
  chain.from = {-1.0, 0.5, 0.0};
  chain.to = {1.0, 0.5, 0.0};
  chain.links = 10;
  description.chains.push_back(chain);
  LoadSpec load;
  load.masses = std::move(masses);
  load.force = {0.0, -3.0, 0.0};
  load.from = 1.0;
  load.to = 3.0;
  description.loads.push_back(load);
  return build(description);
}

std::vector<RodRecord> arrows_at(const Built& scene, double time) {
  State state = scene.start;
  state.time = time;
  Look look = bare_look();
  look.mass_radius = 0.05;
  return GeometryMaker(scene.model, scene.start, look).make(state, straight_on())->lines.arrows;
}

TEST(LoadArrows, GrowWithTheForceAndPointAtTheirMass) {
  const Built scene = loaded({"rope.4", "rope.5"});
  EXPECT_TRUE(arrows_at(scene, 1.0).empty());
  ASSERT_EQ(2U, arrows_at(scene, 2.0).size());
  for (const double time : {2.0, 3.0, 9.0}) {
    const RodRecord arrow = arrows_at(scene, time)[1];
    EXPECT_NEAR(time < 3.0 ? 0.2 : 0.4, arrow.start.y - arrow.end.y, 1e-5);  // a fifth of 2 m
    EXPECT_NEAR(0.0, arrow.end.x, 1e-6);
    EXPECT_NEAR(0.5 + 1.3 * 0.05, arrow.end.y, 1e-5);
  }
}

TEST(LoadArrows, AreOneForManyMasses) {
  const std::vector<RodRecord> arrows = arrows_at(loaded({"rope.*"}), 3.0);
  ASSERT_EQ(1U, arrows.size());
  EXPECT_NEAR(0.4, arrows[0].start.y - arrows[0].end.y, 1e-5);
  EXPECT_NEAR(0.0, arrows[0].end.x, 1e-6);
}

TEST(Families, DecideWhichLinksAreDrawn) {
  Description description;
  SheetSpec sheet;
  sheet.name = "cloth";
  sheet.rows = sheet.columns = 4;
  sheet.to = {1.0, 0.0, 0.0};
  sheet.down = {0.0, -1.0, 0.0};
  sheet.diagonals.emplace();
  sheet.skip_one.emplace();
  description.sheets.push_back(sheet);
  const Built scene = build(description);
  Look look = bare_look();
  look.links = true;
  EXPECT_EQ(24U, seen(scene, look)->links.size());
  look.families = {"diagonals"};
  EXPECT_EQ(18U, seen(scene, look)->links.size());
  look.families = {"structural", "skip_one"};
  EXPECT_EQ(40U, seen(scene, look)->links.size());
}

TEST(Lines, NothingReachesTheEdgeOfTheirRegion) {
  Built scene = loaded({"rope.3"});
  scene.start.time = 5.0;
  scene.start.broken_at[7] = 1.0;
  const auto context = make_gl_context({});
  for (const LinkShape shape : {LinkShape::rope, LinkShape::chain}) {
    Look look = look_of(shape);
    look.link_radius = 0.04;
    GeometryMaker maker(scene.model, scene.start, look, {}, scene.start);
    for (const CameraPose& pose : {straight_on(), CameraPose{{0.3, 0.9, 1.2}, {0.0, 0.6, 0.0}, 60.0}}) {
      const auto geometry = maker.make(scene.start, pose);
      const Region region = drawn_region(*geometry, size);
      ASSERT_FALSE(region.empty());
      const Image image = flatten(*Renderer(*context, look, testing::cut_out(size)).draw(*geometry));
      int seen_inside = 0;
      for (int y = region.top; y < region.top + region.height; ++y)
        for (int x = region.left; x < region.left + region.width; ++x) {
          const int alpha = testing::channel_at(image, x, y, 3);
          seen_inside += alpha > 0 ? 1 : 0;
          const bool at_edge =
              (x == region.left && x > 0) || (x == region.left + region.width - 1 && x < size.width - 1) ||
              (y == region.top && y > 0) || (y == region.top + region.height - 1 && y < size.height - 1);
          if (at_edge) {
            EXPECT_EQ(0, alpha) << "at " << x << ", " << y;
          }
        }
      EXPECT_GT(seen_inside, 300);
    }
  }
}

TEST(Ghost, IsDrawnWhereTheOtherStateIsAndLetsThingsShine) {
  Built scene = row_of_masses({{-1, 0, 0}, {1, 0, 0}});
  State other = scene.start;
  for (std::size_t i = 0; i < 2; ++i) other.position.set(i, scene.start.position.at(i) + Vec3(0.0, 0.6, 0.0));
  Look look = look_of(LinkShape::rod);
  look.link_radius = 0.1;
  GeometryMaker maker(scene.model, scene.start, look, {}, other);
  const auto context = make_gl_context({});
  const Image image = flatten(
      *Renderer(*context, look, testing::cut_out(size)).draw(*maker.make(scene.start, straight_on())));
  const auto at = [&](double y, int channel) {
    const Vec3 place = picture_position(straight_on(), size.width, size.height, {0.0, y, 0.0});
    return testing::channel_at(image, static_cast<int>(place.x()), static_cast<int>(place.y()), channel);
  };
  EXPECT_EQ(255, at(0.0, 3));
  EXPECT_GT(at(0.6, 3), 80);
  EXPECT_LT(at(0.6, 3), 200);
  EXPECT_GT(at(0.6, 2), at(0.6, 0) + 40) << "blue";
  EXPECT_EQ(0, at(0.3, 3));
}

}  // namespace
}  // namespace taut
