#include "relax/pass_control.h"

#include <algorithm>
#include <cmath>

namespace taut {

void PassControl::links_changed(const std::vector<Index>& links) {
  rigid_.clear();
  for (const Index link : links)
    if (model_.links.rigid(link)) rigid_.push_back(link);
}

bool PassControl::jump_remains(const Vectors& start, const Vectors& position, double h) const {
  const double allowed = 2.0 * std::max(farthest_off(start), model_.gravity.norm() * h * h);
  return farthest_off(position) > allowed;
}

// The largest error in the lengths of rigid links (m), to first order: (|d|² − l²)/(2l).
double PassControl::farthest_off(const Vectors& position) const {
  const Links& links = model_.links;
  double farthest = 0.0;
  for (const Index link : rigid_) {
    const double length = links.length[link];
    const Vec3 difference = position.at(links.a[link]) - position.at(links.b[link]);
    farthest = std::max(farthest, std::abs(difference.squaredNorm() - length * length) / (2.0 * length));
  }
  return farthest;
}

}  // namespace taut
