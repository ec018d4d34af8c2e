// Taylor arithmetic: every quantity is carried with its first and second derivative by time, while all masses
// move on at their velocities (Griewank and Walther, Evaluating Derivatives, 2008, chapter 13).

#include "model/limit_motion.h"

#include <cmath>

namespace taut {
namespace {

struct Jet {
  double value = 0.0, rate = 0.0, change = 0.0;
};

Jet operator+(const Jet& a, const Jet& b) {
  return {a.value + b.value, a.rate + b.rate, a.change + b.change};
}

Jet operator*(const Jet& a, const Jet& b) {
  return {a.value * b.value, a.rate * b.value + a.value * b.rate,
          a.change * b.value + 2.0 * a.rate * b.rate + a.value * b.change};
}

Jet operator*(double factor, const Jet& a) {
  return {factor * a.value, factor * a.rate, factor * a.change};
}

Jet root(const Jet& a) {
  const double value = std::sqrt(a.value), rate = 0.5 * a.rate / value;
  return {value, rate, (0.5 * a.change - rate * rate) / value};
}

Jet inverse(const Jet& a) {
  const double value = 1.0 / a.value, rate = -a.rate * value * value;
  return {value, rate, -(a.change * value + 2.0 * a.rate * rate) * value};
}

// The rate and its change of atan2(sine, cosine).
LimitMotion turn(const Jet& sine, const Jet& cosine) {
  const double square = sine.value * sine.value + cosine.value * cosine.value;
  const double across = cosine.value * sine.rate - sine.value * cosine.rate;
  const double along = cosine.value * cosine.rate + sine.value * sine.rate;
  const double bent = cosine.value * sine.change - sine.value * cosine.change;
  return {across / square, (bent - 2.0 * across * along / square) / square};
}

struct JetVector {
  Vec3 value, rate, change;
};

JetVector operator+(const JetVector& a, const JetVector& b) {
  return {a.value + b.value, a.rate + b.rate, a.change + b.change};
}

JetVector operator-(const JetVector& a, const JetVector& b) {
  return {a.value - b.value, a.rate - b.rate, a.change - b.change};
}

JetVector operator*(const Jet& a, const JetVector& b) {
  return {a.value * b.value, a.rate * b.value + a.value * b.rate,
          a.change * b.value + 2.0 * a.rate * b.rate + a.value * b.change};
}

Jet dot(const JetVector& a, const JetVector& b) {
  return {a.value.dot(b.value), a.rate.dot(b.value) + a.value.dot(b.rate),
          a.change.dot(b.value) + 2.0 * a.rate.dot(b.rate) + a.value.dot(b.change)};
}

JetVector cross(const JetVector& a, const JetVector& b) {
  return {a.value.cross(b.value), a.rate.cross(b.value) + a.value.cross(b.rate),
          a.change.cross(b.value) + 2.0 * a.rate.cross(b.rate) + a.value.cross(b.change)};
}

JetVector direction(const JetVector& a) {
  return inverse(root(dot(a, a))) * a;
}

LimitMotion turn_between(const JetVector& a, const JetVector& c) {
  const JetVector across = cross(a, c);
  return turn(root(dot(across, across)), dot(a, c));
}

}  // namespace

LimitMotion limit_motion(const Limit& limit, const Vectors& position, const Vectors& velocity) {
  const auto mass = [&](std::size_t i) {
    return JetVector{position.at(limit.masses[i]), velocity.at(limit.masses[i]), Vec3::Zero()};
  };
  switch (limit.kind) {
    case LimitKind::angle:
      return turn_between(mass(0) - mass(1), mass(2) - mass(1));
    case LimitKind::hinge: {
      const JetVector axis = direction(mass(4) - mass(3));
      const JetVector a = mass(0) - mass(1), c = mass(2) - mass(1);
      // Of a⊥ and c⊥, the parts across the axis: −axis·(a × c), and −a⊥·c⊥.
      return turn(-1.0 * dot(axis, cross(a, c)), dot(axis, a) * dot(axis, c) + -1.0 * dot(a, c));
    }
    case LimitKind::cone: {
      const JetVector x = direction(mass(1) - mass(0));
      const JetVector z = direction(cross(x, mass(2) - mass(0)));
      const auto fixed = [](double size) { return Jet{size, 0.0, 0.0}; };
      const JetVector axis =
          fixed(limit.axis.x()) * x + fixed(limit.axis.y()) * cross(z, x) + fixed(limit.axis.z()) * z;
      return turn_between(axis, fixed(0.5) * (mass(4) + mass(5)) - mass(3));
    }
    case LimitKind::reach: {
      const JetVector apart = mass(0) - mass(1);
      const Jet distance = root(dot(apart, apart));
      return {distance.rate / limit.length, distance.change / limit.length};
    }
  }
  return {};
}

}  // namespace taut
