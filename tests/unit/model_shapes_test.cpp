// Chains along points and around solids, ties, and edges of sheets that are moved: where their masses are,
// and what is said of those that can't be.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/hash.h"
#include "model/measures.h"
#include "scene_errors.h"

namespace taut {
namespace {

Scene shape(const std::string& text) {
  return parse_scene(text, "f.toml");
}

std::vector<Vec3> places_of(const Scene& scene, const std::string& chain) {
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < scene.model.masses.size(); ++i)
    if (scene.model.masses.name[i].starts_with(chain + ".")) places.push_back(scene.start.position.at(i));
  return places;
}

// The lengths of all links, and how far each is from being as long as it is.
void expect_links_of_one_length(const Scene& scene) {
  const Model& model = scene.model;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    EXPECT_NEAR(model.links.length[i], model.links.length[0], 1e-15);
    EXPECT_NEAR(link_distance(model, scene.start.position, i), model.links.length[i],
                1e-9 * model.links.length[i])
        << i;
  }
}

double distance_to(const Vec3& place, const Vec3& from, const Vec3& to) {
  const Vec3 span = to - from;
  const double share = std::clamp((place - from).dot(span) / span.squaredNorm(), 0.0, 1.0);
  return (place - from - share * span).norm();
}

std::string laid(int links, const std::string& more = "") {
  return "[[chain]]\nname = \"rope\"\npoints = [[0, 0, 0], [1, 1, 0], [2, 0, 0], [2, 0, 3]]\nlinks = " +
         std::to_string(links) + "\n" + more;
}

TEST(LaidChain, LiesAlongItsPointsInLinksOfOneLength) {
  const std::vector<Vec3> points{{0, 0, 0}, {1, 1, 0}, {2, 0, 0}, {2, 0, 3}};
  for (const int links : {4, 7, 30, 1000}) {
    const Scene scene = shape(laid(links));
    const std::vector<Vec3> places = places_of(scene, "rope");
    ASSERT_EQ(places.size(), static_cast<std::size_t>(links) + 1);
    expect_links_of_one_length(scene);
    EXPECT_EQ(places.front(), points.front());
    EXPECT_EQ(places.back(), points.back());
    for (const Vec3& place : places) {
      double nearest = 1.0;
      for (std::size_t i = 0; i + 1 < points.size(); ++i)
        nearest = std::min(nearest, distance_to(place, points[i], points[i + 1]));
      EXPECT_LT(nearest, 1e-9);
    }
    EXPECT_LE(scene.model.links.length[0] * links, 2.0 * std::sqrt(2.0) + 3.0);
    EXPECT_GT(scene.model.links.length[0] * links, 0.9 * (2.0 * std::sqrt(2.0) + 3.0)) << links;
  }
}

TEST(LaidChain, AlongAStraightLineIsTheStraightChain) {
  const Scene laid_out = shape("[[chain]]\nname = \"r\"\npoints = [[0, 2, 0], [2, 2, 0]]\nlinks = 8\n");
  const Scene straight = shape("[[chain]]\nname = \"r\"\nfrom = [0, 2, 0]\nto = [2, 2, 0]\nlinks = 8\n");
  for (std::size_t i = 0; i < 9; ++i)
    EXPECT_LT((laid_out.start.position.at(i) - straight.start.position.at(i)).norm(), 1e-12);
}

TEST(LaidChain, IsSmoothWhereItIsToBe) {
  const Scene smooth = shape(laid(300, "smooth = true\n"));
  expect_links_of_one_length(smooth);
  const std::vector<Vec3> places = places_of(smooth, "rope");
  double sharpest = 0.0;
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    const Vec3 before = (places[i] - places[i - 1]).normalized(),
               after = (places[i + 1] - places[i]).normalized();
    sharpest = std::max(sharpest, std::acos(std::min(1.0, before.dot(after))));
  }
  EXPECT_LT(sharpest, 0.3) << "radians; the straight one turns by 1.57";
  for (const Vec3& point : {Vec3(1, 1, 0), Vec3(2, 0, 0)}) {
    double nearest = 1.0;
    for (const Vec3& place : places) nearest = std::min(nearest, (place - point).norm());
    EXPECT_LT(nearest, 0.6 * smooth.model.links.length[0]) << "through its points";
  }
}

// How often places go round an axis through a point, right-handed.
double turns_about(const std::vector<Vec3>& places, const Vec3& point, const Vec3& axis) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const auto off = [&](const Vec3& place) -> Vec3 {
      return (place - point) - axis * axis.dot(place - point);
    };
    sum += std::atan2(axis.dot(off(places[i]).cross(off(places[i + 1]))),
                      off(places[i]).dot(off(places[i + 1])));
  }
  return sum / (2.0 * std::numbers::pi);
}

const std::string solids =
    "[[capsule]]\nfrom = [0, 0, 0]\nto = [2, 0, 0]\nradius = 0.25\n"
    "[[sphere]]\ncentre = [5, 0, 0]\nradius = 1\n";

std::string wound(const std::string& how, int links = 200) {
  return solids + "[[chain]]\nname = \"rope\"\nradius = 0.05\nlinks = " + std::to_string(links) +
         "\nwound = { " + how + " }\n";
}

TEST(WoundChain, TouchesTheSolidAndGoesRoundAsOftenAsItSays) {
  for (const double turns : {4.0, -2.5}) {
    const Scene coil =
        shape(wound("around = \"capsule.0\", start = 0.25, end = 0.5, turns = " + std::to_string(turns)));
    expect_links_of_one_length(coil);
    const std::vector<Vec3> places = places_of(coil, "rope");
    EXPECT_NEAR(turns_about(places, Vec3::Zero(), Vec3::UnitX()), turns, 1e-9);
    EXPECT_NEAR(places.front().x(), 0.5, 1e-12);
    EXPECT_NEAR(places.back().x(), 1.0, 1e-12);
    for (const Vec3& place : places) EXPECT_NEAR(std::hypot(place.y(), place.z()), 0.3, 1e-3 * 0.3);

    const Scene ball =
        shape(wound("around = \"sphere.0\", axis = [0, 0, 2], turns = " + std::to_string(turns)));
    expect_links_of_one_length(ball);
    EXPECT_NEAR(turns_about(places_of(ball, "rope"), {5, 0, 0}, Vec3::UnitZ()), turns, 1e-9);
    for (const Vec3& place : places_of(ball, "rope")) EXPECT_NEAR((place - Vec3(5, 0, 0)).norm(), 1.05, 2e-3);
  }
}

TEST(WoundChain, ReadsBackFromTheResolvedText) {
  const std::string text = wound("around = \"capsule.0\"") +
                           laid(20, "smooth = true\n").replace(18, 4, "lain") +
                           "[[tie]]\na = \"rope.0\"\nb = \"lain.0\"\n";
  const Scene scene = shape(text);
  const Scene again = shape(resolved_toml(scene));
  EXPECT_EQ(state_hash(scene.start), state_hash(again.start));
  EXPECT_EQ(scene.model.links.length, again.model.links.length);
  EXPECT_EQ(resolved_toml(scene), resolved_toml(again));
}

void expect_error(const std::string& text, const std::string& words) {
  const std::string errors = errors_of(text);
  EXPECT_NE(errors.find(words), std::string::npos) << "not \"" << words << "\" but:\n" << errors;
}

TEST(LaidChain, SaysWhatIsWrong) {
  expect_error("[[chain]]\nname = \"r\"\n",
               "f.toml:1:1: [[chain]] needs the key \"from\", or \"points\" or \"wound\"");
  expect_error("[[chain]]\nname = \"r\"\nfrom = [0, 0, 0]\n", "needs the key \"to\", or");
  expect_error(laid(5, "from = [0, 0, 0]\n"),
               "f.toml:5:1: \"points\" says where this chain lies: it has no \"from\"");
  expect_error(laid(5, "length = 3\n"),
               "f.toml:5:1: points says how long this chain is: it has no \"length\"");
  expect_error(chain_with("smooth = true\n"), "f.toml:5:1: smooth is for a chain that has points");
  expect_error("[[chain]]\nname = \"r\"\npoints = [[0, 0, 0], [0, 0, 0], [1, 0, 0]]\n",
               "f.toml:3:1: points 1 and 2 are the same point");
  expect_error("[[chain]]\nname = \"r\"\npoints = [[0, 0, 0]]\n", "f.toml:3:1: points must be 2 or more");
  expect_error("[[chain]]\nname = \"r\"\npoints = [[0, 0], [1, 0]]\n",
               "\"points\" must be a list of [x, y, z]");
  expect_error("[[chain]]\nname = \"r\"\npoints = [[0, 0, 0], [2e6, 0, 0]]\n",
               "f.toml:3:23: \"points\" must be between -1e6 and 1e6 m");
  expect_error("[[chain]]\nname = \"r\"\npoints = [[0, 0, 0], [1, 0, 0], [0, 0, 0]]\nlinks = 1\n",
               "f.toml:4:1: 1 links are too few for how sharply this chain turns");
  expect_error(wound("around = \"capsul.0\""), "did you mean \"capsule.0\"?");
  expect_error(wound("around = \"capsule.1\""),
               "wound.around names no sphere or capsule: \"capsule.1\"; there are sphere.0, capsule.0");
  expect_error(wound("around = \"sphere.0\", turns = 0"), "wound.turns must be from 0.01 to 1000");
  expect_error(wound("around = \"sphere.0\", start = 0.8, end = 0.3"),
               "wound.start and wound.end are shares");
  expect_error(wound("around = \"sphere.0\", turn = 3"), "did you mean \"turns\"?");
  expect_error(wound("turns = 3"), "\"wound\" needs the key \"around\"");
  expect_error("[[chain]]\nname = \"r\"\nwound = { around = \"sphere.0\" }\n",
               "wound.around = \"sphere.0\": the scene has no sphere and no capsule");
}

const std::string cloth_and_rope =
    "[[sheet]]\nname = \"cloth\"\nrows = 3\ncolumns = 5\nfrom = [0, 1, 0]\nto = [1, 1, 0]\ndown = [0, -1, "
    "0]\n"
    "[[chain]]\nname = \"rope\"\nfrom = [0, 1.25, 0]\nto = [1, 1.25, 0]\nlinks = 8\npinned = [\"first\", "
    "\"last\"]\n";

TEST(Tie, LinksEachMassToTheNearest) {
  const Scene scene = shape(cloth_and_rope + "[[tie]]\na = \"cloth.0.*\"\nb = \"rope.*\"\nevery = 2\n");
  const Links& links = scene.model.links;
  const std::vector<std::string>& names = scene.model.masses.name;
  const std::size_t first = links.size() - 3;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(names[links.a[first + i]], "cloth.0." + std::to_string(2 * i));
    EXPECT_EQ(names[links.b[first + i]], "rope." + std::to_string(4 * i));
    EXPECT_EQ(links.length[first + i], 0.25);
    EXPECT_TRUE(links.rigid(first + i));
  }
  const Scene soft = shape(cloth_and_rope +
                           "[[tie]]\na = \"cloth.*.4\"\nb = \"rope.8\"\nstiffness = 70\n"
                           "break_tension = 9\n");
  EXPECT_EQ(soft.model.links.stiffness.back(), 70.0);
  EXPECT_EQ(soft.model.breakable_links.size(), 3U);
}

TEST(Tie, SaysWhatIsWrong) {
  const auto tie = [](const std::string& lines) { return cloth_and_rope + "[[tie]]\n" + lines; };
  expect_error(tie("a = \"clot.0.*\"\nb = \"rope.*\"\n"), "f.toml:15:1: no mass is named \"clot.0.*\"");
  expect_error(tie("a = \"cloth.0.*\"\nb = \"rop.3\"\n"), "did you mean \"rope.3\"?");
  expect_error(tie("a = \"cloth.0.*\"\nb = \"rope.*\"\nevery = 3\n"),
               "f.toml:17:1: every = 3 does not divide 4, one less than the 5 masses");
  expect_error(tie("a = \"cloth.0.*\"\nb = \"rope.*\"\nevery = 0\n"), "\"every\" must be between 1 and");
  expect_error(tie("a = \"rope.0\"\nb = \"rope.*\"\n"), "f.toml:16:1: \"rope.0\" would be tied to itself");
  expect_error(tie("a = \"cloth.0.*\"\nb = \"rope.*\"\ndamping = 2\n"), "damping needs a stiffness");
  expect_error(tie("a = \"cloth.0.*\"\n"), "[[tie]] needs the key \"b\"");
  expect_error(tie("a = \"far\"\nb = \"near\"\n[[mass]]\nname = \"far\"\nposition = [3, 0, 0]\n"
                   "[[mass]]\nname = \"near\"\nposition = [3, 0, 0]\n"),
               "\"far\" and \"near\" are at the same point, so their tie has no length");
}

std::string moved_sheet(const std::string& lines) {
  return "[[sheet]]\nname = \"cloth\"\nrows = 4\ncolumns = 3\nfrom = [0, 1, 0]\nto = [1, 1, 0]\n"
         "down = [0, -0.9, 0]\n" +
         lines;
}

TEST(MovedEdge, MovesAllOfItsMassesAlike) {
  const Scene swung =
      shape(moved_sheet("pinned = [\"top\"]\ntop_motion = { amplitude = [0, 0, 0.5], "
                        "angular_frequency = 3, phase = 1 }\n"));
  ASSERT_EQ(swung.model.driven_pins.size(), 3U);
  for (const DrivenPin& pin : swung.model.driven_pins) {
    const Vec3 rest(0.5 * pin.mass, 1.0, 0.0);
    EXPECT_LT((position_at(pin.motion, 0.4) - rest - Vec3(0, 0, 0.5 * std::sin(2.2))).norm(), 1e-12);
  }
  const Scene led =
      shape(moved_sheet("pinned = [\"right\"]\nright_motion = { path = [[0, 1, 1, 0], [2, 4, 1, 1]] }\n"));
  ASSERT_EQ(led.model.driven_pins.size(), 4U);
  for (std::size_t row = 0; row < 4; ++row) {
    const DrivenPin& pin = led.model.driven_pins[row];
    EXPECT_EQ(led.model.masses.name[pin.mass], "cloth." + std::to_string(row) + ".2");
    EXPECT_LT((position_at(pin.motion, 2.0) - Vec3(4, 1.0 - 0.3 * static_cast<double>(row), 1)).norm(),
              1e-12);
  }
  const std::string shake = "_motion = { amplitude = [0.1, 0, 0], angular_frequency = 2 }\n";
  EXPECT_EQ(shape(moved_sheet("pinned = [\"top\", \"left\"]\ntop" + shake + "left" + shake))
                .model.driven_pins.size(),
            6U)
      << "edges that move alike may share a corner";
}

TEST(MovedEdge, SaysWhatIsWrong) {
  const std::string shake = "_motion = { amplitude = [0.1, 0, 0], angular_frequency = 2 }\n";
  expect_error(moved_sheet("pinned = [\"left\"]\ntop" + shake),
               "f.toml:9:1: top_motion is only for an edge that \"pinned\" names");
  expect_error(moved_sheet("pinned = [\"top-left\"]\ntop" + shake), "top_motion is only for an edge");
  expect_error(
      moved_sheet("pinned = [\"top\", \"left\"]\ntop" + shake + "left_motion = { path = [[0, 0, 1, 0]] }\n"),
      "f.toml:10:1: top_motion and left_motion differ, and the corner top-left can't follow both");
  expect_error(
      moved_sheet("pinned = [\"top\"]\ntop" + shake + "hooks = { every = 2, draw = [[0, 1], [1, 0.5]] }\n"),
      "f.toml:9:1: hooks.draw moves masses of the top edge already");
  expect_error(moved_sheet("pinned = [\"top\"]\ntop_motion = { amplitude = [0.1, 0, 0] }\n"),
               "needs the key \"angular_frequency\"");
  expect_error(moved_sheet("pinned = [\"top\"]\ntop_motion = { path = [[1, 0, 1, 0], [1, 0, 2, 0]] }\n"),
               "times must increase");
}

}  // namespace
}  // namespace taut
