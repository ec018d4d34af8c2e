#pragma once

#include <fmt/format.h>

#include <map>
#include <string>

#include "scene_key_cases.h"

namespace taut::test {

/// Small scenes in which keys of meshes and of points matter, as key_scenes. FILES stands for the folder of
/// their files.
inline std::map<std::string, std::string> key_file_scenes() {
  const std::string mesh =
      "[[mesh]]\nname = \"cloth\"\nfile = \"FILES/cloth.obj\"\nposition = [0.0, 2.0, 0.0]\nmass = 0.3\n";
  const std::string points =
      "[[points]]\nname = \"net\"\nmasses = \"FILES/masses.csv\"\nlinks = \"FILES/links.csv\"\nmass = 0.2\n";
  const std::string pull = "acts = \"pull\"", between = "acts = \"between\", longest = 1.05";
  const std::string tear = "break_tension = 0.8, scatter = 0.3";
  const auto lines = [](std::string text) {
    const std::size_t comma = text.find(", ");
    return comma == std::string::npos ? text : text.replace(comma, 2, "\n");
  };
  const auto soft_mesh = [&](const std::string& more) {
    const std::string inner = more.empty() ? "" : ", " + more;
    return fmt::format(
        "{}pinned_masses = [0]\nstiffness = 100.0\n{}\ndiagonals = {{ stiffness = 50.0{} }}\nskip_one = "
        "{{ stiffness = 50.0{} }}\n",
        mesh, lines(more), inner, inner);
  };
  const std::string pulled =
      "[[load]]\nmasses = [\"cloth.2\", \"cloth.5\", \"cloth.8\", \"cloth.7\"]\nforce = [8.0, -4.0, "
      "4.0]\nto = 0.3\n";
  const std::string pulled_net =
      "stiffness = 100.0\n[[load]]\nmasses = [\"net.d\"]\nforce = [8.0, -4.0, 4.0]\nto = 0.3\n";
  const std::string block =
      "[[mass]]\nname = \"on_it\"\nposition = [0.47, 0.56, 0.0]\nvelocity = [0.2, 0.0, 0.0]\nradius = "
      "0.05\n[[solid]]\nfile = \"FILES/block.obj\"\n";
  return {
      {"solid", block},
      {"solid that swings",
       block + "motion = { amplitude = [0.02, 0.01, 0.0], angular_frequency = 9.0, phase = 0.1 }\n"
               "rotation = { axis = [0.0, 1.0, 0.0], rate = 20.0, rise = 0.1 }\n"},
      {"solid that is led", block +
                                "motion = { path = [[0.0, 0.0, 0.0, 0.0], [0.3, 0.1, 0.0, 0.0]] }\n"
                                "rotation = { axis = [0.0, 0.0, 1.0], angle = [[0.0, 0.0], [0.3, 5.0]] }\n"},
      {"mesh", mesh + "pinned_masses = [0]\nLINKS\n"},
      {"welded mesh", mesh + "pinned_masses = [0]\nLINKS\n"},
      {"springy mesh", soft_mesh("")},
      {"slack mesh", soft_mesh(pull)},
      {"loose mesh", soft_mesh(between)},
      {"tearing mesh", soft_mesh(tear) + pulled},
      {"stiff mesh",
       "[[mesh]]\nname = \"cloth\"\nfile = \"FILES/bent.obj\"\nposition = [0.0, 2.0, 0.0]\nmass = 0.3\n"
       "pinned_masses = [0, 4]\nbending = { stiffness = 0.001 }\nLINKS\n"},
      {"moved mesh", mesh + "pinned_masses = [0, 1, 2]\nmotion = { amplitude = [0.01, 0.0, 0.01], "
                            "angular_frequency = 8.0, phase "
                            "= 0.0 }\nLINKS\n"},
      {"led mesh", mesh + "pinned_masses = [0, 1, 2]\nmotion = { path = [[0.0, 0.0, 2.0, 0.0], [0.3, 0.0, "
                          "2.0, 0.1]] }\nLINKS\n"},
      {"carried mesh", mesh + "pinned_masses = [0, 1, 2]\nmotion = { with = \"drum\" }\nLINKS\n"
                              "[[sphere]]\nname = \"drum\"\ncentre = [0.0, -50.0, 0.0]\nrotation = { axis = "
                              "[0.0, 0.0, 1.0], rate = "
                              "1.0 }\n[[sphere]]\nname = \"wheel\"\ncentre = [9.0, -50.0, 0.0]\nrotation = { "
                              "axis = [0.0, 0.0, 1.0], "
                              "rate = 2.0 }\n"},
      {"mesh on a ball",
       "[[mesh]]\nname = \"cloth\"\nfile = \"FILES/level.obj\"\nposition = [0.0, 1.12, 0.0]\nradius = "
       "0.05\ncollides = "
       "true\nLINKS\n[[sphere]]\ncentre = [0.0, 0.0, 0.0]\n[[mass]]\nname = \"ball\"\nposition = [0.0, 1.3, "
       "0.02]\nradius = 0.1\ncollides = true\n"},
      {"crumpled mesh",
       "[[mesh]]\nname = \"cloth\"\nfile = \"FILES/strip.obj\"\nposition = [0.0, 0.38, 0.0]\nfaces = { "
       "thickness = 0.012 "
       "}\nLINKS\n[[plane]]\n"},
      {"points", points + "LINKS\n"},
      {"springy points", points + "stiffness = 100.0\n"},
      {"slack points", points + "stiffness = 100.0\n" + pull + "\n"},
      {"loose points", points + "stiffness = 100.0\n" + lines(between) + "\n"},
      {"tearing points", points + lines(tear) + "\n" + pulled_net},
      {"points on a ball",
       points +
           "position = [0.0, -0.9, 0.0]\nradius = 0.08\ncollides = true\nLINKS\n[[sphere]]\ncentre = [0.4, "
           "0.0, "
           "0.0]\n[[mass]]\nname = \"ball\"\nposition = [0.45, 1.3, 0.02]\nradius = 0.1\ncollides = true\n"},
  };
}

/// The cases of those keys.
inline void add_file_cases(std::map<std::string, KeyCase>& all) {
  all["mesh.file"] = {"mesh", "FILES/other.obj", ""};
  all["mesh.mass"] = {"springy mesh", "0.4", ""};
  all["mesh.shares"] = {"springy mesh", "equal", ""};
  all["mesh.scale"] = {"mesh", "1.1", ""};
  all["mesh.up"] = {"mesh", "z", ""};
  all["mesh.position"] = {"mesh", "[0.0, 2.0, 0.1]", ""};
  all["mesh.turn"] = {"mesh", "[10.0, 0.0, 0.0]", ""};
  all["mesh.weld"] = {"welded mesh", "0.155", ""};
  all["mesh.pinned"] = {"mesh", R"(["corner"])", ""};
  all["mesh.pinned_box"] = {"mesh", "[[-0.1, 1.99, -0.1], [0.5, 2.01, 0.1]]", ""};
  all["mesh.pinned_masses"] = {"mesh", "[2]", ""};
  all["mesh.release"] = {"mesh", "0.1", ""};
  all["mesh.radius"] = {"mesh on a ball", "0.04", ""};
  all["mesh.collides"] = {"mesh on a ball", "false", ""};
  all["mesh.diagonals"] = {"springy mesh", "false", ""};
  all["mesh.skip_one"] = {"springy mesh", "false", ""};
  all["mesh.bending"] = {"stiff mesh", "{ stiffness = 0.002 }", ""};
  all["mesh.bending.stiffness"] = {"stiff mesh", "0.002", ""};
  all["mesh.bending.from_start"] = {"stiff mesh", "true", ""};
  all["mesh.faces"] = {"crumpled mesh", "{ thickness = 0.01 }", ""};
  all["mesh.faces.thickness"] = {"crumpled mesh", "0.01", ""};
  all["mesh.faces.friction"] = {"crumpled mesh", "0.1", ""};
  all["mesh.faces.self_collides"] = {"crumpled mesh", "false", ""};
  all["mesh.motion"] = {"moved mesh", "{ path = [[0.0, 0.0, 2.0, 0.0], [0.3, 0.0, 2.0, 0.1]] }", ""};
  all["mesh.motion.amplitude"] = {"moved mesh", "[0.02, 0.0, 0.0]", ""};
  all["mesh.motion.angular_frequency"] = {"moved mesh", "7.0", ""};
  all["mesh.motion.phase"] = {"moved mesh", "0.02", ""};
  all["mesh.motion.path"] = {"led mesh", "[[0.0, 0.0, 2.0, 0.0], [0.3, 0.0, 2.0, 0.2]]", ""};
  all["mesh.motion.with"] = {"carried mesh", "wheel", ""};
  all["solid.file"] = {"solid", "FILES/other-block.obj", ""};
  all["solid.scale"] = {"solid", "0.99", ""};
  all["solid.up"] = {"solid", "z", ""};
  all["solid.position"] = {"solid", "[0.0, -0.01, 0.0]", ""};
  all["solid.turn"] = {"solid", "[0.0, 0.0, -5.0]", ""};
  all["solid.weld"] = {"solid", "0.08", ""};
  all["solid.friction"] = {"solid", "0.1", ""};
  all["solid.restitution"] = {"solid", "0.5", ""};
  all["solid.motion"] = {"solid that swings", "{ amplitude = [0.03, 0.01, 0.0], angular_frequency = 9.0 }",
                         ""};
  all["solid.motion.amplitude"] = {"solid that swings", "[0.03, 0.01, 0.0]", ""};
  all["solid.motion.angular_frequency"] = {"solid that swings", "8.0", ""};
  all["solid.motion.phase"] = {"solid that swings", "0.2", ""};
  all["solid.motion.path"] = {"solid that is led", "[[0.0, 0.0, 0.0, 0.0], [0.3, 0.2, 0.0, 0.0]]", ""};
  all["solid.rotation"] = {"solid that swings", "{ axis = [0.0, 0.1, 1.0], rate = 20.0 }", ""};
  all["solid.rotation.axis"] = {"solid that swings", "[0.1, 1.0, 0.2]", ""};
  all["solid.rotation.through"] = {"solid that swings", "[0.1, 0.0, 0.1]", ""};
  all["solid.rotation.rate"] = {"solid that swings", "40.0", ""};
  all["solid.rotation.rise"] = {"solid that swings", "0.2", ""};
  all["solid.rotation.angle"] = {"solid that is led", "[[0.0, 0.0], [0.3, 9.0]]", ""};
  all["points.masses"] = {"points", "FILES/other-masses.csv", ""};
  all["points.links"] = {"points", "FILES/other-links.csv", ""};
  all["points.position"] = {"points", "[0.0, 0.1, 0.0]", ""};
  all["points.turn"] = {"points", "[0.0, 0.0, 10.0]", ""};
  all["points.mass"] = {"springy points", "0.3", ""};
  all["points.pinned"] = {"points", R"(["d"])", ""};
  all["points.radius"] = {"points on a ball", "0.07", ""};
  all["points.collides"] = {"points on a ball", "false", ""};
  for (const std::string of : {"mesh.", "mesh.diagonals.", "mesh.skip_one.", "points."}) {
    const std::string kind = of.substr(0, of.find('.'));
    all[of + "acts"] = {"slack " + kind, "push", ""};
    all[of + "longest"] = {"loose " + kind, "1.01", ""};
    all[of + "break_at"] = {"springy " + kind, "0.1", ""};
    all[of + "scatter"] = {"tearing " + kind, "0.9", ""};
    all[of + "scatter_seed"] = {"tearing " + kind, "3", ""};
    all[of + "stiffness"] = {"springy " + kind, "60.0", ""};
    all[of + "damping"] = {"springy " + kind, "1.0", ""};
    all[of + "break_stretch"] = {"springy " + kind, "1.01", ""};
    all[of + "break_tension"] = {"springy " + kind, "0.1", ""};
  }
}

}  // namespace taut::test
