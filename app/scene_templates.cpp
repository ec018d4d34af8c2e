#include "scene_templates.h"

#include <array>

namespace taut {
namespace {

constexpr std::string_view chain_scene =
    R"toml(# A chain between two pins, with a ball that hangs from its middle. Lengths are in metres, masses in kilograms.
title = "NAME"

[world]
duration = 5.0                # s, of the film
drag = 0.3                    # 1/s, the air: 0 lets it swing for ever
gravity = [0.0, -9.81, 0.0]   # m/s²; y is up

[solve]                       # leave this section out, and a method is chosen for you
method = "xpbd"               # one of `taut list methods`
steps_per_second = 1200       # more are more exact, and slower
passes = 2                    # over all links in each step

[[chain]]                     # its masses are rope.0 to rope.20
name = "rope"
from = [-1.0, 2.0, 0.0]       # m, where its ends are at the start
to = [1.0, 2.0, 0.0]
length = 2.4                  # m, more than from end to end: it sags
links = 20
mass = 0.5                    # kg, of the whole
pinned = ["first", "last"]    # ["first"] lets the other end go
# stiffness = 2000.0          # N/m, of each link; left out, links keep their length
# break_tension = 60.0        # N, at which a link breaks

[[mass]]
name = "ball"
position = [0.3, 1.2, 0.0]    # m
velocity = [1.0, 0.0, 0.5]    # m/s, a push
mass = 0.5                    # kg

[[link]]                      # any two masses can be linked
a = "rope.10"
b = "ball"

[camera]                      # leave it out, and all of the motion is in the picture
direction = [0.2, 0.1, 1.0]   # from where it is seen
show = [[-1.3, 0.2, -0.3], [1.3, 2.35, 0.3]]  # m, two corners of a box that is to be seen

[look]                        # what is seen of it; it changes no motion
link_shape = "rope"           # or "chain", or "rod"
link_colour = "#b08850"       # or a name, such as "teal"
weights = true                # the heavier, the larger
)toml";

constexpr std::string_view sheet_scene =
    R"toml(# A cloth hangs by its upper edge in the wind. Lengths are in metres, masses in kilograms.
title = "NAME"

[world]
duration = 6.0                # s, of the film
drag = 0.2                    # 1/s
gravity = [0.0, -9.81, 0.0]   # m/s²; y is up

[wind]                        # leave this section out, and the air is gone
velocity = [1.0, 0.0, 4.0]    # m/s
gust = 0.5                    # share of the velocity by which it changes

[solve]                       # leave this section out, and a method is chosen for you
method = "xpbd"               # one of `taut list methods`
steps_per_second = 1200       # more are more exact, and slower
passes = 1                    # over all links in each step

[[sheet]]                     # its masses are cloth.ROW.COLUMN, from cloth.0.0 on
name = "cloth"
rows = 24
columns = 24
from = [-0.6, 2.0, 0.0]       # m, the ends of its upper edge
to = [0.6, 2.0, 0.0]
down = [0.0, -1.2, 0.0]       # m, from there to its lower edge
mass = 0.3                    # kg, of the whole
pinned = ["top"]              # or "left", "bottom-right", and so on
diagonals = { stiffness = 60.0, damping = 0.05 }  # N/m, N s/m: against shear
skip_one = { stiffness = 0.5, damping = 0.02 }    # N/m, N s/m: against bending
# colour = "teal"

# [[sphere]]                  # something to fall against
# centre = [0.0, 0.9, 0.5]    # m
# radius = 0.3                # m

[look]                        # what is seen of it; it changes no motion
surface = true
masses = false
links = false
)toml";

constexpr std::string_view ragdoll_scene =
    R"toml(# A body falls onto the floor. Lengths are in metres, masses in kilograms, angles in degrees.
title = "NAME"

[world]
duration = 4.0                # s, of the film
gravity = [0.0, -9.81, 0.0]   # m/s²; y is up

[solve]                       # leave this section out, and a method is chosen for you
method = "xpbd"               # one of `taut list methods`
steps_per_second = 2400       # more are more exact, and slower
passes = 4                    # over all links in each step

[[ragdoll]]
name = "doll"
height = 1.75                 # m
mass = 75.0                   # kg
position = [0.0, 1.5, 0.0]    # m, of the middle of the hips
turn = [20.0, 60.0, 0.0]      # degrees about x, then y, then z; unturned it stands and looks along z
velocity = [1.0, 0.0, 0.0]    # m/s
spin = [0.0, 0.0, -1.5]       # rad/s
joint_damping = 1.5           # 1/s: a limb that swings loses half its speed in half a second
joint_friction = 0.1          # share of what holds a limb out level
pose = { left_shoulder = 30, right_shoulder = 30, left_elbow = 30, right_elbow = 30, left_knee = -20, right_knee = -40 }
# pinned = ["left_hand"]      # what it is held by

[[plane]]                     # the floor, at y = 0
friction = 0.6

[[box]]                       # a step
centre = [0.9, 0.15, 0.0]     # m
size = [0.6, 0.3, 2.0]        # m
friction = 0.6
)toml";

}  // namespace

std::span<const SceneTemplate> scene_templates() {
  static constexpr std::array<SceneTemplate, 3> templates{{
      {"chain", chain_scene, "--colour tension"},
      {"sheet", sheet_scene, "--set 'wind.velocity=[0,0,8]'"},
      {"ragdoll", ragdoll_scene, "--colour limit"},
  }};
  return templates;
}

}  // namespace taut
