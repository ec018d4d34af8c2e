#include "object_section.h"
#include "physics_facts.h"

namespace taut {
namespace {

Key<PoseSpec> pose_key(std::string_view name, double PoseSpec::*member, std::string_view help) {
  return key<PoseSpec>(name, member, {.unit = "degrees", .range = between(-180, 180), .help = help});
}

const Keys<PoseSpec>& pose_keys() {
  static const Keys<PoseSpec> keys{
      pose_key("neck", &PoseSpec::neck, "backward, forward is negative"),
      pose_key("left_shoulder", &PoseSpec::left_shoulder, "forward, from hanging down"),
      pose_key("right_shoulder", &PoseSpec::right_shoulder, "forward, from hanging down"),
      pose_key("left_shoulder_out", &PoseSpec::left_shoulder_out, "sideways, away from the body"),
      pose_key("right_shoulder_out", &PoseSpec::right_shoulder_out, "sideways, away from the body"),
      pose_key("left_elbow", &PoseSpec::left_elbow, "forward, from straight"),
      pose_key("right_elbow", &PoseSpec::right_elbow, "forward, from straight"),
      pose_key("left_hip", &PoseSpec::left_hip, "forward, from standing"),
      pose_key("right_hip", &PoseSpec::right_hip, "forward, from standing"),
      pose_key("left_hip_out", &PoseSpec::left_hip_out, "sideways, away from the body"),
      pose_key("right_hip_out", &PoseSpec::right_hip_out, "sideways, away from the body"),
      pose_key("left_knee", &PoseSpec::left_knee, "forward, from straight: knees bend to the negative side"),
      pose_key("right_knee", &PoseSpec::right_knee, "forward, from straight"),
  };
  return keys;
}

constexpr Facts range_of_hinge(std::string_view help) {
  return {.unit = "degrees", .range = between(-180, 180), .help = help};
}
constexpr Facts half_angle(std::string_view help) {
  return {.unit = "degrees", .range = above_to(0, 180), .help = help};
}

const Keys<RangeSpec>& range_keys() {
  static const Keys<RangeSpec> keys{
      key<RangeSpec>("neck", &RangeSpec::neck, range_of_hinge("[forward, backward]")),
      key<RangeSpec>("elbow", &RangeSpec::elbow, range_of_hinge("[least, most] bent")),
      key<RangeSpec>("knee", &RangeSpec::knee, range_of_hinge("[most, least] bent, negative")),
      key<RangeSpec>("shoulder", &RangeSpec::shoulder,
                     half_angle("about a line 67.5 degrees forward of down and 30 outward")),
      key<RangeSpec>("hip", &RangeSpec::hip,
                     half_angle("about a line 31.5 degrees forward of down and 10 outward")),
      key<RangeSpec>("hip_twist", &RangeSpec::hip_twist,
                     half_angle("of the knee's axis about the line of the hips")),
      key<RangeSpec>("wrist", &RangeSpec::wrist, half_angle("of the hand about the forearm's line")),
      key<RangeSpec>("ankle", &RangeSpec::ankle,
                     half_angle("of the foot about where it points at the start")),
  };
  return keys;
}

}  // namespace

template <>
struct Codec<PoseSpec> {
  static std::string type() { return "a table"; }
  static std::vector<KeyInfo> inner() { return infos(pose_keys()); }
  static bool read(const Node& node, const KeyInfo& info, PoseSpec& out, Reader& reader) {
    return read_table(node, pose_keys(), in_quotes(info.name), TableKind::value, out, reader);
  }
  static std::string write(const PoseSpec& value) { return write_inline(pose_keys(), value); }
};

template <>
struct Codec<RangeSpec> {
  static std::string type() { return "a table"; }
  static std::vector<KeyInfo> inner() { return infos(range_keys()); }
  static bool read(const Node& node, const KeyInfo& info, RangeSpec& out, Reader& reader) {
    return read_table(node, range_keys(), in_quotes(info.name), TableKind::value, out, reader);
  }
  static std::string write(const RangeSpec& value) { return write_inline(range_keys(), value); }
};

namespace {

constexpr Facts speed(std::string_view help) {
  return {.unit = "m/s", .range = between(-far, far), .help = help};
}

Keys<RagdollSpec> ragdoll_keys() {
  return {
      key<RagdollSpec>("name", &RagdollSpec::name,
                       named("its masses are named name.head, name.left_hand, name.left_knee.left, …")),
      key<RagdollSpec>("height", &RagdollSpec::height,
                       {.unit = "m", .range = above_to(0, 1000), .help = "standing upright"}),
      key<RagdollSpec>("mass", &RagdollSpec::mass,
                       {.unit = "kg", .range = above_to(0, 1e9), .help = "of the whole body"}),
      key<RagdollSpec>("position", &RagdollSpec::position, where("of the middle of the hips at the start")),
      key<RagdollSpec>("turn", &RagdollSpec::turn,
                       {.unit = "degrees",
                        .range = between(-360, 360),
                        .help = "about x, then y, then z; unturned it stands upright and looks along z"}),
      key<RagdollSpec>("velocity", &RagdollSpec::velocity, speed("of the whole at the start")),
      key<RagdollSpec>(
          "spin", &RagdollSpec::spin,
          {.unit = "rad/s", .range = between(-1000, 1000), .help = "at the start, about its centre of mass"}),
      key<RagdollSpec>("pose", &RagdollSpec::pose, {.help = "the joints' angles at the start"}),
      key<RagdollSpec>("ranges", &RagdollSpec::ranges, {.help = "what angles the joints may have"}),
      key<RagdollSpec>(
          "joint_damping", &RagdollSpec::joint_damping,
          {.unit = "1/s",
           .range = between(0, 1e6),
           .help = "of each joint, over the moment of inertia about it of all beyond it, stretched out"}),
      key<RagdollSpec>(
          "joint_friction", &RagdollSpec::joint_friction,
          {.range = between(0, 1e6),
           .help = "of each joint, over the torque that holds all beyond it out level; 1: it just stays"}),
      key<RagdollSpec>("pinned", &RagdollSpec::pinned,
                       {.choices = ragdoll_handles, .help = "what it is held by"}),
      key<RagdollSpec>("collides", &RagdollSpec::collides,
                       {.help = "whether it touches other bodies that collide"}),
  };
}

constexpr std::array<std::string_view, 3> ragdoll_parts{"links", "masses", "bones"};
constexpr LookFacts ragdoll_look{
    .visible =
        "whether it is drawn; what is hidden moves as ever, but throws no shadow, and neither the camera nor "
        "the colour scale minds it",
    .colour = "of the body, or of its links and free masses, where look.colour_by is plain",
    .parts = ragdoll_parts};

constexpr Facts compliance{.unit = "rad/(N m)",
                           .range = between(0, 1e12),
                           .help = "how far a stop gives way to each newton metre; 0: not at all"};

Keys<AngleSpec> angle_keys() {
  return {
      key<AngleSpec>("masses", &AngleSpec::masses,
                     {.required = true, .help = "three names; the angle is at the second"}),
      key<AngleSpec>("min", &AngleSpec::min,
                     {.unit = "degrees", .range = between(0, 180), .help = "of the angle"}),
      key<AngleSpec>("max", &AngleSpec::max,
                     {.unit = "degrees", .range = between(0, 180), .help = "of the angle; 180: straight"}),
      key<AngleSpec>("compliance", &AngleSpec::compliance, compliance),
  };
}

Keys<HingeSpec> hinge_keys() {
  return {
      key<HingeSpec>("masses", &HingeSpec::masses,
                     {.required = true, .help = "three names; the hinge is at the second"}),
      key<HingeSpec>("axis", &HingeSpec::axis,
                     {.required = true, .help = "two names; the axis points from the first to the second"}),
      key<HingeSpec>(
          "min", &HingeSpec::min,
          {.unit = "degrees",
           .range = between(-180, 180),
           .help = "how far the third mass is turned on from straight, right-handed about the axis"}),
      key<HingeSpec>("max", &HingeSpec::max,
                     {.unit = "degrees", .range = between(-180, 180), .help = "see min"}),
      key<HingeSpec>("compliance", &HingeSpec::compliance, compliance),
  };
}

Keys<ConeSpec> cone_keys() {
  return {
      key<ConeSpec>("frame", &ConeSpec::frame,
                    {.required = true, .help = "three names of masses that the axis turns with"}),
      key<ConeSpec>(
          "limb", &ConeSpec::limb,
          {.required = true,
           .help = "two names: from the first to the second; or three: to the middle of the others"}),
      key<ConeSpec>("axis", &ConeSpec::axis,
                    {.range = between(-far, far), .help = "as it points at the start, of any length but 0"}),
      key<ConeSpec>("half_angle", &ConeSpec::half_angle,
                    {.unit = "degrees",
                     .range = above_to(0, 180),
                     .help = "how far the limb may be turned away from the axis"}),
      key<ConeSpec>("compliance", &ConeSpec::compliance, compliance),
  };
}

}  // namespace

std::vector<Section> body_sections() {
  return {
      object_section<RagdollSpec>(
          "ragdoll",
          "A human body: segments, their masses and lengths by Winter's table, joints with ranges.",
          ragdoll_keys(), ragdoll_look, &Description::ragdolls, &ObjectLooks::ragdolls),
      repeated_section<AngleSpec>("angle", "A range for the angle between three masses.", angle_keys(),
                                  description_of(&Description::angles)),
      repeated_section<HingeSpec>("hinge", "A range for a signed angle about an axis between two masses.",
                                  hinge_keys(), description_of(&Description::hinges)),
      repeated_section<ConeSpec>("cone",
                                 "A range for a limb about an axis that is fixed in a frame of masses.",
                                 cone_keys(), description_of(&Description::cones)),
  };
}

}  // namespace taut
