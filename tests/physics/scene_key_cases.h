#pragma once

#include <fmt/format.h>

#include <map>
#include <string>

namespace taut::test {

/// A key's scene, and a change of it that must matter.
struct KeyCase {
  std::string scene, value;
  std::string at;  // the path to set, where it is not the key's own
};

/// The case of each key about physics, as section.key.
inline std::map<std::string, KeyCase> key_cases() {
  std::map<std::string, KeyCase> all{
      {"world.gravity", {"rope", "[0.0, -9.0, 0.0]", ""}},
      {"world.drag", {"rope", "0.5", ""}},
      {"chain.from", {"rope", "[0.0, 2.0, 0.1]", ""}},
      {"chain.to", {"rope", "[1.0, 2.1, 0.0]", ""}},
      {"chain.links", {"rope", "5", ""}},
      {"chain.points", {"laid rope", "[[0.0, 2.0, 0.0], [0.4, 1.9, 0.0], [0.8, 2.0, 0.1]]", ""}},
      {"chain.smooth", {"laid rope", "true", ""}},
      {"chain.wound", {"wound rope", R"({ around = "sphere.0", turns = 2.0 })", ""}},
      {"chain.wound.around", {"wound rope", "sphere.0", ""}},
      {"chain.wound.turns", {"wound rope", "-2.0", ""}},
      {"chain.wound.start", {"wound rope", "0.1", ""}},
      {"chain.wound.end", {"wound rope", "0.9", ""}},
      {"chain.wound.axis", {"rope round a ball", "[1.0, 0.0, 0.0]", ""}},
      {"chain.length", {"rope", "1.1", ""}},
      {"chain.mass", {"rope", "0.6", ""}},
      {"chain.last_mass", {"rope", "0.3", ""}},
      {"chain.pinned", {"rope", R"(["last"])", ""}},
      {"chain.radius", {"ropes that meet", "0.08", ""}},
      {"chain.collides", {"ropes that meet", "false", ""}},
      {"chain.stiffness", {"springy rope", "600.0", ""}},
      {"chain.damping", {"springy rope", "2.0", ""}},
      {"chain.break_stretch", {"springy rope", "1.05", ""}},
      {"chain.break_tension", {"springy rope", "6.0", ""}},
      {"sheet.rows", {"cloth", "4", ""}},
      {"sheet.columns", {"cloth", "4", ""}},
      {"sheet.from", {"cloth", "[0.0, 2.1, 0.0]", ""}},
      {"sheet.to", {"cloth", "[0.4, 2.1, 0.0]", ""}},
      {"sheet.down", {"cloth", "[0.0, -0.3, 0.2]", ""}},
      {"sheet.mass", {"cloth", "0.4", ""}},
      {"sheet.pinned", {"cloth", R"(["top-right"])", ""}},
      {"sheet.fullness", {"curtain", "1.3", ""}},
      {"sheet.hooks", {"curtain", "{ every = 6, draw = [[0.0, 1.0], [0.3, 0.9]] }", ""}},
      {"sheet.hooks.every", {"curtain", "6", ""}},
      {"sheet.hooks.draw", {"curtain", "[[0.0, 1.0], [0.3, 0.8]]", ""}},
      {"sheet.radius", {"sheet on a ball", "0.04", ""}},
      {"sheet.collides", {"sheet on a ball", "false", ""}},
      {"sheet.faces", {"crumpled cloth", "{ thickness = 0.01 }", ""}},
      {"sheet.faces.thickness", {"crumpled cloth", "0.01", ""}},
      {"sheet.faces.friction", {"crumpled cloth", "0.1", ""}},
      {"sheet.faces.self_collides", {"crumpled cloth", "false", ""}},
      {"sheet.stiffness", {"springy cloth", "120.0", ""}},
      {"sheet.damping", {"springy cloth", "1.0", ""}},
      {"sheet.break_stretch", {"springy cloth", "1.02", ""}},
      {"sheet.break_tension", {"springy cloth", "0.3", ""}},
      {"sheet.diagonals", {"springy cloth", "false", ""}},
      {"sheet.diagonals.stiffness", {"springy cloth", "60.0", ""}},
      {"sheet.diagonals.damping", {"springy cloth", "1.0", ""}},
      {"sheet.diagonals.break_stretch", {"springy cloth", "1.01", ""}},
      {"sheet.diagonals.break_tension", {"springy cloth", "0.1", ""}},
      {"sheet.skip_one", {"springy cloth", "false", ""}},
      {"sheet.skip_one.stiffness", {"springy cloth", "60.0", ""}},
      {"sheet.skip_one.damping", {"springy cloth", "1.0", ""}},
      {"sheet.skip_one.break_stretch", {"springy cloth", "1.01", ""}},
      {"sheet.skip_one.break_tension", {"springy cloth", "0.1", ""}},
      {"mass.position", {"pendulum", "[1.0, 2.1, 0.0]", "mass.bob.position"}},
      {"mass.velocity", {"pendulum", "[0.0, 1.0, 0.0]", "mass.bob.velocity"}},
      {"mass.mass", {"pendulum", "2.0", "mass.bob.mass"}},
      {"mass.pinned", {"pendulum", "false", "mass.hook.pinned"}},
      {"mass.motion", {"swung pendulum", "{ path = [[0.0, 0.0, 2.0, 0.0], [0.3, 0.2, 2.0, 0.0]] }", ""}},
      {"mass.motion.amplitude", {"swung pendulum", "[0.02, 0.0, 0.0]", ""}},
      {"mass.motion.angular_frequency", {"swung pendulum", "7.0", ""}},
      {"mass.motion.phase", {"swung pendulum", "0.02", ""}},
      {"mass.motion.path",
       {"swung pendulum", "{ path = [[0.0, 0.0, 2.0, 0.0], [0.3, 0.1, 2.0, 0.0]] }", "mass.hook.motion"}},
      {"mass.radius", {"balls that meet", "0.12", ""}},
      {"mass.collides", {"balls that meet", "false", ""}},
      {"link.a", {"pendulum", "hook", "link.1.a"}},
      {"link.b", {"pendulum", "bob", "link.0.b"}},
      {"link.length", {"springy pendulum", "0.52", ""}},
      {"link.stiffness", {"springy pendulum", "600.0", ""}},
      {"link.damping", {"springy pendulum", "5.0", ""}},
      {"link.break_stretch", {"springy pendulum", "1.05", ""}},
      {"link.break_tension", {"springy pendulum", "10.0", ""}},
      {"tie.a", {"tied cloth", "cloth.*.0", ""}},
      {"tie.b", {"tied cloth", "rope.0", ""}},
      {"tie.every", {"tied cloth", "2", ""}},
      {"tie.stiffness", {"tied cloth", "100.0", ""}},
      {"tie.damping", {"tied cloth", "2.0", ""}},
      {"tie.break_stretch", {"tied cloth", "1.005", ""}},
      {"tie.break_tension", {"tied cloth", "0.1", ""}},
      {"load.masses", {"rope", R"(["rope.3"])", ""}},
      {"load.force", {"rope", "[0.0, 0.3, 0.8]", ""}},
      {"load.from", {"rope", "0.08", ""}},
      {"load.to", {"rope", "0.2", ""}},
      {"ragdoll.height", {"doll", "1.8", ""}},
      {"ragdoll.mass", {"doll", "70.0", ""}},
      {"ragdoll.position", {"doll", "[0.0, 1.1, 0.0]", ""}},
      {"ragdoll.turn", {"doll", "[10.0, 0.0, 0.0]", ""}},
      {"ragdoll.velocity", {"doll", "[0.4, 0.0, 0.0]", ""}},
      {"ragdoll.spin", {"doll", "[0.0, 2.0, 0.0]", ""}},
      {"ragdoll.pose", {"doll", "{ neck = -10.0 }", ""}},
      {"ragdoll.ranges", {"doll", "{ elbow = [9.0, 11.0] }", ""}},
      {"ragdoll.joint_damping", {"doll", "1.0", ""}},
      {"ragdoll.joint_friction", {"doll", "0.1", ""}},
      {"ragdoll.pinned", {"doll", R"(["right_hand"])", ""}},
      {"ragdoll.collides", {"doll on a ball", "false", ""}},
      {"angle.masses", {"angle", R"(["d", "b", "c"])", ""}},
      {"angle.min", {"angle", "172.0", ""}},
      {"angle.max", {"angle", "174.6", ""}},
      {"angle.compliance", {"angle", "0.01", ""}},
      {"hinge.masses", {"hinge", R"(["f", "b", "c"])", ""}},
      {"hinge.axis", {"hinge", R"(["b", "d"])", ""}},
      {"hinge.min", {"hinge", "-3.0", ""}},
      {"hinge.max", {"hinge", "3.0", ""}},
      {"hinge.compliance", {"hinge", "0.01", ""}},
      {"cone.frame", {"cone", R"(["e", "a", "d"])", ""}},
      {"cone.limb", {"cone", R"(["b", "c", "e"])", ""}},
      {"cone.axis", {"cone", "[1.0, 0.05, 0.0]", ""}},
      {"cone.half_angle", {"cone", "8.0", ""}},
      {"cone.compliance", {"cone", "0.01", ""}},
      {"plane.point", {"ground", "[0.0, 0.01, 0.0]", ""}},
      {"plane.normal", {"ground", "[0.1, 1.0, 0.0]", ""}},
      {"plane.friction", {"ground", "0.2", ""}},
      {"plane.restitution", {"ground", "0.5", ""}},
      {"sphere.centre", {"solids", "[0.0, 0.01, 0.0]", ""}},
      {"sphere.radius", {"solids", "0.98", ""}},
      {"sphere.friction", {"solids", "0.1", ""}},
      {"sphere.restitution", {"solids", "0.5", ""}},
      {"capsule.from", {"solids", "[4.5, 0.01, 0.0]", ""}},
      {"capsule.to", {"solids", "[5.5, 0.01, 0.0]", ""}},
      {"capsule.radius", {"solids", "0.98", ""}},
      {"capsule.friction", {"solids", "0.1", ""}},
      {"capsule.restitution", {"solids", "0.5", ""}},
      {"box.centre", {"solids", "[10.0, 0.01, 0.0]", ""}},
      {"box.size", {"solids", "[1.0, 1.02, 1.0]", ""}},
      {"box.turn", {"solids", "[0.0, 0.0, 5.0]", ""}},
      {"box.friction", {"solids", "0.1", ""}},
      {"box.restitution", {"solids", "0.5", ""}},
      {"wind.velocity", {"flag", "[3.0, 0.0, 3.0]", ""}},
      {"wind.gust", {"flag", "0.5", ""}},
      {"wind.gust_time", {"flag", "0.2", ""}},
      {"wind.seed", {"flag", "2", ""}},
      {"wind.density", {"flag", "1.0", ""}},
      {"wind.drag_coefficient", {"flag", "1.0", ""}},
  };
  const auto add_link_keys = [&all](const std::string& of, const std::string& slack, const std::string& loose,
                                    const std::string& timed, const std::string& tearing) {
    all[of + "acts"] = {slack, "push", ""};
    all[of + "longest"] = {loose, "1.01", ""};
    all[of + "break_at"] = {timed, "0.1", ""};
    all[of + "scatter"] = {tearing, "0.9", ""};
    all[of + "scatter_seed"] = {tearing, "3", ""};
  };
  add_link_keys("chain.", "slack rope", "loose rope", "rope", "tearing rope");
  add_link_keys("link.", "slack pendulum", "loose pendulum", "pendulum", "tearing pendulum");
  add_link_keys("sheet.", "slack cloth", "loose cloth", "cloth", "tearing cloth");
  for (const std::string family : {"weft", "diagonals", "skip_one"})
    add_link_keys("sheet." + family + ".", "slack cloth", "loose cloth",
                  family == "weft" ? "cloth of warp and weft" : "springy cloth", "tearing cloth");
  add_link_keys("tie.", "slack tie", "loose tie", "tied cloth", "tearing tie");
  all["sheet.weft"] = {"springy cloth", "{ stiffness = 60.0 }", ""};
  all["sheet.weft.stiffness"] = {"cloth of warp and weft", "60.0", ""};
  all["sheet.weft.damping"] = {"cloth of warp and weft", "1.0", ""};
  all["sheet.weft.break_stretch"] = {"cloth of warp and weft", "1.01", ""};
  all["sheet.weft.break_tension"] = {"cloth of warp and weft", "0.1", ""};
  all["chain.first_release"] = {"rope", "0.1", ""};
  all["chain.last_release"] = {"swung rope", "0.1", ""};
  all["sheet.release"] = {"cloth", "0.1", ""};
  all["mass.release"] = {"pendulum", "0.1", "mass.hook.release"};
  all["load.until"] = {"rope with a load that ends", "0.15", ""};
  all["load.gone"] = {"rope with a load that ends", "0.25", ""};
  all["chain.bending"] = {"bent rope", "{ stiffness = 0.1 }", ""};
  all["chain.bending.stiffness"] = {"bent rope", "0.1", ""};
  all["chain.bending.from_start"] = {"bent rope", "true", ""};
  all["sheet.bending"] = {"stiff cloth", "{ stiffness = 0.002 }", ""};
  all["sheet.bending.stiffness"] = {"stiff cloth", "0.002", ""};
  all["sheet.bending.bias"] = {"stiff cloth", "0.001", ""};
  all["sheet.bending.from_start"] = {"stiff cloth", "true", ""};
  all["sheet.bending.warp"] = {"cloth stiff along warp and weft", "0.002", ""};
  all["sheet.bending.weft"] = {"cloth stiff along warp and weft", "0.002", ""};
  all["seam.sheet"] = {"seam in a cloth", "other", ""};
  all["seam.row"] = {"seam in a cloth", "0", ""};
  all["seam.column"] = {"seam in a cloth", "0", "seam.1.column"};
  all["seam.strength"] = {"seam in a cloth", "0.4", ""};
  all["seam.a"] = {"seam between masses", R"(["cloth.1.0"])", ""};
  all["seam.b"] = {"seam between masses", R"(["cloth.2.0"])", ""};
  all["seam.break_stretch"] = {"seam between masses", "1.03", ""};
  all["seam.break_tension"] = {"seam between masses", "0.6", ""};
  all["seam.break_at"] = {"seam that opens", "0.1", ""};
  all["mass.motion.with"] = {"carried rope", "wheel", "mass.hook.motion.with"};
  for (const std::string end : {"first", "last"})
    all["chain." + end + "_motion.with"] = {"carried rope", "wheel", ""};
  for (const std::string solid : {"plane", "sphere", "capsule", "box"}) {
    all[solid + ".motion"] = {"solids that swing",
                              "{ amplitude = [0.03, 0.01, 0.0], angular_frequency = 9.0 }", ""};
    all[solid + ".motion.amplitude"] = {"solids that swing", "[0.03, 0.01, 0.0]", ""};
    all[solid + ".motion.angular_frequency"] = {"solids that swing", "8.0", ""};
    all[solid + ".motion.phase"] = {"solids that swing", "0.2", ""};
    const double x = solid == "capsule" ? 5.0
                     : solid == "box"   ? 10.0
                                        : 0.0,
                 y = solid == "plane" ? -2.05 : 0.0;
    all[solid + ".motion.path"] = {"solids that are led",
                                   fmt::format("[[0.0, {0}, {1}, 0.0], [0.3, {2}, {1}, 0.0]]", x, y, x + 0.2),
                                   ""};
    all[solid + ".rotation"] = {"solids that swing", "{ axis = [0.0, 0.1, 1.0], rate = 20.0 }", ""};
    all[solid + ".rotation.axis"] = {"solids that swing", "[0.1, 1.0, 0.2]", ""};
    all[solid + ".rotation.through"] = {"solids that swing", "[0.1, 0.0, 0.1]", ""};
    all[solid + ".rotation.rate"] = {"solids that swing", "40.0", ""};
    all[solid + ".rotation.rise"] = {"solids that swing", "0.2", ""};
    all[solid + ".rotation.angle"] = {"solids that are led", "[[0.0, 0.0], [0.3, 9.0]]", ""};
  }
  for (const std::string end : {"first", "last"}) {
    const std::string key = "chain." + end + "_motion", x = end == "first" ? "0.0" : "0.9";
    all[key] = {"swung rope", fmt::format("{{ path = [[0.0, {0}, 2.0, 0.0], [0.3, {0}, 2.1, 0.0]] }}", x),
                ""};
    all[key + ".amplitude"] = {"swung rope", "[0.02, 0.0, 0.0]", ""};
    all[key + ".angular_frequency"] = {"swung rope", "7.0", ""};
    all[key + ".phase"] = {"swung rope", "0.02", ""};
    all[key + ".path"] = {"led rope", fmt::format("[[0.0, {0}, 2.0, 0.0], [0.3, {0}, 2.1, 0.0]]", x), ""};
  }
  for (const std::string edge : {"top", "bottom", "left", "right"}) {
    const std::string key = "sheet." + edge + "_motion", scene = "cloth moved at its " + edge;
    const double x = edge == "right" ? 0.4 : 0.0, y = edge == "bottom" ? 1.8 : 2.0, z = 2.0 - y;
    const std::string led =
        fmt::format("{{ path = [[0.0, {}, {}, {}], [0.3, {}, {}, {}]] }}", x, y, z, x, y + 0.02, z + 0.02);
    all[key] = {scene, led, ""};
    all[key + ".amplitude"] = {scene, "[0.02, 0.0, 0.0]", ""};
    all[key + ".angular_frequency"] = {scene, "7.0", ""};
    all[key + ".phase"] = {scene, "0.02", ""};
    all[key + ".path"] = {scene, led, fmt::format("sheet.0.{}_motion", edge)};
    all[key + ".with"] = {"cloth carried at its " + edge, "wheel", ""};
  }
  for (const std::string joint :
       {"neck", "left_shoulder", "right_shoulder", "left_elbow", "right_elbow", "left_hip", "right_hip",
        "left_shoulder_out", "right_shoulder_out", "left_hip_out", "right_hip_out"})
    all["ragdoll.pose." + joint] = {"doll", "12.0", ""};
  for (const std::string joint : {"left_knee", "right_knee"})
    all["ragdoll.pose." + joint] = {"doll", "-12.0", ""};
  all["ragdoll.ranges.neck"] = {"doll", "[-1.0, 1.0]", ""};
  all["ragdoll.ranges.elbow"] = {"doll", "[9.0, 11.0]", ""};
  all["ragdoll.ranges.knee"] = {"doll", "[-9.0, -7.0]", ""};
  all["ragdoll.ranges.shoulder"] = {"doll", "70.0", ""};
  all["ragdoll.ranges.hip"] = {"doll with legs drawn back", "28.0", ""};
  all["ragdoll.ranges.hip_twist"] = {"doll", "4.0", ""};
  all["ragdoll.ranges.wrist"] = {"doll", "1.0", ""};
  all["ragdoll.ranges.ankle"] = {"doll", "1.0", ""};
  return all;
}

}  // namespace taut::test
