#include "geometry/body_parts.h"

#include <stdexcept>
#include <string>

#include "model/anthropometry.h"

namespace taut {
namespace {

class PartFinder {
 public:
  PartFinder(const Model& model, const Ragdoll& body) : model_(model), body_(body) {}

  BodyParts parts() const {
    BodyParts parts;
    parts.head = mass("head");
    parts.chest = mass("chest");
    parts.back = mass("back");
    parts.left = limbs("left_");
    parts.right = limbs("right_");
    parts.height = link_length(parts.left.shoulder, parts.right.shoulder) / winter::shoulder_width;
    return parts;
  }

 private:
  Index mass(const std::string& part) const {
    const std::string name = body_.name + "." + part;
    for (Index i = body_.first_mass; i < body_.first_mass + body_.mass_count; ++i)
      if (model_.masses.name[i] == name) return i;
    throw std::logic_error(name + " is missing");
  }

  Limbs limbs(const std::string& side) const {
    Limbs limbs;
    limbs.shoulder = mass(side + "shoulder");
    limbs.elbow = {mass(side + "elbow.left"), mass(side + "elbow.right")};
    limbs.wrist = mass(side + "wrist");
    limbs.hand = mass(side + "hand");
    limbs.hip = mass(side + "hip");
    limbs.knee = {mass(side + "knee.left"), mass(side + "knee.right")};
    limbs.ankle = mass(side + "ankle");
    limbs.toe = mass(side + "toe");
    return limbs;
  }

  double link_length(Index a, Index b) const {
    for (Index link = body_.first_link; link < body_.first_link + body_.link_count; ++link)
      if (model_.links.a[link] == a && model_.links.b[link] == b) return model_.links.length[link];
    throw std::logic_error(body_.name + " has no link between its shoulders");
  }

  const Model& model_;
  const Ragdoll& body_;
};

}  // namespace

std::vector<BodyParts> body_parts(const Model& model) {
  std::vector<BodyParts> parts;
  for (const Ragdoll& body : model.ragdolls) parts.push_back(PartFinder(model, body).parts());
  return parts;
}

}  // namespace taut
