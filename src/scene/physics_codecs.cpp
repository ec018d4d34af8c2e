#include "physics_codecs.h"

#include <fmt/format.h>

#include "physics_facts.h"

namespace taut {
namespace {

const Keys<LinkProperties>& extra_link_keys() {
  static const auto keys =
      link_property_keys<LinkProperties>([](auto& properties) -> auto& { return properties; });
  return keys;
}

// A motion as it is written: a sinusoid's keys or a path, or of a pin the name of what carries it.
struct WrittenMotion {
  std::optional<Vec3> amplitude;
  std::optional<double> angular_frequency, phase;
  std::optional<std::vector<Knot>> path;
  std::optional<std::string> with;
};

Keys<WrittenMotion> way_keys() {
  return {
      key<WrittenMotion>(
          "amplitude", &WrittenMotion::amplitude,
          {.unit = "m",
           .range = between(-far, far),
           .fallback = "none",
           .help = "it is at its place at the start + amplitude · sin(angular_frequency · t + phase)"}),
      key<WrittenMotion>(
          "angular_frequency", &WrittenMotion::angular_frequency,
          {.unit = "rad/s", .range = between(-far, far), .fallback = "none", .help = "see amplitude"}),
      key<WrittenMotion>(
          "phase", &WrittenMotion::phase,
          {.unit = "rad", .range = between(-far, far), .fallback = "0.0", .help = "see amplitude"}),
      key<WrittenMotion>("path", &WrittenMotion::path,
                         {.unit = "s, m, m, m",
                          .range = between(-far, far),
                          .fallback = "none",
                          .help = "in place of the others: where it is at which times, in order; between "
                                  "them a smooth curve that starts and ends at rest"}),
  };
}

const Keys<WrittenMotion>& solid_way_keys() {
  static const Keys<WrittenMotion> keys = way_keys();
  return keys;
}

const Keys<WrittenMotion>& motion_keys() {
  static const Keys<WrittenMotion> keys =
      way_keys() + Keys<WrittenMotion>{
                       key<WrittenMotion>(
                           "with", &WrittenMotion::with,
                           {.fallback = "none",
                            .help = "in place of the others: the name of a solid that carries it, as a drum "
                                    "does the end of its rope"}),
                   };
  return keys;
}

template <class Spec>
Key<Spec> from_start_key() {
  return key<Spec>("from_start", &Spec::from_start,
                   {.help = "whether it rests as it is bent at the start; else straight"});
}

const Keys<HookSpec>& hook_keys() {
  static const Keys<HookSpec> keys{
      key<HookSpec>("every", &HookSpec::every,
                    {.unit = "columns",
                     .range = between(0, 1e8),
                     .help = "from one hook to the next; 0: no hooks. Divides columns − 1"}),
      key<HookSpec>("draw", &HookSpec::draw,
                    {.unit = "s, share",
                     .range = between(0, far),
                     .help = "[time, share of the rail that the hooks span], which draws the sheet open and "
                             "shut; empty: the hooks stay"}),
  };
  return keys;
}

// A sinusoid needs both its size and its speed, a path at least one place; one of the ways it must be.
std::string motion_problem(const WrittenMotion& written, bool of_pin) {
  const bool swings = written.amplitude || written.angular_frequency || written.phase;
  if (swings + written.path.has_value() + written.with.has_value() != 1)
    return fmt::format("needs either \"amplitude\" and \"angular_frequency\", or \"path\"{}",
                       of_pin ? ", or \"with\"" : "");
  if (written.with && written.with->empty()) return "needs the name of a solid in \"with\"";
  if (swings && !written.amplitude) return "needs the key \"amplitude\"";
  if (swings && !written.angular_frequency) return "needs the key \"angular_frequency\"";
  if (written.path && written.path->empty()) return "needs a path of at least one place";
  return {};
}

bool read_motion(const Node& node, const KeyInfo& info, const Keys<WrittenMotion>& keys, bool of_pin,
                 WrittenMotion& written, Reader& reader) {
  const std::string label = in_quotes(info.name);
  const std::size_t errors = reader.count();
  if (!read_table(node, keys, label, TableKind::value, written, reader)) return false;
  if (reader.count() > errors) return false;
  const std::string problem = motion_problem(written, of_pin);
  if (!problem.empty()) reader.unreadable(node.origin, label + " " + problem);
  return problem.empty();
}

// Into whatever has a sinusoid and a path.
template <class Spec>
void take_way(const WrittenMotion& written, Spec& out) {
  if (written.path)
    out.path = *written.path;
  else if (written.amplitude)
    out.sinusoid = SinusoidSpec{*written.amplitude, *written.angular_frequency, written.phase.value_or(0.0)};
}

template <class Spec>
WrittenMotion written_way(const Spec& value) {
  WrittenMotion written;
  if (value.sinusoid) {
    written.amplitude = value.sinusoid->amplitude;
    written.angular_frequency = value.sinusoid->angular_frequency;
    written.phase = value.sinusoid->phase;
  } else if (!value.path.empty()) {
    written.path = value.path;
  }
  return written;
}

}  // namespace

const Keys<WindingSpec>& winding_keys() {
  static const Keys<WindingSpec> keys{
      key<WindingSpec>("around", &WindingSpec::around,
                       {.required = true,
                        .help = "which sphere or capsule: its name, or sphere.0, capsule.1, …, by number "
                                "from 0. The chain's middle lies "
                                "its own radius off the solid"}),
      key<WindingSpec>("turns", &WindingSpec::turns,
                       {.range = between(-1000, 1000),
                        .help = "how many times around, right-handed about the axis; below 0 the other way"}),
      key<WindingSpec>(
          "start", &WindingSpec::start,
          {.range = between(0, 1),
           .help = "where it begins, as a share of the solid's length along the axis: of a capsule "
                   "from `from` to `to`, of a sphere from pole to pole"}),
      key<WindingSpec>("end", &WindingSpec::end, {.range = between(0, 1), .help = "where it ends"}),
      key<WindingSpec>(
          "axis", &WindingSpec::axis,
          {.range = between(-far, far), .help = "of a sphere, of any length but 0; a capsule has its own"}),
  };
  return keys;
}

const Keys<RotationSpec>& rotation_keys() {
  static const Keys<RotationSpec> keys{
      key<RotationSpec>(
          "axis", &RotationSpec::axis,
          {.range = between(-far, far), .required = true, .help = "of any length but 0; right-handed"}),
      key<RotationSpec>("through", &RotationSpec::through,
                        {.unit = "m",
                         .range = between(-far, far),
                         .fallback = "its centre",
                         .help = "a point that the axis goes through, where the solid is at the start"}),
      key<RotationSpec>("rate", &RotationSpec::rate,
                        {.unit = "degrees/s",
                         .range = between(-1e6, 1e6),
                         .fallback = "none",
                         .help = "at which it turns"}),
      key<RotationSpec>(
          "rise", &RotationSpec::rise,
          {.unit = "s", .range = between(0, far), .help = "in which the rate is reached, smoothly"}),
      key<RotationSpec>("angle", &RotationSpec::angle,
                        {.unit = "s, degrees",
                         .range = between(-far, far),
                         .help = "in place of a rate: [time, how far it is turned then], in order; between "
                                 "them a smooth curve that starts and ends at rest"}),
  };
  return keys;
}

const Keys<FacesSpec>& faces_keys() {
  static const Keys<FacesSpec> keys{
      key<FacesSpec>("thickness", &FacesSpec::thickness,
                     {.unit = "m",
                      .range = above_to(0, far),
                      .required = true,
                      .help = "faces keep this far apart, and half of it from solids"}),
      key<FacesSpec>("friction", &FacesSpec::friction,
                     {.range = between(0, 100),
                      .help = "Coulomb's coefficient of faces on faces; of two sheets the geometric mean"}),
      key<FacesSpec>("self_collides", &FacesSpec::self_collides,
                     {.help = "whether they touch one another; those of other sheets they touch where both "
                              "sheets collide"}),
  };
  return keys;
}

const Keys<BendingSpec>& bending_keys() {
  static const Keys<BendingSpec> keys{
      key<BendingSpec>("stiffness", &BendingSpec::stiffness,
                       {.unit = "N m/rad",
                        .range = between(0, 1e12),
                        .required = true,
                        .help = "of each inner mass; a rod of EI in N m² has EI over the length of a link"}),
      from_start_key<BendingSpec>(),
  };
  return keys;
}

const Keys<SheetBendingSpec>& sheet_bending_keys() {
  static const Keys<SheetBendingSpec> keys{
      key<SheetBendingSpec>(
          "stiffness", &SheetBendingSpec::stiffness,
          {.unit = "N m/rad",
           .range = between(0, 1e12),
           .help = "of each inner mass along its row and along its column; cloth of D in N m has "
                   "D times the width that a mass stands for over the length of a link"}),
      key<SheetBendingSpec>(
          "warp", &SheetBendingSpec::warp,
          {.unit = "N m/rad", .range = between(0, 1e12), .fallback = "stiffness", .help = "along columns"}),
      key<SheetBendingSpec>(
          "weft", &SheetBendingSpec::weft,
          {.unit = "N m/rad", .range = between(0, 1e12), .fallback = "stiffness", .help = "along rows"}),
      key<SheetBendingSpec>("bias", &SheetBendingSpec::bias,
                            {.unit = "N m/rad", .range = between(0, 1e12), .help = "along both diagonals"}),
      from_start_key<SheetBendingSpec>(),
  };
  return keys;
}

std::vector<KeyInfo> Codec<WaySpec>::inner() {
  return infos(solid_way_keys());
}

bool Codec<WaySpec>::read(const Node& node, const KeyInfo& info, WaySpec& out, Reader& reader) {
  WrittenMotion written;
  if (!read_motion(node, info, solid_way_keys(), false, written, reader)) return false;
  take_way(written, out);
  return true;
}

std::string Codec<WaySpec>::write(const WaySpec& value) {
  return value.empty() ? "" : write_inline(solid_way_keys(), written_way(value));
}

std::vector<KeyInfo> Codec<MotionSpec>::inner() {
  return infos(motion_keys());
}

bool Codec<MotionSpec>::read(const Node& node, const KeyInfo& info, MotionSpec& out, Reader& reader) {
  WrittenMotion written;
  if (!read_motion(node, info, motion_keys(), true, written, reader)) return false;
  take_way(written, out);
  out.with = written.with.value_or("");
  return true;
}

std::string Codec<MotionSpec>::write(const MotionSpec& value) {
  WrittenMotion written = written_way(value);
  if (!value.with.empty()) written.with = value.with;
  return written.amplitude || written.path || written.with ? write_inline(motion_keys(), written) : "";
}

std::vector<KeyInfo> Codec<HookSpec>::inner() {
  return infos(hook_keys());
}

bool Codec<HookSpec>::read(const Node& node, const KeyInfo& info, HookSpec& out, Reader& reader) {
  return read_table(node, hook_keys(), in_quotes(info.name), TableKind::value, out, reader);
}

std::string Codec<HookSpec>::write(const HookSpec& value) {
  return write_inline(hook_keys(), value);
}

std::vector<KeyInfo> Codec<ExtraLinks>::inner() {
  return infos(extra_link_keys());
}

bool Codec<ExtraLinks>::read(const Node& node, const KeyInfo& info, ExtraLinks& out, Reader& reader) {
  if (const auto* there = node.get<bool>()) {
    out = *there ? ExtraLinks(LinkProperties{}) : std::nullopt;
    return true;
  }
  if (!node.get<Node::Table>()) {
    reader.unreadable(node.origin,
                      fmt::format("{} must be {}, not {}", in_quotes(info.name), type(), describe(node)));
    return false;
  }
  return read_table(node, extra_link_keys(), in_quotes(info.name), TableKind::value, out.emplace(), reader);
}

std::string Codec<ExtraLinks>::write(const ExtraLinks& value) {
  return value ? write_inline(extra_link_keys(), *value) : "false";
}

}  // namespace taut
