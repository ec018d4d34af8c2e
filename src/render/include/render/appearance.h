#pragma once

#include <optional>
#include <vector>

#include "model/model.h"
#include "view/view.h"

namespace taut {

/// What a look draws of a model whatever moves, and which objects have a colour of their own: worked out once
/// for all pictures. Colours are empty lists where no object has one.
struct Appearance {
  std::vector<bool> masses;   ///< each one by itself, as the look's mass_shape
  std::vector<bool> links;    ///< each one, while it is whole
  std::vector<bool> sheets;   ///< each one's surface
  std::vector<bool> bodies;   ///< each ragdoll as a body
  std::vector<bool> solids;   ///< each of the model's colliders but planes
  std::vector<bool> in_body;  ///< each mass: whether a body is drawn in its place
  std::vector<bool> there;    ///< each mass: whether anything of what it belongs to is to be seen
  std::vector<bool> shading;  ///< each mass: whether what it belongs to is drawn as a surface, which has the
                              ///< shadow of both
  std::vector<std::optional<Colour>> mass_colours, link_colours, body_colours, solid_colours;
  bool scale = false;      ///< whether anything may have a colour of the look's scale
  bool own_parts = false;  ///< whether any object says itself what it is drawn as
};

Appearance appearance(const Model& model, const Look& look);

/// How the object of that number is drawn, in its kind's list.
const ObjectLook& look_of(const std::vector<ObjectLook>& looks, std::size_t number);

/// The sides of a sheet's cloth as a look has them.
struct ClothColours {
  Colour front, back;
};
ClothColours cloth_colours(const Look& look, const Model& model, std::size_t sheet);
/// How the model's sheet of that number is drawn: a sheet of the scene, or one of its meshes.
const ObjectLook& look_of_sheet(const Look& look, const Model& model, std::size_t sheet);
/// Whether any sheet has a side of a colour of its own, where colours are not those of a scale.
bool has_own_cloth_colours(const Look& look);

/// Whether a look hides any chain, sheet, ragdoll, mass or link.
bool hides_objects(const Look& look);

/// The masses that a camera is to keep in view: those of which anything is to be seen, and those with trails;
/// all of them where that is none.
std::vector<bool> masses_in_view(const Model& model, const Look& look);

/// A mass's own colour, where its object has one; a link's.
std::optional<Colour> own_mass_colour(const Appearance& appearance, std::size_t mass);
std::optional<Colour> own_link_colour(const Appearance& appearance, std::size_t link);

}  // namespace taut
