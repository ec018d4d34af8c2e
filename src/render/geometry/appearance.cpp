#include "render/appearance.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <unordered_set>
#include <variant>

#include "geometry/mass_weight.h"

namespace taut {
namespace {

// A sheet's back where it has but one colour: what the looks' own two are to each other.
constexpr double shade_of_back = 0.78;

// Whether an object is drawn as a part: it says so itself, or leaves that to the look.
bool draws(const ObjectLook& look, std::string_view part, bool otherwise) {
  if (!look.visible) return false;
  if (!look.draw) return otherwise;
  return std::ranges::find(*look.draw, part) != look.draw->end();
}

bool in_families(const Look& look, LinkFamily family) {
  return std::ranges::find(look.families, link_families[static_cast<std::size_t>(family)]) !=
         look.families.end();
}

// A stretch of masses and links that are one object's.
struct ObjectExtent {
  Index first_mass = 0, mass_count = 0, first_link = 0, link_count = 0;
};

class AppearanceMaker {
 public:
  AppearanceMaker(const Model& model, const Look& look)
      : model_(model), look_(look), linked_(model.masses.size(), look.links) {
    made_.masses.assign(model.masses.size(), look.masses);
    made_.links.assign(model.links.size(), look.links);
    made_.there.assign(model.masses.size(), true);
    made_.shading.assign(model.masses.size(), false);
    made_.in_body.assign(model.masses.size(), false);
  }

  Appearance make() {
    for (std::size_t i = 0; i < model_.chains.size(); ++i) {
      const Chain& chain = model_.chains[i];
      add(look_of(look_.objects.chains, i),
          {chain.first_mass, chain.link_count + 1, chain.first_link, chain.link_count}, false);
    }
    for (std::size_t i = 0; i < model_.sheets.size(); ++i) add_sheet(i);
    for (std::size_t i = 0; i < model_.point_sets.size(); ++i) {
      const PointSet& set = model_.point_sets[i];
      add(look_of(look_.objects.points, i), {set.first_mass, set.mass_count, set.first_link, set.link_count},
          false);
    }
    for (std::size_t i = 0; i < model_.ragdolls.size(); ++i) add_body(i);
    add_singles();
    settle_links();
    add_solids();
    hide_masses_in_links();
    made_.scale = look_.colour_by != ColourBy::plain && uses_scale();
    return std::move(made_);
  }

 private:
  // `whole`: whether the object is drawn as one thing, in place of its masses and links.
  void add(const ObjectLook& own, const ObjectExtent& extent, bool whole) {
    made_.own_parts = made_.own_parts || own.draw.has_value();
    const bool masses = draws(own, "masses", look_.masses && !whole);
    const bool links = draws(own, "links", look_.links && !whole);
    for (Index mass = extent.first_mass; mass < extent.first_mass + extent.mass_count; ++mass) {
      made_.masses[mass] = masses;
      made_.there[mass] = own.shown();
      linked_[mass] = links;
      colour(made_.mass_colours, model_.masses.size(), mass, own);
    }
    for (Index link = extent.first_link; link < extent.first_link + extent.link_count; ++link) {
      made_.links[link] = links;
      colour(made_.link_colours, model_.links.size(), link, own);
    }
  }

  void add_sheet(std::size_t number) {
    const Sheet& sheet = model_.sheets[number];
    const ObjectLook& own = look_of_sheet(look_, model_, number);
    add(own, {sheet.first_mass, sheet.mass_count, sheet.first_link, sheet.link_count}, false);
    made_.sheets.push_back(draws(own, "surface", look_.surface));
    if (!made_.sheets.back()) return;
    for (Index mass = sheet.first_mass; mass < sheet.first_mass + sheet.mass_count; ++mass)
      made_.shading[mass] = true;
  }

  void add_body(std::size_t number) {
    const Ragdoll& body = model_.ragdolls[number];
    const ObjectLook& own = look_of(look_.objects.ragdolls, number);
    const bool bones = draws(own, "bones", look_.bones);
    add(own, {body.first_mass, body.mass_count, body.first_link, body.link_count}, bones && !own.draw);
    made_.bodies.push_back(bones);
    for (Index mass = body.first_mass; mass < body.first_mass + body.mass_count; ++mass)
      made_.in_body[mass] = bones;
    colour(made_.body_colours, model_.ragdolls.size(), number, own);
  }

  void add_singles() {
    const Singles& singles = model_.singles;
    for (Index i = 0; i < singles.mass_count; ++i)
      add(look_of(look_.objects.masses, i), {singles.first_mass + i, 1, 0, 0}, false);
    for (Index i = 0; i < singles.link_count; ++i)
      add(look_of(look_.objects.links, i), {0, 0, singles.first_link + i, 1}, false);
  }

  bool single(Index mass) const {
    return mass >= model_.singles.first_mass && mass < model_.singles.first_mass + model_.singles.mass_count;
  }

  // Links that end at an object which is hidden would hang in the air. A mass of its own that is hidden is
  // still to be seen by the links that it holds.
  void settle_links() {
    std::vector<Index> held;
    for (std::size_t link = 0; link < made_.links.size(); ++link) {
      const std::array<Index, 2> ends{model_.links.a[link], model_.links.b[link]};
      const bool hangs =
          std::ranges::any_of(ends, [this](Index end) { return !made_.there[end] && !single(end); });
      const bool inside = made_.in_body[ends[0]] && made_.in_body[ends[1]] && !of_body(link);
      if (hangs || inside || !in_families(look_, model_.links.family[link])) made_.links[link] = false;
      if (!made_.links[link]) continue;
      for (const Index end : ends)
        if (!made_.there[end]) held.push_back(end);
    }
    for (const Index mass : held) made_.there[mass] = true;
  }

  bool of_body(std::size_t link) const {
    return std::ranges::any_of(model_.ragdolls, [link](const Ragdoll& body) {
      return link >= body.first_link && link < std::size_t{body.first_link} + body.link_count;
    });
  }

  void add_solids() {
    const ObjectLooks& objects = look_.objects;
    std::size_t spheres = 0, capsules = 0, boxes = 0, mesh_solids = 0;
    for (std::size_t i = 0; i < model_.colliders.size(); ++i) {
      const Shape& shape = model_.colliders[i].shape;
      const ObjectLook plain;
      const ObjectLook& own = std::holds_alternative<Sphere>(shape)    ? look_of(objects.spheres, spheres++)
                              : std::holds_alternative<Capsule>(shape) ? look_of(objects.capsules, capsules++)
                              : std::holds_alternative<Box>(shape)     ? look_of(objects.boxes, boxes++)
                              : std::holds_alternative<MeshSolid>(shape)
                                  ? look_of(objects.mesh_solids, mesh_solids++)
                                  : plain;
      made_.solids.push_back(look_.colliders && own.visible);
      colour(made_.solid_colours, model_.colliders.size(), i, own);
    }
  }

  // In ropes and chains there are no masses to be seen but pins, heavy ones, and those beside them.
  void hide_masses_in_links() {
    if (look_.link_shape == LinkShape::rod || look_.mass_shape == MassShape::box) return;
    constexpr double heavy = 1.5;  // times the size of the median
    const std::vector<MassWeight> weights = mass_weights(model_, look_);
    const auto hide = [&](Index first, Index count) {
      for (Index mass = first; mass < first + count; ++mass)
        if (linked_[mass] && !model_.masses.pinned(mass) && !(weights[mass].size > heavy))
          made_.masses[mass] = false;
    };
    for (const Chain& chain : model_.chains) hide(chain.first_mass, chain.link_count + 1);
    for (const Sheet& sheet : model_.sheets) hide(sheet.first_mass, sheet.mass_count);
  }

  bool uses_scale() const {
    const auto any = [](const std::vector<bool>& flags) {
      return std::ranges::find(flags, true) != flags.end();
    };
    if (any(made_.links) || any(made_.sheets) || any(made_.bodies)) return true;
    if (look_.colour_by != ColourBy::speed && look_.colour_by != ColourBy::limit) return false;
    for (std::size_t mass = 0; mass < made_.masses.size(); ++mass)
      if (made_.masses[mass] && !model_.masses.pinned(mass)) return true;
    return false;
  }

  static void colour(std::vector<std::optional<Colour>>& colours, std::size_t count, std::size_t at,
                     const ObjectLook& own) {
    if (!own.colour) return;
    colours.resize(count);
    colours[at] = own.colour;
  }

  const Model& model_;
  const Look& look_;
  std::vector<bool> linked_;  // by mass: whether its object's links are drawn
  Appearance made_;
};

std::optional<Colour> colour_at(const std::vector<std::optional<Colour>>& colours, std::size_t at) {
  return colours.empty() ? std::nullopt : colours[at];
}

}  // namespace

const ObjectLook& look_of(const std::vector<ObjectLook>& looks, std::size_t number) {
  static const ObjectLook as_the_rest;
  return number < looks.size() ? looks[number] : as_the_rest;
}

Appearance appearance(const Model& model, const Look& look) {
  return AppearanceMaker(model, look).make();
}

bool hides_objects(const Look& look) {
  const ObjectLooks& all = look.objects;
  return std::ranges::any_of(
      std::array{&all.chains, &all.sheets, &all.meshes, &all.points, &all.ragdolls, &all.masses, &all.links},
      [](const std::vector<ObjectLook>* kind) {
        return std::ranges::any_of(*kind, [](const ObjectLook& own) { return !own.shown(); });
      });
}

std::vector<bool> masses_in_view(const Model& model, const Look& look) {
  if (!hides_objects(look)) return std::vector<bool>(model.masses.size(), true);
  std::vector<bool> seen = appearance(model, look).there;
  const std::unordered_set<std::string_view> trails(look.trails.begin(), look.trails.end());
  if (!trails.empty())
    for (std::size_t mass = 0; mass < seen.size(); ++mass)
      if (trails.contains(model.masses.name[mass])) seen[mass] = true;
  if (std::ranges::find(seen, true) == seen.end()) seen.assign(seen.size(), true);
  return seen;
}

const ObjectLook& look_of_sheet(const Look& look, const Model& model, std::size_t sheet) {
  const auto is_sheet = [](const Sheet& each) { return !each.is_mesh(); };
  const auto sheets = static_cast<std::size_t>(std::ranges::count_if(model.sheets, is_sheet));
  return sheet < sheets ? look_of(look.objects.sheets, sheet) : look_of(look.objects.meshes, sheet - sheets);
}

ClothColours cloth_colours(const Look& look, const Model& model, std::size_t sheet) {
  const ObjectLook& own = look_of_sheet(look, model, sheet);
  ClothColours colours{look.surface_colour, look.surface_back_colour};
  if (own.colour) {
    colours.front = *own.colour;
    for (std::size_t i = 0; i < 3; ++i) colours.back.at(i) = shade_of_back * own.colour->at(i);
  }
  if (own.back_colour) colours.back = *own.back_colour;
  return colours;
}

bool has_own_cloth_colours(const Look& look) {
  return look.colour_by == ColourBy::plain &&
         std::ranges::any_of(
             std::array{&look.objects.sheets, &look.objects.meshes}, [](const std::vector<ObjectLook>* kind) {
               return std::ranges::any_of(
                   *kind, [](const ObjectLook& own) { return own.colour || own.back_colour; });
             });
}

std::optional<Colour> own_mass_colour(const Appearance& appearance, std::size_t mass) {
  return colour_at(appearance.mass_colours, mass);
}

std::optional<Colour> own_link_colour(const Appearance& appearance, std::size_t link) {
  return colour_at(appearance.link_colours, link);
}

}  // namespace taut
