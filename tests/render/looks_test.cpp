// How each object is drawn by itself: in its colour, as links, masses or cloth, or not at all.

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "geometry/geometry.h"
#include "geometry/lattice.h"
#include "geometry/palette.h"
#include "geometry/supports.h"
#include "layers.h"
#include "render/appearance.h"
#include "render/colour_range.h"
#include "scene/scene.h"
#include "small_scenes.h"

namespace taut {
namespace {

using testing::channel_at;
using testing::cut_out;
using testing::draw_once;
using testing::size;
using testing::straight_on;

// Two chains side by side, a bob that hangs between them, and two sheets; nothing moves yet.
constexpr std::string_view looks_scene = R"(
[look]
shadows = false
ground = false
[[chain]]
name = "left"
from = [-1.5, 1, 0]
to = [-0.5, 1, 0]
links = 4
pinned = ["first"]
[[chain]]
name = "right"
from = [0.5, 1, 0]
to = [1.5, 1, 0]
links = 6
pinned = ["last"]
[[sheet]]
name = "red"
rows = 4
columns = 4
from = [-1.5, 0, 0]
to = [-0.5, 0, 0]
down = [0, -1, 0]
pinned = ["top"]
[[sheet]]
name = "rest"
rows = 5
columns = 5
from = [0.5, 0, 0]
to = [1.5, 0, 0]
down = [0, -1, 0]
pinned = ["top"]
[[mass]]
name = "bob"
position = [0, 0.5, 0]
[[link]]
a = "left.4"
b = "bob"
[[link]]
a = "bob"
b = "right.0"
[[sphere]]
centre = [0, -3, 0]
[[load]]
masses = ["left.2"]
force = [0, -1, 0]
)";

Scene looks(const std::vector<std::string>& sets) {
  return parse_scene(std::string(looks_scene), "looks.toml", {sets, {}});
}

std::shared_ptr<const Geometry> shape_of(const Scene& scene) {
  return GeometryMaker(scene.model, scene.start, scene.look).make(scene.start, straight_on());
}

std::set<Rgba> colours_of(const std::vector<RodRecord>& links) {
  std::set<Rgba> colours;
  for (const RodRecord& link : links) colours.insert(link.colour);
  return colours;
}

TEST(Looks, AHiddenChainIsGoneWithTheLinksThatEndAtIt) {
  const auto all = shape_of(looks({}));
  const auto rest = shape_of(looks({"chain.left.visible=false"}));
  EXPECT_EQ(all->spheres.size(), rest->spheres.size() + 5);
  EXPECT_EQ(all->links.size(), rest->links.size() + 4 + 1) << "its own, and the one to the bob";
  EXPECT_EQ(all->lines.arrows.size(), 1U);
  EXPECT_TRUE(rest->lines.arrows.empty()) << "a load on what isn't there to be seen";
}

TEST(Looks, AHiddenMassLeavesItsLinks) {
  const auto all = shape_of(looks({}));
  const auto rest = shape_of(looks({"mass.bob.visible=false"}));
  EXPECT_EQ(all->links.size(), rest->links.size());
  // In its place the links end in a ball of their own thickness.
  EXPECT_EQ(all->spheres.size(), rest->spheres.size());
  EXPECT_LT(rest->spheres.back().radius, all->spheres.back().radius);
}

TEST(Looks, SolidsAndPlanesAreHiddenOneByOne) {
  EXPECT_EQ(shape_of(looks({}))->bodies.rods.size(),
            shape_of(looks({"sphere.0.visible=false"}))->bodies.rods.size() + 1);
  const std::string planes = std::string(looks_scene) + "[[plane]]\n[[plane]]\nnormal = [1, 1, 0]\n";
  Scene scene = parse_scene(planes, "p.toml", {{"look.ground=true", "plane.0.visible=false"}, {}});
  std::vector<Ground> seen = drawn_grounds(scene.model, scene.look, Vec3::UnitY());
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_GT(seen.front().normal.x(), 0.5);
  scene.look.objects.planes[1].visible = false;
  EXPECT_TRUE(drawn_grounds(scene.model, scene.look, Vec3::UnitY()).empty())
      << "hidden planes don't make room for grid lines";
}

TEST(Looks, EachObjectHasItsColour) {
  const Scene scene =
      looks({"chain.left.colour=#102030", "link.1.colour=[0, 1, 0]", "mass.bob.colour=white"});
  const auto shape = shape_of(scene);
  const Rgba own{16, 32, 48, 255}, green{0, 255, 0, 255};
  EXPECT_EQ(colours_of(shape->links), (std::set<Rgba>{own, green, opaque(scene.look.link_colour)}));
  EXPECT_EQ(std::ranges::count(shape->links, own, &RodRecord::colour), 4);
  EXPECT_EQ(std::ranges::count(shape->spheres, own, &SphereRecord::colour), 4) << "its pin keeps its own";
  EXPECT_EQ(shape->spheres.back().colour, (Rgba{242, 242, 240, 255}));
}

TEST(Looks, AScaleTakesThePlaceOfColours) {
  const auto shape = shape_of(looks({"chain.left.colour=#102030", "look.colour_by=strain"}));
  EXPECT_EQ(std::ranges::count(shape->links, Rgba{16, 32, 48, 255}, &RodRecord::colour), 0);
}

TEST(Looks, RopesAndRingsHaveTheirColours) {
  for (const char* shape : {"rope", "chain"}) {
    const Scene scene = looks({"chain.left.colour=#102030", std::string("look.link_shape=") + shape,
                               "sheet.*.visible=false", "link.0.colour=#00ff00"});
    const auto drawn = shape_of(scene);
    std::set<Rgba> colours;
    for (const RopeRecord& piece : drawn->lines.ropes) colours.insert(piece.start_colour);
    for (const RingRecord& ring : drawn->lines.rings) colours.insert(ring.colour);
    EXPECT_EQ(colours, (std::set<Rgba>{{16, 32, 48, 255}, {0, 255, 0, 255}, opaque(scene.look.link_colour)}))
        << shape;
  }
}

TEST(Looks, EachObjectIsDrawnAsWhatItSays) {
  const auto shape = shape_of(looks(
      {"sheet.red.draw=[\"surface\"]", "chain.left.draw=[\"links\"]", "chain.right.draw=[\"masses\"]"}));
  const auto all = shape_of(looks({}));
  EXPECT_EQ(shape->surface.spread->sheets.size(), 1U);
  // The sheet's 24 links and the right chain's 6 are gone.
  EXPECT_EQ(shape->links.size() + 24 + 6, all->links.size());
  // The left chain's masses are balls as thick as its links.
  EXPECT_EQ(shape->spheres.size() + 16, all->spheres.size());
}

TEST(Looks, ABodyMayBeDrawnAsItsLinks) {
  const std::string text =
      "[[ragdoll]]\nname = \"a\"\nposition = [0, 0, 0]\n[[ragdoll]]\nname = \"b\"\nposition = [2, 0, 0]\n";
  const Scene as_links = parse_scene(text, "b.toml", {{"ragdoll.a.draw=[\"links\", \"masses\"]"}, {}});
  const auto shape = shape_of(as_links);
  EXPECT_EQ(shape->bodies.torsos.size(), 1U);
  EXPECT_EQ(shape->spheres.size(), as_links.model.ragdolls.front().mass_count);
  EXPECT_EQ(shape->links.size(), as_links.model.ragdolls.front().link_count);
  const auto hidden = shape_of(parse_scene(text, "b.toml", {{"ragdoll.*.visible=false"}, {}}));
  EXPECT_TRUE(hidden->bodies.torsos.empty());
  const auto green = shape_of(parse_scene(text, "b.toml", {{"ragdoll.b.colour=#00ff00"}, {}}));
  EXPECT_EQ(green->bodies.torsos.back().colour, (Rgba{0, 255, 0, 255}));
}

// What is seen through the window of the straight camera at a place of the plane z = 0.
std::array<int, 3> seen_at(const Image& picture, double x, double y) {
  const Vec3 at = picture_position(straight_on(), size.width, size.height, {x, y, 0.0});
  std::array<int, 3> colour{};
  for (std::size_t i = 0; i < 3; ++i)
    colour.at(i) =
        channel_at(picture, static_cast<int>(at.x()), static_cast<int>(at.y()), static_cast<int>(i));
  return colour;
}

TEST(Looks, SheetsHaveFrontsAndBacksOfTheirOwn) {
  const std::vector<std::string> both{"look.surface=true", "look.links=false", "look.masses=false",
                                      "sheet.red.colour=#ff0000", "sheet.red.back_colour=#0000ff"};
  const Scene scene = looks(both);
  const Image front = draw_once(scene.model, scene.start, scene.look, cut_out(size), straight_on());
  const auto red = seen_at(front, -1.0, -0.5), rest = seen_at(front, 1.0, -0.5);
  EXPECT_GT(red[0], 3 * std::max(red[1], red[2]));
  EXPECT_GT(rest[0], rest[1]) << "the look's own, a dark red";
  EXPECT_GT(rest[1], 0);
  Scene turned = scene;
  for (std::size_t i = 0; i < turned.start.position.size(); ++i) {
    const Vec3 place = scene.start.position.at(i);
    turned.start.position.set(i, {-place.x(), place.y(), place.z()});
  }
  const Image back = draw_once(turned.model, turned.start, turned.look, cut_out(size), straight_on());
  const auto blue = seen_at(back, 1.0, -0.5);
  EXPECT_GT(blue[2], 3 * std::max(blue[0], blue[1]));
}

TEST(Looks, TornClothKeepsItsColour) {
  Scene scene = looks({"look.surface=true", "sheet.rest.colour=#00ff00"});
  for (std::size_t link = 0; link < scene.model.links.size(); link += 3)
    if (scene.model.links.a[link] >= scene.model.sheets.front().first_mass) scene.start.broken_at[link] = 0.0;
  const auto shape = shape_of(scene);
  ASSERT_EQ(shape->surface.tints.size(), shape->surface.vertices.size());
  for (std::size_t i = 0; i < shape->surface.vertices.size(); ++i)
    EXPECT_EQ(shape->surface.tints[i].front == (Rgba{0, 255, 0, 255}),
              shape->surface.vertices[i].position.x > 0.0F);
}

TEST(Looks, APlaneHasItsColour) {
  const std::string text =
      "[look]\nshadows = false\n[[plane]]\n[[mass]]\nname = \"m\"\nposition = [0, 1, 0]\n";
  const CameraPose above{{0.0, 3.0, 0.1}, {0.0, 0.0, 0.0}, 38.0};
  const auto ground = [&](const std::vector<std::string>& sets) {
    const Scene scene = parse_scene(text, "p.toml", {sets, {}});
    RenderSettings settings = cut_out(size);
    settings.transparent = false;
    const Image picture = draw_once(scene.model, scene.start, scene.look, settings, above);
    return std::array{channel_at(picture, 30, 30, 0), channel_at(picture, 30, 30, 1)};
  };
  EXPECT_NEAR(ground({})[0], ground({})[1], 25);
  EXPECT_GT(ground({"plane.0.colour=#ff2000"})[0], 2 * ground({"plane.0.colour=#ff2000"})[1]);
}

TEST(Looks, AScaleThatNothingUsesHasNoLegend) {
  const auto legend = [](std::vector<std::string> sets) {
    sets.insert(sets.end(), {"look.colour_range=1"});
    const Scene scene = looks(sets);
    const auto context = make_gl_context();
    GeometryMaker maker(scene.model, scene.start, scene.look);
    Renderer renderer(*context, scene.look, cut_out(size));
    return renderer.draw(*maker.make(scene.start, straight_on()))->legend.has_value();
  };
  EXPECT_TRUE(legend({"look.colour_by=strain"}));
  EXPECT_FALSE(legend({"look.colour_by=plain"}));
  EXPECT_FALSE(legend({"look.colour_by=strain", "look.links=false"})) << "masses have no strain";
  EXPECT_TRUE(legend({"look.colour_by=speed", "look.links=false"}));
  EXPECT_FALSE(legend({"look.colour_by=strain", "chain.*.visible=false", "sheet.*.visible=false"}));
  EXPECT_TRUE(legend({"look.colour_by=strain", "chain.*.visible=false", "sheet.rest.visible=false",
                      "sheet.red.draw=[\"surface\"]"}));
}

TEST(Looks, WhatIsHiddenDoesNotStretchTheScale) {
  Scene scene = looks({"look.colour_by=strain"});
  for (std::size_t i = 0; i < 5; ++i)  // the left chain's links are five times as long
    scene.start.position.set(i, {-6.5 + 1.25 * static_cast<double>(i), 1.0, 0.0});
  const auto top = [](const Scene& of) {
    ColourRange range(ColourBy::strain);
    range.add(of.model, of.start, of.look);
    return range.top();
  };
  Scene hidden = scene;
  hidden.look.objects.chains[0].visible = false;
  EXPECT_GT(top(scene), 1.0);
  EXPECT_LT(top(hidden), 1e-9) << "nothing else is strained";
}

TEST(Looks, PinsOfWhatIsHiddenHaveNoSupports) {
  const auto parts = [](const std::vector<std::string>& sets) {
    const auto shape = shape_of(looks(sets));
    return shape->bodies.rods.size() + shape->bodies.boxes.size();
  };
  EXPECT_GT(parts({}), parts({"chain.left.visible=false"}));
  EXPECT_EQ(parts({"chain.*.visible=false", "sheet.*.visible=false"}), 1U) << "the sphere";
}

TEST(Looks, BesideClothOtherObjectsThrowTheirShadow) {
  const auto shape = shape_of(looks({"sheet.*.draw=[\"surface\", \"links\"]"}));
  // The chains' 10 links and those to the bob, before the sheets' 24 and 40.
  EXPECT_EQ(shape->link_shadows, 12U);
  EXPECT_EQ(shape->links.size(), 12U + 24 + 40);
  for (std::size_t i = 0; i < shape->link_shadows; ++i) EXPECT_GT(shape->links[i].start.y, 0.4F);
}

TEST(Looks, OnlyWhatIsSeenIsKeptInView) {
  const Scene scene =
      looks({"chain.left.visible=false", "mass.bob.visible=false", "look.trails=[\"left.3\"]"});
  const std::vector<bool> seen = masses_in_view(scene.model, scene.look);
  EXPECT_FALSE(seen[0]);
  EXPECT_TRUE(seen[3]) << "its trail is drawn";
  EXPECT_TRUE(seen[scene.model.singles.first_mass]) << "a link that is drawn ends there";
  const Scene none = looks({"chain.*.visible=false", "sheet.*.draw=[]", "mass.0.visible=false"});
  const std::vector<bool> all = masses_in_view(none.model, none.look);
  EXPECT_EQ(std::ranges::count(all, true), static_cast<std::ptrdiff_t>(all.size()))
      << "where nothing is seen there must still be a picture";
}

}  // namespace
}  // namespace taut
