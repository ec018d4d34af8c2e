#pragma once

#include <map>
#include <string>

namespace taut::test {

/// Small scenes in which keys of the scene format matter, a few each. LINKS stands for what links need so
/// that the method takes them: nothing, or a stiffness.
inline const std::map<std::string, std::string> key_scenes{
    {"rope", R"(
[[chain]]
name = "rope"
from = [0.0, 2.0, 0.0]
to = [1.0, 2.0, 0.0]
links = 4
mass = 0.5
pinned = ["first"]
LINKS
[[load]]
masses = ["rope.4"]
force = [0.0, 0.3, 0.7]
from = 0.05
to = 0.1
)"},
    {"springy rope", R"(
[[chain]]
name = "rope"
from = [0.0, 2.0, 0.0]
to = [1.1, 2.0, 0.0]
links = 4
length = 1.0
mass = 0.5
pinned = ["first"]
stiffness = 500.0
)"},
    {"swung rope", R"(
[[chain]]
name = "rope"
from = [0.0, 2.0, 0.0]
to = [0.9, 2.0, 0.0]
links = 4
length = 1.0
mass = 0.5
pinned = ["first", "last"]
first_motion = { amplitude = [0.01, 0.0, 0.0], angular_frequency = 8.0, phase = 0.0 }
last_motion = { amplitude = [0.01, 0.0, 0.0], angular_frequency = 8.0, phase = 0.0 }
LINKS
)"},
    {"led rope", R"(
[[chain]]
name = "rope"
from = [0.0, 2.0, 0.0]
to = [0.9, 2.0, 0.0]
links = 4
length = 1.0
mass = 0.5
pinned = ["first", "last"]
first_motion = { path = [[0.0, 0.0, 2.0, 0.0], [0.3, 0.1, 2.0, 0.0]] }
last_motion = { path = [[0.0, 0.9, 2.0, 0.0], [0.3, 0.8, 2.0, 0.0]] }
LINKS
)"},
    {"ropes that meet", R"(
[[chain]]
name = "rope"
from = [0.0, 2.0, 0.0]
to = [1.0, 2.0, 0.0]
links = 4
radius = 0.1
collides = true
LINKS
[[chain]]
name = "other"
from = [0.5, 1.7, -0.5]
to = [0.5, 1.7, 0.5]
links = 4
radius = 0.1
collides = true
pinned = ["first", "last"]
LINKS
)"},
    {"cloth", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
pinned = ["top-left"]
LINKS
[[load]]
masses = ["cloth.2.2"]
force = [0.1, 0.2, 0.3]
)"},
    {"springy cloth", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
pinned = ["top-left"]
stiffness = 100.0
diagonals = { stiffness = 50.0 }
skip_one = { stiffness = 50.0 }
)"},
    {"curtain", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 7
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.4, 0.0]
mass = 0.3
fullness = 1.4
hooks = { every = 3, draw = [[0.0, 1.0], [0.3, 0.9]] }
LINKS
)"},
    {"sheet on a ball", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [-0.2, 1.12, -0.2]
to = [0.2, 1.12, -0.2]
down = [0.0, 0.0, 0.4]
radius = 0.05
collides = true
LINKS
[[sphere]]
centre = [0.0, 0.0, 0.0]
[[mass]]
name = "ball"
position = [0.0, 1.3, 0.02]
radius = 0.1
collides = true
)"},
    {"crumpled cloth", R"(
[[sheet]]
name = "cloth"
rows = 12
columns = 3
from = [0.0, 0.38, 0.0]
to = [0.08, 0.38, 0.0]
down = [0.0, -0.36, 0.03]
faces = { thickness = 0.012 }
LINKS
[[plane]]
)"},
    {"pendulum", R"(
[[mass]]
name = "hook"
position = [0.0, 2.0, 0.0]
pinned = true
[[mass]]
name = "elbow"
position = [0.5, 2.0, 0.0]
velocity = [0.0, 0.0, 0.5]
[[mass]]
name = "bob"
position = [1.0, 2.0, 0.0]
[[link]]
a = "hook"
b = "elbow"
LINKS
[[link]]
a = "elbow"
b = "bob"
LINKS
)"},
    {"swung pendulum", R"(
[[mass]]
name = "hook"
position = [0.0, 2.0, 0.0]
pinned = true
motion = { amplitude = [0.01, 0.0, 0.0], angular_frequency = 8.0, phase = 0.0 }
[[mass]]
name = "bob"
position = [0.5, 2.0, 0.0]
[[link]]
a = "hook"
b = "bob"
LINKS
)"},
    {"springy pendulum", R"(
[[mass]]
name = "hook"
position = [0.0, 2.0, 0.0]
pinned = true
[[mass]]
name = "bob"
position = [0.55, 2.0, 0.0]
[[link]]
a = "hook"
b = "bob"
length = 0.5
stiffness = 500.0
)"},
    {"balls that meet", R"(
[[mass]]
name = "upper"
position = [0.0, 1.25, 0.0]
radius = 0.1
collides = true
[[mass]]
name = "lower"
position = [0.05, 1.0, 0.0]
radius = 0.1
collides = true
pinned = true
)"},
    {"ground", R"(
[[chain]]
name = "rope"
from = [0.0, 0.3, 0.0]
to = [0.3, 0.02, 0.0]
links = 3
LINKS
[[load]]
masses = ["rope.*"]
force = [1.0, 0.0, 0.0]
[[plane]]
)"},
    {"solids", R"(
[[mass]]
name = "on_sphere"
position = [0.3, 1.007, 0.0]
radius = 0.05
[[mass]]
name = "on_capsule"
position = [5.0, 1.1, 0.3]
radius = 0.05
[[mass]]
name = "on_box"
position = [10.0, 0.6, 0.0]
velocity = [1.0, 0.0, 0.0]
radius = 0.05
[[sphere]]
centre = [0.0, 0.0, 0.0]
[[capsule]]
from = [4.5, 0.0, 0.0]
to = [5.5, 0.0, 0.0]
[[box]]
centre = [10.0, 0.0, 0.0]
)"},
    {"slack rope", R"(
[[chain]]
name = "rope"
from = [0.0, 2.0, 0.0]
to = [0.9, 2.0, 0.0]
links = 4
length = 1.0
mass = 0.5
pinned = ["first"]
acts = "pull"
LINKS
)"},
    {"loose rope", R"(
[[chain]]
name = "rope"
from = [0.0, 2.0, 0.0]
to = [0.9, 2.0, 0.0]
links = 4
length = 1.0
mass = 0.5
pinned = ["first"]
acts = "between"
longest = 1.2
LINKS
)"},
    {"bent rope", R"(
[[chain]]
name = "rope"
from = [0.0, 2.0, 0.0]
to = [0.9, 2.0, 0.0]
links = 4
length = 1.0
mass = 0.5
pinned = ["first"]
bending = { stiffness = 0.05 }
LINKS
)"},
    {"tearing rope", R"(
[[chain]]
name = "rope"
from = [0.0, 2.0, 0.0]
to = [1.0, 2.0, 0.0]
links = 4
mass = 0.5
pinned = ["first"]
stiffness = 500.0
break_tension = 8.0
scatter = 0.2
[[load]]
masses = ["rope.4"]
force = [30.0, 0.0, 0.0]
to = 0.3
)"},
    {"rope with a load that ends", R"(
[[chain]]
name = "rope"
from = [0.0, 2.0, 0.0]
to = [1.0, 2.0, 0.0]
links = 4
mass = 0.5
pinned = ["first"]
LINKS
[[load]]
masses = ["rope.4"]
force = [0.0, 0.3, 0.7]
until = 0.1
gone = 0.2
)"},
    {"carried rope", R"(
[[chain]]
name = "rope"
from = [0.0, 2.0, 0.0]
to = [0.9, 2.0, 0.0]
links = 4
length = 1.0
mass = 0.5
pinned = ["first", "last"]
first_motion = { with = "drum" }
last_motion = { with = "drum" }
LINKS
[[mass]]
name = "hook"
position = [0.0, 3.0, 0.0]
pinned = true
motion = { with = "drum" }
[[mass]]
name = "bob"
position = [0.5, 3.0, 0.0]
[[link]]
a = "hook"
b = "bob"
LINKS
[[sphere]]
name = "drum"
centre = [0.0, -50.0, 0.0]
rotation = { axis = [0.0, 0.0, 1.0], rate = 1.0 }
[[sphere]]
name = "wheel"
centre = [9.0, -50.0, 0.0]
rotation = { axis = [0.0, 0.0, 1.0], rate = 2.0 }
)"},
    {"slack cloth", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
pinned = ["top-left"]
stiffness = 100.0
acts = "pull"
weft = { stiffness = 90.0, acts = "pull" }
diagonals = { stiffness = 50.0, acts = "pull" }
skip_one = { stiffness = 50.0, acts = "pull" }
)"},
    {"loose cloth", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
pinned = ["top-left"]
stiffness = 100.0
acts = "between"
longest = 1.05
weft = { stiffness = 90.0, acts = "between", longest = 1.05 }
diagonals = { stiffness = 50.0, acts = "between", longest = 1.05 }
skip_one = { stiffness = 50.0, acts = "between", longest = 1.05 }
)"},
    {"cloth of warp and weft", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
pinned = ["top-left"]
stiffness = 100.0
weft = { stiffness = 90.0 }
)"},
    {"tearing cloth", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
pinned = ["top", "left"]
stiffness = 100.0
break_tension = 1.2
scatter = 0.3
weft = { stiffness = 100.0, break_tension = 1.2, scatter = 0.3 }
diagonals = { stiffness = 50.0, break_tension = 0.6, scatter = 0.3 }
skip_one = { stiffness = 50.0, break_tension = 0.6, scatter = 0.3 }
[[load]]
masses = ["cloth.*.2", "cloth.2.*"]
force = [8.0, -4.0, 4.0]
to = 0.3
)"},
    {"stiff cloth", R"(
[[sheet]]
name = "cloth"
rows = 4
columns = 7
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.1, 0.3]
mass = 0.3
fullness = 1.4
hooks = { every = 3 }
bending = { stiffness = 0.001 }
LINKS
)"},
    {"cloth stiff along warp and weft", R"(
[[sheet]]
name = "cloth"
rows = 4
columns = 7
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.1, 0.3]
mass = 0.3
fullness = 1.4
hooks = { every = 3 }
bending = { warp = 0.001, weft = 0.001 }
LINKS
)"},
    {"slack pendulum", R"(
[[mass]]
name = "hook"
position = [0.0, 2.0, 0.0]
pinned = true
[[mass]]
name = "bob"
position = [0.55, 2.0, 0.0]
[[link]]
a = "hook"
b = "bob"
length = 0.5
stiffness = 500.0
acts = "pull"
)"},
    {"loose pendulum", R"(
[[mass]]
name = "hook"
position = [0.0, 2.0, 0.0]
pinned = true
[[mass]]
name = "bob"
position = [0.55, 2.0, 0.0]
[[link]]
a = "hook"
b = "bob"
length = 0.5
stiffness = 500.0
acts = "between"
longest = 1.05
)"},
    {"tearing pendulum", R"(
[[mass]]
name = "hook"
position = [0.0, 2.0, 0.0]
pinned = true
[[mass]]
name = "bob"
position = [0.5, 2.0, 0.0]
[[link]]
a = "hook"
b = "bob"
stiffness = 500.0
break_tension = 26.0
scatter = 0.3
[[load]]
masses = ["bob"]
force = [90.0, 0.0, 0.0]
to = 0.3
)"},
    {"seam in a cloth", R"(
[[sheet]]
name = "cloth"
rows = 4
columns = 4
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.4, 0.0]
mass = 0.6
pinned = ["top"]
stiffness = 100.0
break_stretch = 1.5
break_tension = 2.0
[[sheet]]
name = "other"
rows = 4
columns = 4
from = [2.0, 2.0, 0.0]
to = [2.4, 2.0, 0.0]
down = [0.0, -0.4, 0.0]
mass = 0.6
pinned = ["left"]
stiffness = 100.0
break_tension = 2.0
[[seam]]
sheet = "cloth"
row = 1
strength = 0.2
[[seam]]
sheet = "other"
column = 1
strength = 0.2
)"},
    {"seam between masses", R"(
[[sheet]]
name = "cloth"
rows = 4
columns = 4
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.4, 0.0]
mass = 0.6
pinned = ["top"]
stiffness = 100.0
[[seam]]
a = ["cloth.1.*"]
b = ["cloth.2.*"]
break_stretch = 1.3
break_tension = 1.2
break_at = 0.28
)"},
    {"seam that opens", R"(
[[chain]]
name = "rope"
from = [0.0, 2.0, 0.0]
to = [1.0, 2.0, 0.0]
links = 4
mass = 0.5
pinned = ["first"]
LINKS
[[seam]]
a = ["rope.1"]
b = ["rope.2"]
break_at = 0.2
)"},
    {"solids that swing", R"(
[[mass]]
name = "on_plane"
position = [20.0, -1.98, 0.0]
radius = 0.05
[[mass]]
name = "on_sphere"
position = [0.3, 1.007, 0.0]
radius = 0.05
[[mass]]
name = "on_capsule"
position = [5.0, 1.04, 0.0]
radius = 0.05
[[mass]]
name = "on_box"
position = [10.0, 0.54, 0.0]
radius = 0.05
[[plane]]
point = [0.0, -2.05, 0.0]
motion = { amplitude = [0.02, 0.01, 0.0], angular_frequency = 9.0, phase = 0.1 }
rotation = { axis = [0.0, 1.0, 0.0], rate = 20.0, rise = 0.1 }
[[sphere]]
centre = [0.0, 0.0, 0.0]
motion = { amplitude = [0.02, 0.01, 0.0], angular_frequency = 9.0, phase = 0.1 }
rotation = { axis = [0.0, 1.0, 0.0], rate = 20.0, rise = 0.1 }
[[capsule]]
from = [4.5, 0.0, 0.0]
to = [5.5, 0.0, 0.0]
motion = { amplitude = [0.02, 0.01, 0.0], angular_frequency = 9.0, phase = 0.1 }
rotation = { axis = [1.0, 0.2, 0.0], rate = 20.0, rise = 0.1 }
[[box]]
centre = [10.0, 0.0, 0.0]
motion = { amplitude = [0.02, 0.01, 0.0], angular_frequency = 9.0, phase = 0.1 }
rotation = { axis = [0.0, 1.0, 0.0], rate = 20.0, rise = 0.1 }
)"},
    {"solids that are led", R"(
[[mass]]
name = "on_plane"
position = [20.0, -1.98, 0.0]
radius = 0.05
[[mass]]
name = "on_sphere"
position = [0.3, 1.007, 0.0]
radius = 0.05
[[mass]]
name = "on_capsule"
position = [5.0, 1.04, 0.0]
radius = 0.05
[[mass]]
name = "on_box"
position = [10.0, 0.54, 0.0]
radius = 0.05
[[plane]]
point = [0.0, -2.05, 0.0]
motion = { path = [[0.0, 0.0, -2.05, 0.0], [0.3, 0.1, -2.0, 0.0]] }
rotation = { axis = [0.0, 1.0, 0.0], angle = [[0.0, 0.0], [0.3, 4.0]] }
[[sphere]]
centre = [0.0, 0.0, 0.0]
motion = { path = [[0.0, 0.0, 0.0, 0.0], [0.3, 0.1, 0.02, 0.0]] }
rotation = { axis = [0.0, 1.0, 0.0], angle = [[0.0, 0.0], [0.3, 4.0]] }
[[capsule]]
from = [4.5, 0.0, 0.0]
to = [5.5, 0.0, 0.0]
motion = { path = [[0.0, 5.0, 0.0, 0.0], [0.3, 5.1, 0.02, 0.0]] }
rotation = { axis = [1.0, 0.2, 0.0], angle = [[0.0, 0.0], [0.3, 4.0]] }
[[box]]
centre = [10.0, 0.0, 0.0]
motion = { path = [[0.0, 10.0, 0.0, 0.0], [0.3, 10.1, 0.02, 0.0]] }
rotation = { axis = [0.0, 1.0, 0.0], angle = [[0.0, 0.0], [0.3, 4.0]] }
)"},
    {"flag", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.4, 0.0]
mass = 0.1
pinned = ["left"]
LINKS
[wind]
velocity = [3.0, 0.0, 2.0]
gust = 0.3
gust_time = 0.1
)"},
    {"laid rope", R"(
[[chain]]
name = "rope"
points = [[0.0, 2.0, 0.0], [0.4, 1.8, 0.0], [0.8, 2.0, 0.1]]
links = 5
mass = 0.5
pinned = ["first"]
LINKS
)"},
    {"wound rope", R"(
[[capsule]]
from = [0.0, 1.0, 0.0]
to = [1.0, 1.0, 0.0]
radius = 0.2
[[sphere]]
centre = [0.0, 3.0, 0.0]
radius = 0.3
[[chain]]
name = "rope"
wound = { around = "capsule.0", turns = 2.0, start = 0.2, end = 0.8 }
links = 30
mass = 0.5
LINKS
)"},
    {"rope round a ball", R"(
[[sphere]]
centre = [0.0, 3.0, 0.0]
radius = 0.3
[[chain]]
name = "rope"
wound = { around = "sphere.0", turns = 2.0 }
links = 30
mass = 0.5
LINKS
)"},
    {"tied cloth", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
LINKS
[[chain]]
name = "rope"
from = [0.0, 2.1, 0.0]
to = [0.4, 2.1, 0.02]
links = 4
mass = 0.2
pinned = ["first"]
LINKS
[[tie]]
a = "cloth.0.*"
b = "rope.*"
stiffness = 200.0
)"},
    {"cloth moved at its top", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
pinned = ["top"]
top_motion = { amplitude = [0.01, 0.0, 0.01], angular_frequency = 8.0, phase = 0.0 }
LINKS
)"},
    {"cloth moved at its bottom", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
pinned = ["bottom"]
bottom_motion = { amplitude = [0.01, 0.0, 0.01], angular_frequency = 8.0, phase = 0.0 }
LINKS
)"},
    {"cloth moved at its left", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
pinned = ["left"]
left_motion = { amplitude = [0.01, 0.0, 0.01], angular_frequency = 8.0, phase = 0.0 }
LINKS
)"},
    {"cloth moved at its right", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
pinned = ["right"]
right_motion = { amplitude = [0.01, 0.0, 0.01], angular_frequency = 8.0, phase = 0.0 }
LINKS
)"},
    {"slack tie", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
LINKS
[[chain]]
name = "rope"
from = [0.0, 2.1, 0.0]
to = [0.4, 2.1, 0.02]
links = 4
mass = 0.2
pinned = ["first"]
LINKS
[[tie]]
a = "cloth.0.*"
b = "rope.*"
stiffness = 200.0
acts = "pull"
)"},
    {"loose tie", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
LINKS
[[chain]]
name = "rope"
from = [0.0, 2.1, 0.0]
to = [0.4, 2.1, 0.02]
links = 4
mass = 0.2
pinned = ["first"]
LINKS
[[tie]]
a = "cloth.0.*"
b = "rope.*"
stiffness = 200.0
acts = "between"
longest = 1.05
)"},
    {"tearing tie", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
LINKS
[[chain]]
name = "rope"
from = [0.0, 2.1, 0.0]
to = [0.4, 2.1, 0.02]
links = 4
mass = 0.2
pinned = ["first"]
LINKS
[[tie]]
a = "cloth.0.*"
b = "rope.*"
stiffness = 200.0
break_tension = 1.2
scatter = 0.3
[[load]]
masses = ["cloth.2.*"]
force = [1.0, -8.0, 1.0]
to = 0.3
)"},
    {"cloth carried at its top", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
pinned = ["top"]
top_motion = { with = "drum" }
LINKS
[[sphere]]
name = "drum"
centre = [0.0, -50.0, 0.0]
rotation = { axis = [0.0, 0.0, 1.0], rate = 1.0 }
[[sphere]]
name = "wheel"
centre = [9.0, -50.0, 0.0]
rotation = { axis = [0.0, 0.0, 1.0], rate = 2.0 }
)"},
    {"cloth carried at its bottom", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
pinned = ["bottom"]
bottom_motion = { with = "drum" }
LINKS
[[sphere]]
name = "drum"
centre = [0.0, -50.0, 0.0]
rotation = { axis = [0.0, 0.0, 1.0], rate = 1.0 }
[[sphere]]
name = "wheel"
centre = [9.0, -50.0, 0.0]
rotation = { axis = [0.0, 0.0, 1.0], rate = 2.0 }
)"},
    {"cloth carried at its left", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
pinned = ["left"]
left_motion = { with = "drum" }
LINKS
[[sphere]]
name = "drum"
centre = [0.0, -50.0, 0.0]
rotation = { axis = [0.0, 0.0, 1.0], rate = 1.0 }
[[sphere]]
name = "wheel"
centre = [9.0, -50.0, 0.0]
rotation = { axis = [0.0, 0.0, 1.0], rate = 2.0 }
)"},
    {"cloth carried at its right", R"(
[[sheet]]
name = "cloth"
rows = 3
columns = 3
from = [0.0, 2.0, 0.0]
to = [0.4, 2.0, 0.0]
down = [0.0, -0.2, 0.2]
mass = 0.3
pinned = ["right"]
right_motion = { with = "drum" }
LINKS
[[sphere]]
name = "drum"
centre = [0.0, -50.0, 0.0]
rotation = { axis = [0.0, 0.0, 1.0], rate = 1.0 }
[[sphere]]
name = "wheel"
centre = [9.0, -50.0, 0.0]
rotation = { axis = [0.0, 0.0, 1.0], rate = 2.0 }
)"},
};

}  // namespace taut::test
