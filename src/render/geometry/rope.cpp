#include "geometry/rope.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/run_frame.h"
#include "geometry/view_matrices.h"

namespace taut {
namespace {

constexpr double strands = 3.0;       // as in shaders/rope.frag
constexpr double lay = 8.5;           // radii of the rope along which a strand goes round once
constexpr double most_turn = 0.10;    // rad, of a piece
constexpr int most_pieces = 14;       // a link
constexpr double knot_size = 1.6;     // radii of the rope
constexpr double knot_shade = 0.86;   // of the rope's colour
constexpr double loose_length = 7.0;  // radii of the rope, of strands at a broken end
constexpr double loose_radius = 0.5;  // of the rope's, of a strand
constexpr int loose_pieces = 5;       // a strand
constexpr double whole_turn = 2.0 * std::numbers::pi;

// A place on the middle of a rope.
struct Sample {
  Vec3 place, tangent;  // m, unit vector
  double along;         // m of rope at rest from the run's first mass
  double value;         // of the quantity
};

// The curve of Catmull and Rom, whose tangent at a mass is along the line between the neighbours; at an end
// as if the bend went on.
class Spline {
 public:
  Spline(const State& state, const LinkRun& run) {
    for (const Index mass : run.masses) places_.push_back(state.position.at(mass));
    const std::size_t last = places_.size() - 1;
    tangents_.resize(places_.size());
    for (std::size_t i = 1; i < last; ++i) tangents_[i] = 0.5 * (places_[i + 1] - places_[i - 1]);
    if (run.closed()) {
      tangents_[0] = tangents_[last] = 0.5 * (places_[1] - places_[last - 1]);
    } else if (last == 1) {
      tangents_[0] = tangents_[1] = places_[1] - places_[0];
    } else {
      tangents_[0] = 1.5 * (places_[1] - places_[0]) - 0.5 * tangents_[1];
      tangents_[last] = 1.5 * (places_[last] - places_[last - 1]) - 0.5 * tangents_[last - 1];
    }
  }

  int pieces_of(std::size_t link) const {
    const Vec3 chord = places_[link + 1] - places_[link];
    const double turn = angle(tangents_[link], chord) + angle(chord, tangents_[link + 1]);
    return std::clamp(static_cast<int>(std::ceil(turn / most_turn)), 1, most_pieces);
  }

  // Hermite's form; t from 0 to 1 along a link.
  Vec3 place(std::size_t link, double t) const {
    const double u = 1.0 - t;
    return places_[link] * ((1.0 + 2.0 * t) * u * u) + tangents_[link] * (t * u * u) +
           places_[link + 1] * (t * t * (3.0 - 2.0 * t)) - tangents_[link + 1] * (t * t * u);
  }

  Vec3 tangent(std::size_t link, double t) const {
    const Vec3 along = (places_[link + 1] - places_[link]) * (6.0 * t * (1.0 - t)) +
                       tangents_[link] * ((1.0 - t) * (1.0 - 3.0 * t)) +
                       tangents_[link + 1] * (t * (3.0 * t - 2.0));
    if (along.norm() > 0.0) return along.normalized();
    const Vec3 chord = places_[link + 1] - places_[link];
    return chord.norm() > 0.0 ? Vec3(chord.normalized()) : Vec3(Vec3::UnitY());
  }

 private:
  static double angle(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

  std::vector<Vec3> places_, tangents_;  // m, m a link
};

double value_of(const Quantity& quantity, Index link) {
  return quantity.of_link.empty() ? 0.0 : quantity.of_link[link];
}

// A link's own value in its middle, the mean of two where they meet.
double value_along(const LinkRun& run, const Quantity& quantity, std::size_t link, double t) {
  const double own = value_of(quantity, run.links[link]);
  const bool later = t > 0.5;
  std::size_t neighbour = link;
  if (later && link + 1 < run.links.size()) neighbour = link + 1;
  if (!later && link > 0) neighbour = link - 1;
  if (run.closed() && later && link + 1 == run.links.size()) neighbour = 0;
  if (run.closed() && !later && link == 0) neighbour = run.links.size() - 1;
  return std::lerp(own, value_of(quantity, run.links[neighbour]), std::abs(t - 0.5));
}

std::vector<Sample> samples_of(const Model& model, const State& state, const LinkRun& run,
                               const Quantity& quantity) {
  const Spline spline(state, run);
  std::vector<Sample> samples;
  double along = 0.0;
  for (std::size_t link = 0; link < run.links.size(); ++link) {
    const double length = model.links.length[run.links[link]];
    // Where colours change along a link, its middle is a place of its own.
    const int needed = spline.pieces_of(link),
              pieces = quantity.of_link.empty() ? needed : needed + needed % 2;
    for (int i = 0; i <= pieces; ++i) {
      if (i == pieces && link + 1 < run.links.size()) continue;  // the next link's first
      const double t = static_cast<double>(i) / pieces;
      samples.push_back({spline.place(link, t), spline.tangent(link, t), along + t * length,
                         value_along(run, quantity, link, t)});
    }
    along += length;
  }
  return samples;
}

// Of the strands where a rope faces the eye, which is the origin: by the angle about the rope from the normal
// that is carried along to there, and by the lay. Goes on from sample to sample.
std::vector<double> phases_of(const std::vector<Sample>& samples, double radius) {
  std::vector<Vec3> tangents;
  tangents.reserve(samples.size());
  for (const Sample& sample : samples) tangents.push_back(sample.tangent);
  const std::vector<Vec3> normals = carried_normals(tangents);
  std::vector<double> phases;
  double angle = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Vec3 to_eye = -samples[i].place;
    const double seen = std::atan2(to_eye.dot(tangents[i].cross(normals[i])), to_eye.dot(normals[i]));
    angle += std::remainder(seen - angle, whole_turn);
    phases.push_back(strands * (angle - whole_turn * samples[i].along / (lay * radius)));
  }
  return phases;
}

class RopeMaker {
 public:
  RopeMaker(double radius, const Quantity& quantity, const ColourScale& scale)
      : radius_(radius), coloured_(!quantity.of_link.empty()), scale_(scale) {}

  /// What is added from now on has a colour, where it has none of what it does.
  void paint(const Colour& plain) { plain_ = plain; }

  void add_run(const std::vector<Sample>& samples) {
    const std::vector<double> phases = phases_of(samples, radius_);
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
      // In single precision the strands of a long rope would lose their places.
      const double start = std::remainder(phases[i], whole_turn);
      add(samples[i], samples[i + 1], {radius_, radius_}, {start, start + phases[i + 1] - phases[i]});
    }
  }

  void add_ball(const Vec3& place, double radius, const Colour& colour) {
    result_.balls.push_back({to_glm(place), static_cast<float>(radius), opaque(colour)});
  }

  // The rope's strands spread from an end, bending away from one another.
  void add_loose_strands(const Sample& end, const Vec3& outward) {
    const Vec3 normal = carried_normals({outward}).front();
    for (int strand = 0; strand < static_cast<int>(strands); ++strand) {
      const double turn = whole_turn * strand / strands + end.along / radius_;
      const Vec3 aside = std::cos(turn) * normal + std::sin(turn) * outward.cross(normal);
      // Strands of unequal lengths.
      const double length = loose_length * radius_ * (1.0 - 0.22 * strand);
      Sample last = end;
      for (int i = 0; i <= loose_pieces; ++i) {
        const double t = static_cast<double>(i) / loose_pieces;
        const Vec3 place = end.place + length * t * outward + (0.45 * radius_ + 0.5 * length * t * t) * aside;
        const Sample next{place, (outward + t * aside).normalized(), end.along, end.value};
        if (i > 0) {
          const double taper = loose_radius * radius_;
          add(last, next, {taper * (1.0 - 0.5 * (t - 1.0 / loose_pieces)), taper * (1.0 - 0.5 * t)},
              {0.0, 0.0});
        }
        last = next;
      }
    }
  }

  Colour colour(double value) const { return coloured_ ? scale_.at(value) : plain_; }
  Ropes take() { return std::move(result_); }

 private:
  void add(const Sample& from, const Sample& to, const std::array<double, 2>& radii,
           const std::array<double, 2>& phases) {
    result_.pieces.push_back({to_glm(from.place), static_cast<float>(radii[0]), to_glm(to.place),
                              static_cast<float>(radii[1]), to_glm(from.tangent), to_glm(to.tangent),
                              glm::vec2(phases[0], phases[1]), opaque(colour(from.value)),
                              opaque(colour(to.value))});
  }

  double radius_;
  bool coloured_;
  Colour plain_{};
  const ColourScale& scale_;
  Ropes result_;
};

Colour shaded(const Colour& colour, double share) {
  return {share * colour[0], share * colour[1], share * colour[2]};
}

// Of the links in the runs that meet at each mass: a mean would be a colour that none of them has.
std::vector<double> highest_values(const Model& model, const std::vector<LinkRun>& runs,
                                   const Quantity& quantity) {
  std::vector<double> highest(model.masses.size());
  for (const LinkRun& run : runs)
    for (const Index link : run.links)
      for (const Index mass : {model.links.a[link], model.links.b[link]})
        highest[mass] = std::max(highest[mass], value_of(quantity, link));
  return highest;
}

std::vector<bool> torn_masses(const Model& model, const State& state) {
  std::vector<bool> torn(model.masses.size(), false);
  for (std::size_t link = 0; link < model.links.size(); ++link)
    if (state.broken(link)) torn[model.links.a[link]] = torn[model.links.b[link]] = true;
  return torn;
}

}  // namespace

Ropes ropes(const Drawn& drawn, const std::vector<LinkRun>& runs) {
  const Model& model = drawn.model;
  const State& state = drawn.state;
  const double radius = drawn.radii.link;
  RopeMaker maker(radius, drawn.quantity, drawn.scale);
  const std::vector<bool> torn = torn_masses(model, state);
  const std::vector<Index> tied = knots(model, runs);
  std::vector<Index> link_at(model.masses.size());  // one that a run has at each mass
  for (const LinkRun& run : runs) {
    const std::vector<Sample> samples = samples_of(model, state, run, drawn.quantity);
    maker.paint(link_colour(drawn, run.links.front()));
    for (const Index mass : run.masses) link_at[mass] = run.links.front();
    maker.add_run(samples);
    if (run.closed()) continue;
    const auto end = [&](const Sample& sample, Index mass, const Vec3& outward) {
      maker.add_ball(sample.place, radius, maker.colour(sample.value));
      if (torn[mass] && !std::ranges::binary_search(tied, mass)) maker.add_loose_strands(sample, outward);
    };
    end(samples.front(), run.masses.front(), -samples.front().tangent);
    end(samples.back(), run.masses.back(), samples.back().tangent);
  }
  const std::vector<double> highest = highest_values(model, runs, drawn.quantity);
  for (const Index mass : tied) {
    maker.paint(link_colour(drawn, link_at[mass]));
    maker.add_ball(state.position.at(mass), knot_size * radius,
                   shaded(maker.colour(highest[mass]), knot_shade));
  }
  return maker.take();
}

}  // namespace taut
