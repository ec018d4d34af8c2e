#pragma once

#include <map>
#include <string>

namespace taut::test {

/// Those of key_scenes with bodies, and with limits on angles.
inline const std::map<std::string, std::string> key_bodies{
    {"doll", R"(
[[ragdoll]]
name = "doll"
position = [0.0, 1.0, 0.0]
pinned = ["left_hand"]
velocity = [0.2, 0.0, 0.0]
spin = [0.0, 1.0, 0.0]
[[load]]
masses = ["doll.head"]
force = [300.0, 100.0, 100.0]
)"},
    {"doll with legs drawn back", R"(
[[ragdoll]]
name = "doll"
position = [0.0, 1.0, 0.0]
pinned = ["left_hand"]
[[load]]
masses = ["doll.left_knee.*", "doll.right_knee.*"]
force = [0.0, 0.0, -600.0]
)"},
    {"doll on a ball", R"(
[[ragdoll]]
name = "doll"
position = [0.0, 1.2, 0.0]
collides = true
[[mass]]
name = "ball"
position = [0.0, 1.2, 0.2]
velocity = [0.0, 0.0, -3.0]
mass = 5.0
radius = 0.15
collides = true
)"},
    {"angle", R"(
[[mass]]
name = "a"
position = [-0.5, 2.0, 0.0]
pinned = true
[[mass]]
name = "b"
position = [0.0, 2.0, 0.0]
pinned = true
[[mass]]
name = "c"
position = [0.5, 1.95, 0.0]
velocity = [0.0, 0.6, 0.0]
[[mass]]
name = "d"
position = [-0.5, 1.98, 0.0]
pinned = true
[[link]]
a = "b"
b = "c"
LINKS
[[angle]]
masses = ["a", "b", "c"]
min = 100.0
max = 175.0
)"},
    {"stopped pendulum", R"(
[[mass]]
name = "a"
position = [0.0, 2.0, 0.0]
pinned = true
[[mass]]
name = "b"
position = [0.5, 2.0, 0.0]
[[mass]]
name = "c"
position = [0.75, 2.0, 0.0]
velocity = [0.0, -2.0, 0.0]
[[link]]
a = "a"
b = "b"
LINKS
[[link]]
a = "b"
b = "c"
LINKS
[[angle]]
masses = ["a", "b", "c"]
min = 150.0
)"},
    {"hinge", R"(
[[mass]]
name = "a"
position = [-0.5, 2.0, 0.0]
pinned = true
[[mass]]
name = "b"
position = [0.0, 2.0, 0.0]
pinned = true
[[mass]]
name = "c"
position = [0.5, 2.0, 0.0]
velocity = [0.0, 1.0, 0.0]
[[mass]]
name = "e"
position = [0.1, 2.0, 1.0]
pinned = true
[[mass]]
name = "d"
position = [0.4, 2.1, 1.0]
pinned = true
[[link]]
a = "b"
b = "c"
LINKS
[[mass]]
name = "f"
position = [-0.5, 2.02, 0.0]
pinned = true
[[hinge]]
masses = ["a", "b", "c"]
axis = ["b", "e"]
min = -5.0
max = 5.0
)"},
    {"cone", R"(
[[mass]]
name = "a"
position = [-0.5, 2.0, 0.0]
pinned = true
[[mass]]
name = "b"
position = [0.0, 2.0, 0.0]
pinned = true
[[mass]]
name = "c"
position = [0.5, 2.0, 0.0]
[[mass]]
name = "d"
position = [0.0, 2.0, 1.0]
pinned = true
[[mass]]
name = "e"
position = [0.5, 2.0, 0.1]
[[link]]
a = "b"
b = "c"
LINKS
[[link]]
a = "c"
b = "e"
LINKS
[[cone]]
frame = ["b", "a", "d"]
limb = ["b", "c"]
axis = [1.0, 0.0, 0.0]
half_angle = 10.0
)"},
};

}  // namespace taut::test
