#include "curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace taut {
namespace {

constexpr int pieces_a_span = 24, pieces_a_turn = 96;

// One place of the curve from b to c (Barry and Goldman's pyramid), `share` of the way.
Vec3 on_curve(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double share) {
  const double one = std::sqrt((b - a).norm());
  const double two = one + std::sqrt((c - b).norm());
  const double three = two + std::sqrt((d - c).norm());
  const double t = std::lerp(one, two, share);
  const auto mix = [t](const Vec3& from, const Vec3& to, double begin, double end) -> Vec3 {
    return from + (to - from) * ((t - begin) / (end - begin));
  };
  const Vec3 ab = mix(a, b, 0.0, one), bc = mix(b, c, one, two), cd = mix(c, d, two, three);
  return mix(mix(ab, bc, 0.0, two), mix(bc, cd, one, three), one, two);
}

double length_of(const std::vector<Vec3>& line) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) length += (line[i + 1] - line[i]).norm();
  return length;
}

// Walks along a line in chords of one length.
class ChordWalk {
 public:
  ChordWalk(const std::vector<Vec3>& line, double chord) : line_(line), chord_(chord), at_(line.front()) {}

  const Vec3& at() const { return at_; }
  double left() const { return (line_.back() - at_).norm(); }

  // One chord on; false where the end is nearer than that.
  bool step() {
    for (; piece_ + 1 < line_.size(); ++piece_) {
      const Vec3 begin = line_[piece_], way = line_[piece_ + 1] - begin;
      if ((line_[piece_ + 1] - at_).norm() < chord_) continue;
      // A straight piece leaves the ball about a place within it once: at the larger root.
      const Vec3 off = begin - at_;
      const double squared = way.squaredNorm(), half = way.dot(off);
      const double root =
          std::sqrt(std::max(half * half - squared * (off.squaredNorm() - chord_ * chord_), 0.0));
      if (!(squared > 0.0)) continue;
      at_ = begin + way * std::clamp((root - half) / squared, 0.0, 1.0);
      return true;
    }
    return false;
  }

 private:
  const std::vector<Vec3>& line_;
  double chord_;
  Vec3 at_;
  std::size_t piece_ = 0;
};

// How many chords it is to the end, the last one a part.
double chords_to_the_end(const std::vector<Vec3>& line, double chord, int most) {
  ChordWalk walk(line, chord);
  int count = 0;
  while (count <= most && walk.step()) ++count;
  return count + walk.left() / chord;
}

// The chord of which so many end at the end: between two that are too short and too long.
double fitting_chord(const std::vector<Vec3>& line, int chords) {
  const double wanted = chords;
  double low = 1e-3 * length_of(line) / wanted, high = length_of(line) / wanted;
  double chord = high;
  for (int round = 0; round < 200 && low < high; ++round) {
    const double count = chords_to_the_end(line, chord, 2 * chords);
    if (std::abs(count - wanted) < 1e-13 * wanted) break;
    (count > wanted ? low : high) = chord;
    // Of fine chords the number times the length is nearly the same for all lengths.
    const double better = chord * count / wanted;
    chord = better > low && better < high ? better : 0.5 * (low + high);
  }
  return chord;
}

}  // namespace

std::vector<Vec3> smooth_curve(const std::vector<Vec3>& points) {
  std::vector<Vec3> curve{points.front()};
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Vec3 &b = points[i], &c = points[i + 1];
    const Vec3 a = i > 0 ? points[i - 1] : Vec3(2.0 * b - c);
    const Vec3 d = i + 2 < points.size() ? points[i + 2] : Vec3(2.0 * c - b);
    for (int piece = 1; piece < pieces_a_span; ++piece)
      curve.push_back(on_curve(a, b, c, d, static_cast<double>(piece) / pieces_a_span));
    curve.push_back(c);
  }
  return curve;
}

std::vector<Vec3> winding(const Spool& spool, double turns, double start, double end) {
  const Vec3 span = spool.to - spool.from;
  const Vec3 axis = span.normalized();
  const Vec3 aside = (std::abs(axis.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY()).cross(axis).normalized();
  const Vec3 across = axis.cross(aside);
  const int pieces = std::max(2, static_cast<int>(std::ceil(std::abs(turns) * pieces_a_turn)));
  std::vector<Vec3> line;
  for (int piece = 0; piece <= pieces; ++piece) {
    const double way = static_cast<double>(piece) / pieces, along = std::lerp(start, end, way);
    const double turned = 2.0 * std::numbers::pi * turns * way;
    // A ball is as wide at a height h above its middle as √(r² − h²).
    const double off = 2.0 * along - 1.0;
    const double radius = spool.radius * (spool.round ? std::sqrt(std::max(1.0 - off * off, 0.0)) : 1.0);
    line.push_back(spool.from + along * span +
                   radius * (std::cos(turned) * aside + std::sin(turned) * across));
  }
  return line;
}

std::optional<std::vector<Vec3>> spread_evenly(const std::vector<Vec3>& line, int chords) {
  constexpr double alike = 1e-9;  // of a chord
  const double chord = fitting_chord(line, chords);
  std::vector<Vec3> places{line.front()};
  ChordWalk walk(line, chord);
  while (static_cast<int>(places.size()) < chords && walk.step()) places.push_back(walk.at());
  const bool all = static_cast<int>(places.size()) == chords;
  if (!all || !(std::abs((line.back() - places.back()).norm() - chord) < alike * chord)) return std::nullopt;
  places.push_back(line.back());
  return places;
}

}  // namespace taut
