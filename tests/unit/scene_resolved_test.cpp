#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <string>

#include "model/state.h"
#include "scene/scene.h"

namespace taut {
namespace {

// Uses every section and every key of the physics.
const std::string everything = R"(
title = "Everything \"at once\" — é"
[world]
gravity = [0.1, -9.81, 0]
duration = 4
drag = 0.30000000000000004
accuracy = "2.5%"
[solve]
method = "xpbd"
passes = 3
steps_per_second = 1234.5
[[chain]]
name = "rope"
from = [0, 2, 0]
to = [2, 2, 0]
links = 40
length = 2.5
mass = 0.4
last_mass = 1
pinned = ["first", "last"]
first_motion = { amplitude = [0, 0.1, 0], angular_frequency = 10, phase = 1e-300 }
last_motion.path = [[0, 2, 2, 0], [1, 2.1, 2, 0.3333333333333333], [2, 2, 2, 0]]
break_tension = 1e5
[[chain]]
name = "elastic"
from = [0, 3, 1]
to = [2, 3, 1.1]
pinned = ["first"]
links = 7
stiffness = 500
damping = 0.1
break_stretch = 1.3
[[sheet]]
name = "cloth"
rows = 9
columns = 19
from = [-1, 2, 1]
to = [1, 2, 1]
down = [0, -1.5, 0]
mass = 0.7
fullness = 1.67
hooks = { every = 9, draw = [[0, 0.5], [2, 1.2]] }
pinned = ["bottom-left"]
diagonals = true
skip_one = { stiffness = 30, damping = 0.1, break_stretch = 2, break_tension = 7 }
[[sheet]]
name = "flag"
rows = 4
columns = 5
from = [-1, 5, 1]
to = [1, 5, 1]
down = [0, -1.5, 0]
pinned = ["left"]
faces = { thickness = 0.02, friction = 0.3, self_collides = false }
[[mass]]
name = "hand"
position = [0, 5, -0.0]
pinned = true
motion = { path = [[0, 0, 5, 0], [1, 1, 5, 0]] }
[[mass]]
name = "bob"
position = [1, 5, 0]
velocity = [0, 0, 0.1]
mass = 3
radius = 0.1
[[link]]
a = "hand"
b = "bob"
length = 1.1
stiffness = 100
damping = 0.7
break_stretch = 1.5
break_tension = 40
[[link]]
a = "bob"
b = "rope.0"
[[load]]
masses = ["cloth.8.*", "bob"]
force = [0, -5, 0]
from = 1
to = 4
[[ragdoll]]
name = "doll"
height = 1.6
mass = 61
position = [3, 4, 5]
turn = [10, 20, 30]
velocity = [1, 2, 3]
spin = [0.1, 0.2, 0.3]
pose = { neck = 3, left_shoulder = 21, right_elbow = 33, left_knee = -20 }
ranges = { knee = [-120, -2], hip = 60 }
pinned = ["left_hand", "head"]
collides = true
[[angle]]
masses = ["hand", "bob", "rope.0"]
min = 1
max = 179.5
compliance = 0.01
[[hinge]]
masses = ["hand", "bob", "elastic.0"]
axis = ["bob", "rope.40"]
min = -170
max = 175
[[cone]]
frame = ["hand", "bob", "rope.0"]
limb = ["bob", "rope.3", "rope.4"]
axis = [0.1, 0.2, 0.3]
half_angle = 179
[[plane]]
point = [0, -1, 0]
normal = [0.1, 1, 0]
friction = 0.1
restitution = 0.3
[[sphere]]
centre = [9, 8, 7]
radius = 0.5
friction = 0.2
[[capsule]]
from = [9, 9, 9]
to = [8, 8, 8]
radius = 0.3
[[box]]
centre = [7, 7, 7]
size = [1, 2, 3]
turn = [10, 20, 30]
[wind]
velocity = [1, 2, 3]
gust = 0.3
gust_time = 0.7
seed = 5
density = 1.1
drag_coefficient = 1.3
[camera]
eye = [0, 1, 7]
target = [0, 0.5, 0]
direction = [1, 0.5, 2]
show = [[-1, -2, -3], [4, 5, 6]]
field_of_view = 45
up = [0, 0, 2]
orbit = -3
follow = "bob"
[look]
masses = false
links = false
surface = true
ground = false
shadows = false
theme = "dark"
colour_by = "tension"
colour_range = 9
colour_steps = "log"
speed = [[0.5, 0.25], [1, 4]]
ground_height = -1
mass_radius = 0.02
link_radius = 0.01
mass_colour = "#102030"
pin_colour = [0.1, 0.2, 0.3]
link_colour = [0.4, 0.5, 0.6]
surface_colour = [0.7, 0.8, 0.9]
surface_back_colour = [0, 0.5, 1]
pattern = "woven"
mass_shape = "box"
bones = false
colliders = false
bone_colour = [0.1, 0.5, 1]
collider_colour = [0.2, 0.5, 1]
[expect]
max_strain = 0.1
energy_drift = 0.2
broken_links = [0, 3]
sag = [0.1, 2]
at_rest = 0.3
inside = [[-9, -8, -7], [7, 8, 9]]
limit_excess = 1
penetration = 0.001
tangled = 2
)";

void expect_same_links(const Links& a, const Links& b) {
  EXPECT_EQ(a.a, b.a);
  EXPECT_EQ(a.b, b.b);
  EXPECT_EQ(a.length, b.length);
  EXPECT_EQ(a.stiffness, b.stiffness);
  EXPECT_EQ(a.damping, b.damping);
  EXPECT_EQ(a.break_stretch, b.break_stretch);
  EXPECT_EQ(a.break_tension, b.break_tension);
}

void expect_same_driven_pins(const Model& a, const Model& b) {
  ASSERT_EQ(a.driven_pins.size(), b.driven_pins.size());
  for (std::size_t i = 0; i < a.driven_pins.size(); ++i) {
    const DrivenPin& pin = a.driven_pins[i];
    const DrivenPin& other = b.driven_pins[i];
    EXPECT_EQ(pin.mass, other.mass) << i;
    EXPECT_EQ(pin.motion.index(), other.motion.index()) << i;
    for (const double t : {0.0, 0.3, 1.0, 1.7, 5.0})
      EXPECT_EQ(position_at(pin.motion, t), position_at(other.motion, t)) << "pin " << i << " at " << t;
  }
}

void expect_same_model(const Model& a, const Model& b) {
  EXPECT_EQ(a.gravity, b.gravity);
  EXPECT_EQ(a.drag, b.drag);
  EXPECT_EQ(a.masses.name, b.masses.name);
  EXPECT_EQ(a.masses.mass, b.masses.mass);
  EXPECT_EQ(a.masses.inverse_mass, b.masses.inverse_mass);
  expect_same_links(a.links, b.links);
  expect_same_driven_pins(a, b);
  ASSERT_EQ(a.loads.size(), b.loads.size());
  for (std::size_t i = 0; i < a.loads.size(); ++i) {
    EXPECT_EQ(a.loads[i].masses, b.loads[i].masses);
    EXPECT_EQ(a.loads[i].force, b.loads[i].force);
    EXPECT_EQ(a.loads[i].from, b.loads[i].from);
    EXPECT_EQ(a.loads[i].to, b.loads[i].to);
  }
  ASSERT_EQ(a.limits.size(), b.limits.size());
  for (std::size_t i = 0; i < a.limits.size(); ++i) {
    EXPECT_EQ(a.limits[i].kind, b.limits[i].kind);
    EXPECT_EQ(a.limits[i].masses, b.limits[i].masses);
    EXPECT_EQ(a.limits[i].axis, b.limits[i].axis);
    EXPECT_EQ(a.limits[i].min, b.limits[i].min);
    EXPECT_EQ(a.limits[i].max, b.limits[i].max);
    EXPECT_EQ(a.limits[i].compliance, b.limits[i].compliance);
  }
  ASSERT_EQ(a.colliders.size(), b.colliders.size());
  for (std::size_t i = 0; i < a.colliders.size(); ++i) {
    EXPECT_EQ(a.colliders[i].friction, b.colliders[i].friction);
    EXPECT_EQ(a.colliders[i].restitution, b.colliders[i].restitution);
    for (const Vec3& x : {Vec3(0.0, 0.0, 0.0), Vec3(7.0, 7.3, 8.0)})
      EXPECT_EQ(nearest_surface(a.colliders[i].shape, x).distance,
                nearest_surface(b.colliders[i].shape, x).distance);
  }
  EXPECT_EQ(a.contacts.size(), b.contacts.size());
  EXPECT_EQ(a.masses.radius, b.masses.radius);
  ASSERT_EQ(a.wind.has_value(), b.wind.has_value());
  if (a.wind) {
    EXPECT_EQ(wind_at(*a.wind, 1.3), wind_at(*b.wind, 1.3));
  }
  EXPECT_EQ(a.triangles.size(), b.triangles.size());
  EXPECT_EQ(a.sheets.size(), b.sheets.size());
  EXPECT_EQ(a.chains.size(), b.chains.size());
  EXPECT_EQ(a.breakable_links, b.breakable_links);
}

TEST(ResolvedToml, ReadsBackToTheSameModelAndStartBitForBit) {
  const Scene scene = parse_scene(everything, "everything.toml");
  const Scene again = parse_scene(resolved_toml(scene), "everything.toml");
  expect_same_model(scene.model, again.model);
  EXPECT_EQ(state_hash(scene.start), state_hash(again.start));
  EXPECT_EQ(scene.start.position, again.start.position);
  EXPECT_EQ(scene.start.velocity, again.start.velocity);
  EXPECT_EQ(scene.settings.method, again.settings.method);
  EXPECT_EQ(scene.settings.values, again.settings.values);
  EXPECT_GT(scene.model.masses.size(), 200U);
}

TEST(ResolvedToml, OfAResolvedSceneIsTheSameText) {
  const std::string resolved = resolved_toml(parse_scene(everything, "everything.toml"));
  EXPECT_EQ(resolved_toml(parse_scene(resolved, "other.toml")), resolved);
}

TEST(ResolvedToml, KeepsWhatIsSeenAndExpected) {
  const Scene scene =
      parse_scene(resolved_toml(parse_scene(everything, "everything.toml")), "everything.toml");
  EXPECT_EQ(scene.title, "Everything \"at once\" — é");
  EXPECT_EQ(scene.duration, 4.0);
  EXPECT_EQ(scene.accuracy, "2.5%");
  EXPECT_EQ(scene.camera.eye, Vec3(0, 1, 7));
  EXPECT_EQ(scene.camera.target, Vec3(0, 0.5, 0));
  EXPECT_EQ(scene.camera.direction, Vec3(1, 0.5, 2));
  ASSERT_TRUE(scene.camera.show);
  EXPECT_EQ((*scene.camera.show)[0], Vec3(-1, -2, -3));
  EXPECT_EQ((*scene.camera.show)[1], Vec3(4, 5, 6));
  EXPECT_EQ(scene.look.colour_steps, ColourSteps::log);
  EXPECT_EQ(scene.look.speed, (std::vector<std::array<double, 2>>{{0.5, 0.25}, {1.0, 4.0}}));
  EXPECT_EQ(scene.camera.field_of_view, 45.0);
  EXPECT_EQ(scene.camera.up, Vec3(0, 0, 2));
  EXPECT_EQ(scene.camera.orbit, -3.0);
  EXPECT_EQ(scene.camera.follow, "bob");
  EXPECT_FALSE(scene.look.masses || scene.look.links || scene.look.ground || scene.look.shadows);
  EXPECT_TRUE(scene.look.surface);
  EXPECT_EQ(scene.look.theme, Theme::dark);
  EXPECT_EQ(scene.look.colour_by, ColourBy::tension);
  EXPECT_EQ(scene.look.colour_range, 9.0);
  EXPECT_EQ(scene.look.ground_height, -1.0);
  EXPECT_EQ(scene.look.mass_radius, 0.02);
  EXPECT_EQ(scene.look.link_radius, 0.01);
  EXPECT_EQ(scene.look.mass_colour, (Colour{16 / 255.0, 32 / 255.0, 48 / 255.0}));
  EXPECT_EQ(scene.look.pin_colour, (Colour{0.1, 0.2, 0.3}));
  EXPECT_EQ(scene.look.link_colour, (Colour{0.4, 0.5, 0.6}));
  EXPECT_EQ(scene.look.surface_colour, (Colour{0.7, 0.8, 0.9}));
  EXPECT_EQ(scene.look.surface_back_colour, (Colour{0.0, 0.5, 1.0}));
  EXPECT_EQ(scene.look.pattern, Pattern::woven);
  EXPECT_EQ(scene.expectation.max_strain, 0.1);
  EXPECT_EQ(scene.expectation.energy_drift, 0.2);
  EXPECT_EQ(scene.expectation.broken_links, (std::array{0.0, 3.0}));
  EXPECT_EQ(scene.expectation.sag, (std::array{0.1, 2.0}));
  EXPECT_EQ(scene.expectation.at_rest, 0.3);
  EXPECT_EQ((*scene.expectation.inside)[0], Vec3(-9, -8, -7));
  EXPECT_EQ((*scene.expectation.inside)[1], Vec3(7, 8, 9));
}

TEST(ResolvedToml, FillsInDefaultsAndSaysWhatLeftOutKeysMean) {
  const std::string resolved =
      resolved_toml(parse_scene("[[chain]]\nname = \"r\"\nfrom = [0, 1, 0]\nto = [1, 1, 0]\n", "r.toml"));
  EXPECT_TRUE(
      resolved.starts_with("title = \"r\"\n\n"
                           "[world]\n"
                           "gravity = [0.0, -9.81, 0.0]\n"
                           "duration = 6.0\n"
                           "drag = 0.0\n"
                           "accuracy = \"10%\"\n\n"
                           "[solve]\n"
                           "method = \"xpbd\"\n"
                           "steps_per_second = 600.0\n"
                           "passes = 1\n"))
      << resolved;
  EXPECT_NE(resolved.find("[[chain]]\n"
                          "name = \"r\"\n"
                          "from = [0.0, 1.0, 0.0]\n"
                          "to = [1.0, 1.0, 0.0]\n"
                          "# points: straight from `from` to `to`\n"
                          "smooth = false\n"
                          "# wound: not wound\n"
                          "links = 1\n"
                          "length = 0.0\n"
                          "mass = 1.0\n"
                          "last_mass = 0.0\n"
                          "pinned = []\n"
                          "# first_motion: stays\n"
                          "# last_motion: stays\n"
                          "# first_release: never\n"
                          "# last_release: never\n"
                          "# bending: none\n"
                          "radius = 0.0\n"
                          "collides = false\n"
                          "acts = \"both\"\n"
                          "# longest: none\n"
                          "# stiffness: rigid\n"
                          "damping = 0.0\n"
                          "# break_stretch: never\n"
                          "# break_tension: never\n"
                          "# break_at: never\n"
                          "scatter = 0.0\n"
                          "scatter_seed = 1\n"),
            std::string::npos)
      << resolved;
}

TEST(ResolvedToml, WritesNumbersThatReadBackExactly) {
  for (const char* number : {"0.1", "0.30000000000000004", "5e-324", "2.2250738585072014e-308", "123456.75",
                             "0.000001", "999999.9999999999", "1e-7"}) {
    const std::string text =
        std::string("[world]\ndrag = ") + number + "\n[[mass]]\nname = \"a\"\nposition = [0, 0, 0]\n";
    const Scene scene = parse_scene(text, "n.toml");
    EXPECT_EQ(scene.model.drag, std::strtod(number, nullptr)) << number;
    EXPECT_EQ(parse_scene(resolved_toml(scene), "n.toml").model.drag, scene.model.drag) << number;
  }
}

TEST(ResolvedToml, EscapesText) {
  const std::string text =
      "title = \"tab\\t quote\\\" back\\\\ line\\n bell\\u0007 é\"\n[[mass]]\nname = \"a\"\nposition = [0, "
      "0, "
      "0]\n";
  const Scene scene = parse_scene(text, "t.toml");
  EXPECT_EQ(scene.title, "tab\t quote\" back\\ line\n bell\a é");
  EXPECT_EQ(parse_scene(resolved_toml(scene), "t.toml").title, scene.title);
}

}  // namespace
}  // namespace taut
