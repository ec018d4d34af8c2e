#include "geometry/turning_marks.h"

#include <numbers>

namespace taut {
namespace {

constexpr int marks_around = 3;
// Of the solid's radius: how thick a mark is, and how far it stands out.
constexpr double mark_radius = 0.09, stands_out = 0.03;
constexpr double darker = 0.62;

// From the middle line of a solid outward, to where the marks sit.
Vec3 outward(const Vec3& along, int mark) {
  const double angle = 2.0 * std::numbers::pi * mark / marks_around;
  return Eigen::AngleAxisd(angle, along) * along.unitOrthogonal();
}

class MarkMaker {
 public:
  MarkMaker(Bodies& bodies, const Placement& placement, const Vec3& axis, const PictureSpace& space,
            const Colour& colour)
      : bodies_(bodies), placement_(placement), axis_(axis), space_(space) {
    for (std::size_t i = 0; i < colour.size(); ++i) colour_[i] = darker * colour[i];
  }

  void add(const Capsule& capsule) {
    const Vec3 along = (capsule.b - capsule.a).normalized();
    for (int mark = 0; mark < marks_around; ++mark) {
      const Vec3 off = (1.0 + stands_out - mark_radius) * capsule.radius * outward(along, mark);
      add_rod(capsule.a + off, capsule.b + off, capsule.radius);
    }
  }
  void add(const Sphere& sphere) {
    for (int mark = 0; mark < marks_around; ++mark) {
      const Vec3 spot =
          sphere.centre + (1.0 + stands_out - mark_radius) * sphere.radius * outward(axis_, mark);
      add_rod(spot, spot, sphere.radius);
    }
  }
  void add(const Box&) {}
  void add(const MeshSolid&) {}
  void add(const HalfSpace&) {}

 private:
  void add_rod(const Vec3& start, const Vec3& end, double radius) {
    const Capsule mark{placement_.place(start), placement_.place(end), mark_radius * radius};
    add_shape(bodies_, space_.seen(Shape(mark)), colour_);
  }

  Bodies& bodies_;
  const Placement& placement_;
  Vec3 axis_;
  const PictureSpace& space_;
  Colour colour_{};
};

}  // namespace

void add_turning_marks(Bodies& bodies, const Collider& collider, double time, const PictureSpace& space,
                       const Colour& colour) {
  if (!collider.motion || std::holds_alternative<std::monostate>(collider.motion->turn)) return;
  const Placement placement = placement_at(*collider.motion, time);
  MarkMaker marks(bodies, placement, collider.motion->axis, space, colour);
  std::visit([&marks](const auto& shape) { marks.add(shape); }, collider.shape);
}

}  // namespace taut
