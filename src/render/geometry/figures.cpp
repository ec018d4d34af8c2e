#include "geometry/figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "geometry/body_hues.h"
#include "geometry/view_matrices.h"
#include "model/anthropometry.h"

namespace taut {
namespace {

// All lengths below are in shares of the body's height.
namespace girth {
constexpr double shoulder = 0.037, elbow = 0.0255, wrist = 0.0185;
constexpr double palm = 0.027, fingers = 0.018, thumb = 0.010;
constexpr double hip = 0.052, knee = 0.0365, calf = 0.0335, ankle = 0.0235;
constexpr double heel = 0.027, toes = 0.028, instep = 0.016;
constexpr double neck = 0.034, nape = 0.030, skull = 0.061, chin = 0.037;
}  // namespace girth

// Joints that are coloured stand out from what they join.
constexpr double joint_swell = 1.22;
constexpr Colour neutral_body{0.66, 0.67, 0.69};

Vec3 middle(const State& state, const std::array<Index, 2>& masses) {
  return 0.5 * (state.position.at(masses[0]) + state.position.at(masses[1]));
}

Vec3 unit(const Vec3& vector, const Vec3& fallback) {
  const double length = vector.norm();
  return length > 1e-12 ? Vec3(vector / length) : fallback;
}

// Right-handed axes: `along` kept, `left` turned to be across it.
struct FigureAxes {
  Vec3 left, along, forward;
};

FigureAxes figure_axes(const Vec3& left, const Vec3& along) {
  FigureAxes axes;
  axes.along = unit(along, Vec3::UnitY());
  const Vec3 any = std::abs(axes.along.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitZ();
  const auto across = [&](const Vec3& v) -> Vec3 { return v - axes.along * axes.along.dot(v); };
  axes.left = unit(across(left), unit(across(any), Vec3::UnitX()));
  axes.forward = axes.left.cross(axes.along);
  return axes;
}

// What a look asks for at some masses of one body.
class FigurePaint {
 public:
  FigurePaint(const Look& look, const Quantity& quantity, const ColourScale& scale, const Colour& own)
      : look_(look), quantity_(quantity), scale_(scale), own_(own) {}

  Rgba skin(std::span<const Index> masses) const {
    if (look_.colour_by == ColourBy::plain) return opaque(own_);
    if (look_.colour_by == ColourBy::limit) return opaque(neutral_body);
    double sum = 0.0;
    for (const Index mass : masses) sum += quantity_.of_mass[mass];
    return opaque(scale_.at(sum / static_cast<double>(masses.size())));
  }
  bool marks_joints() const { return look_.colour_by == ColourBy::limit; }
  Colour joint(const std::array<Index, 2>& masses) const {
    return scale_.at(std::max(quantity_.of_mass[masses[0]], quantity_.of_mass[masses[1]]));
  }

 private:
  const Look& look_;
  const Quantity& quantity_;
  const ColourScale& scale_;
  Colour own_;
};

// One body in one state.
class Figure {
 public:
  Figure(Bodies& bodies, const State& state, const BodyParts& body, const FigurePaint& paint)
      : bodies_(bodies), state_(state), body_(body), paint_(paint), height_(body.height) {}

  void add() {
    add_trunk_and_head();
    for (const Limbs* limbs : {&body_.left, &body_.right}) {
      add_arm(*limbs);
      add_leg(*limbs);
    }
  }

 private:
  using Pair = std::array<Index, 2>;

  // Between two places that have the colours of some masses.
  TaperedRod& rod(const Vec3& start, double start_girth, const Pair& start_masses, const Vec3& end,
                  double end_girth, const Pair& end_masses) {
    TaperedRod made = tapered_rod(start, start_girth * height_, end, end_girth * height_, {});
    made.start_colour = paint_.skin(start_masses);
    made.end_colour = paint_.skin(end_masses);
    return bodies_.rods.emplace_back(made);
  }

  static void squeeze(TaperedRod& rod, const Vec3& axis, double thickness) {
    rod.squeeze = to_glm(std::sqrt(1.0 - thickness) * axis);
  }

  void mark_joint(const Vec3& place, double girth, const Pair& masses) {
    if (!paint_.marks_joints()) return;
    const double radius = joint_swell * girth * height_;
    bodies_.rods.push_back(tapered_rod(place, radius, place, radius, paint_.joint(masses)));
  }

  void add_trunk_and_head() {
    const Pair shoulder_pair{body_.left.shoulder, body_.right.shoulder};
    const Pair hip_pair{body_.left.hip, body_.right.hip}, head_pair{body_.head, body_.head};
    const auto at = [&](Index mass) -> Vec3 { return state_.position.at(mass); };
    const Vec3 hips = middle(state_, hip_pair), shoulders = middle(state_, shoulder_pair);
    const Vec3 left = at(shoulder_pair[0]) - at(shoulder_pair[1]) + at(hip_pair[0]) - at(hip_pair[1]);
    const FigureAxes trunk = figure_axes(left, shoulders - hips);
    const std::array<Index, 6> trunk_masses{shoulder_pair[0], shoulder_pair[1], hip_pair[0],
                                            hip_pair[1],      body_.chest,      body_.back};
    bodies_.torsos.push_back(
        {to_glm(hips),
         {to_glm(height_ * trunk.left), to_glm((shoulders - hips) / winter::trunk.length),
          to_glm(height_ * trunk.forward)},
         paint_.skin(trunk_masses)});

    const Vec3 head = at(body_.head);
    const FigureAxes face = figure_axes(at(shoulder_pair[0]) - at(shoulder_pair[1]), head - shoulders);
    const Vec3 throat = shoulders + height_ * (0.028 * trunk.along - 0.006 * trunk.forward);
    rod(throat, girth::neck, shoulder_pair, head - height_ * (0.02 * face.along + 0.008 * face.forward),
        girth::nape, head_pair);
    mark_joint(throat + 0.012 * height_ * trunk.along, girth::neck, shoulder_pair);
    TaperedRod& skull =
        rod(head + height_ * (0.011 * face.along - 0.004 * face.forward), girth::skull, head_pair,
            head + height_ * (0.019 * face.forward - 0.037 * face.along), girth::chin, head_pair);
    squeeze(skull, face.left, 0.92);
  }

  void add_arm(const Limbs& limbs) {
    const Vec3 shoulder = state_.position.at(limbs.shoulder), elbow = middle(state_, limbs.elbow),
               wrist = state_.position.at(limbs.wrist), hand = state_.position.at(limbs.hand);
    const Pair shoulder_pair{limbs.shoulder, limbs.shoulder}, wrist_pair{limbs.wrist, limbs.wrist},
        hand_pair{limbs.hand, limbs.hand};
    rod(shoulder, girth::shoulder, shoulder_pair, elbow, girth::elbow, limbs.elbow);
    rod(elbow, girth::elbow, limbs.elbow, wrist, girth::wrist, wrist_pair);
    // A hand's palm looks along the elbow's axis: towards the thigh of an arm that hangs.
    const FigureAxes palm =
        figure_axes(state_.position.at(limbs.elbow[0]) - state_.position.at(limbs.elbow[1]), hand - wrist);
    const auto on_hand = [&](double along, double forward) -> Vec3 {
      return wrist + (hand - wrist).norm() * along * palm.along - height_ * forward * palm.forward;
    };
    squeeze(rod(on_hand(0.30, 0.0), girth::palm, wrist_pair, on_hand(0.88, 0.0), girth::fingers, hand_pair),
            palm.left, 0.55);
    rod(on_hand(0.16, 0.006), girth::thumb * 1.2, wrist_pair, on_hand(0.52, 0.030), girth::thumb, hand_pair);
    rod(wrist, girth::wrist, wrist_pair, on_hand(0.36, 0.0), girth::wrist * 0.9, wrist_pair);
    mark_joint(shoulder, girth::shoulder, shoulder_pair);
    mark_joint(elbow, girth::elbow, limbs.elbow);
    mark_joint(wrist, girth::wrist, wrist_pair);
  }

  void add_leg(const Limbs& limbs) {
    const Vec3 hip = state_.position.at(limbs.hip), knee = middle(state_, limbs.knee),
               ankle = state_.position.at(limbs.ankle), toe = state_.position.at(limbs.toe);
    const Pair hip_pair{limbs.hip, limbs.hip}, ankle_pair{limbs.ankle, limbs.ankle},
        toe_pair{limbs.toe, limbs.toe};
    rod(hip, girth::hip, hip_pair, knee, girth::knee, limbs.knee);
    const FigureAxes shank =
        figure_axes(state_.position.at(limbs.knee[0]) - state_.position.at(limbs.knee[1]), ankle - knee);
    const Vec3 calf = knee + 0.27 * (ankle - knee) + 0.005 * height_ * shank.forward;  // to the back
    rod(knee, girth::knee, limbs.knee, calf, girth::calf, limbs.knee);
    rod(calf, girth::calf, limbs.knee, ankle, girth::ankle, ankle_pair);
    // The foot's mass at its toes lies lower than the ankle, by as much as its own height leaves.
    const double drop = winter::ankle_height - 0.025, tilt = std::asin(drop / winter::foot.length);
    const FigureAxes foot =
        figure_axes(state_.position.at(limbs.knee[0]) - state_.position.at(limbs.knee[1]), toe - ankle);
    const Vec3 level = std::cos(tilt) * foot.along - std::sin(tilt) * foot.forward;
    const Vec3 down = std::cos(tilt) * foot.forward + std::sin(tilt) * foot.along;
    constexpr double thickness = 0.74;
    const auto on_sole = [&](const Vec3& from, double forward, double width) -> Vec3 {
      const double above = winter::ankle_height - (from - ankle).dot(down) / height_;
      return from + height_ * (forward * level + (above - thickness * width) * down);
    };
    squeeze(rod(on_sole(ankle, -0.022, girth::heel), girth::heel, ankle_pair,
                on_sole(toe, -0.006, girth::toes), girth::toes, toe_pair),
            down, thickness);
    rod(ankle, girth::ankle, ankle_pair, ankle + 0.62 * (toe - ankle) + 0.010 * height_ * down, girth::instep,
        toe_pair);
    mark_joint(hip, girth::hip, hip_pair);
    mark_joint(knee, girth::knee, limbs.knee);
    mark_joint(ankle, girth::ankle, ankle_pair);
  }

  Bodies& bodies_;
  const State& state_;
  const BodyParts& body_;
  const FigurePaint& paint_;
  double height_;  // m
};

}  // namespace

void add_figures(Bodies& bodies, const std::vector<BodyParts>& parts, const Drawn& drawn) {
  const std::vector<Colour> hues = body_hues(drawn.look.bone_colour, parts.size());
  const std::vector<std::optional<Colour>>& own = drawn.appearance.body_colours;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!drawn.appearance.bodies[i]) continue;
    const Colour colour = own.empty() ? hues[i] : own[i].value_or(hues[i]);
    Figure(bodies, drawn.state, parts[i], FigurePaint(drawn.look, drawn.quantity, drawn.scale, colour)).add();
  }
}

}  // namespace taut
