#include "geometry/supports.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "geometry/body_parts.h"
#include "geometry/view_matrices.h"
#include "render/camera.h"

namespace taut {
namespace {

// The places that bound a pin's way: a path keeps between its knots, a swing between its turning points.
std::vector<Vec3> turning_places(const Motion& motion) {
  std::vector<Vec3> places;
  if (const auto* path = std::get_if<Path>(&motion)) {
    for (const Knot& knot : path->knots) places.push_back(knot.position);
  } else if (const auto* swing = std::get_if<Sinusoid>(&motion)) {
    places = {swing->rest - swing->amplitude, swing->rest + swing->amplitude};
  }
  return places;
}

struct SupportedPin {
  Index mass;
  Vec3 at;                 // m, at the start
  std::vector<Vec3> ways;  // where its motion takes it at most; `at` alone where it stays
  bool moves;
  Vec3 pull;  // towards the masses it is linked to, their mean (m)
};

// A straight stretch: from its middle in a direction of unit length.
struct Stretch {
  Vec3 middle, direction;
  double low, high;  // m, of what lies on it

  Vec3 at(double along) const { return middle + along * direction; }
  double length() const { return high - low; }
};

// The straight line that some places lie on, within a thousandth of its length.
std::optional<Stretch> line_through(const std::vector<Vec3>& places) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& place : places) middle += place / static_cast<double>(places.size());
  Vec3 farthest = Vec3::Zero();
  for (const Vec3& place : places)
    if ((place - middle).norm() > farthest.norm()) farthest = place - middle;
  if (!(farthest.norm() > 0.0)) return std::nullopt;
  Stretch line{middle, farthest.normalized(), 0.0, 0.0};
  double off = 0.0;
  for (const Vec3& place : places) {
    const double along = (place - middle).dot(line.direction);
    line.low = std::min(line.low, along);
    line.high = std::max(line.high, along);
    off = std::max(off, (place - line.at(along)).norm());
  }
  return off <= 1e-3 * line.length() ? std::optional(line) : std::nullopt;
}

std::vector<Vec3> all_ways(const std::vector<const SupportedPin*>& pins) {
  std::vector<Vec3> places;
  for (const SupportedPin* pin : pins) places.insert(places.end(), pin->ways.begin(), pin->ways.end());
  return places;
}

// Across a ball around all masses that are seen (m): the same however they are turned.
double extent_of(const Vectors& start, const std::vector<bool>* seen) {
  std::vector<std::size_t> masses;
  for (std::size_t i = 0; i < start.size(); ++i)
    if (seen == nullptr || (*seen)[i]) masses.push_back(i);
  Vec3 middle = Vec3::Zero();
  for (const std::size_t i : masses) middle += start.at(i) / static_cast<double>(masses.size());
  double reach = 0.0;
  for (const std::size_t i : masses) reach = std::max(reach, (start.at(i) - middle).norm());
  return 2.0 * reach;
}

class SupportMaker {
 public:
  SupportMaker(const Model& model, const Vectors& start, const SupportSight& sight)
      : model_(model),
        start_(start),
        sight_(sight),
        extent_(extent_of(start, sight.seen)),
        unit_(std::max(0.0105 * extent_, 0.3 * sight.pin_radius)) {
    find_pins();
  }

  Supports make() {
    for (const Sheet& sheet : model_.sheets)
      if (!sheet.is_mesh()) hold_edges(sheet);
    hold_bodies();
    hold_others();
    return std::move(made_);
  }

 private:
  void find_pins() {
    const std::size_t count = model_.masses.size();
    std::vector<Vec3> towards(count, Vec3::Zero());
    std::vector<double> links(count, 0.0);
    for (std::size_t link = 0; link < model_.links.size(); ++link) {
      const Index a = model_.links.a[link], b = model_.links.b[link];
      const Vec3 span = start_.at(b) - start_.at(a);
      towards[a] += span;
      towards[b] -= span;
      links[a] += 1.0;
      links[b] += 1.0;
    }
    for (const DrivenPin& driven : model_.driven_pins)
      if (std::holds_alternative<Carried>(driven.motion)) links[driven.mass] = 0.0;  // a solid holds it
    pin_of_mass_.assign(count, none);
    for (std::size_t mass = 0; mass < count; ++mass) {
      if (!model_.masses.pinned(mass) || links[mass] == 0.0) continue;
      if (sight_.seen != nullptr && !(*sight_.seen)[mass]) continue;
      pin_of_mass_[mass] = pins_.size();
      const Vec3 at = start_.at(mass);
      pins_.push_back({static_cast<Index>(mass), at, {at}, false, towards[mass] / links[mass]});
    }
    for (const DrivenPin& driven : model_.driven_pins) {
      if (pin_of_mass_[driven.mass] == none) continue;
      SupportedPin& pin = pins_[pin_of_mass_[driven.mass]];
      pin.ways = turning_places(driven.motion);
      const Vec3 first = pin.ways.front();
      pin.moves = std::ranges::any_of(pin.ways, [&](const Vec3& place) { return place != first; });
    }
    held_.assign(pins_.size(), false);
  }

  // How far below a place (m) there is ground to stand on.
  std::optional<double> above_ground(const Vec3& place) const {
    std::optional<double> nearest;
    for (const Ground& ground : sight_.grounds) {
      const double steepness = ground.normal.dot(sight_.up);
      if (steepness < 0.1) continue;
      const double height = ground.normal.dot(place - ground.point) / steepness;
      if (height > -unit_ && height < 4.0 * extent_ && (!nearest || height < *nearest)) nearest = height;
    }
    return nearest;
  }

  Vec3 across_up(const Vec3& vector) const { return vector - sight_.up * sight_.up.dot(vector); }

  void rod(const Vec3& start, double start_radius, const Vec3& end, double end_radius, Material material) {
    made_.fixed.push_back({start, end, start_radius * unit_, end_radius * unit_, Vec3::Zero(), material});
  }
  void ball(const Vec3& centre, double radius, Material material) {
    rod(centre, radius, centre, radius, material);
  }
  void disc(const Vec3& centre, double radius, const Vec3& axis, double thickness, Material material) {
    ball(centre, radius, material);
    made_.fixed.back().squeeze = std::sqrt(1.0 - thickness) * axis;
  }
  // A short piece of a beam, its lower side at a place.
  void beam(const Vec3& place, const Vec3& along, double share) {
    const Vec3 level = across_up(along);
    const Vec3 first =
        level.norm() > 1e-6 * extent_ ? Vec3(level.normalized()) : Vec3(upright_axes(sight_.up).col(0));
    const Vec3 half_size = share * unit_ * Vec3(7.5, 1.2, 2.4);
    Box box{place + half_size.y() * sight_.up, half_size, {}};
    box.axes.col(0) = first;
    box.axes.col(1) = sight_.up;
    box.axes.col(2) = first.cross(sight_.up);
    made_.beams.push_back(box);
  }
  void carry(Index mass, SupportPart part) { made_.carried.push_back({mass, std::move(part)}); }

  // From the masses first, first + step, …
  void hold_edges(const Sheet& sheet) {
    const Index rows = sheet.rows, columns = sheet.columns, first = sheet.first_mass;
    hold_edge(first, 1, columns);
    hold_edge(first + (rows - 1) * columns, 1, columns);
    hold_edge(first, columns, rows);
    hold_edge(first + columns - 1, columns, rows);
  }

  void hold_edge(Index first, Index step, Index count) {
    std::vector<const SupportedPin*> pins;
    for (Index i = 0; i < count; ++i)
      if (const std::size_t pin = pin_of_mass_[first + i * step]; pin != none) pins.push_back(&pins_[pin]);
    if (pins.size() < 3) return;
    if (pins.size() == count && moved_as_one(pins)) return carry_bar(pins);
    const std::optional<Stretch> line = line_through(all_ways(pins));
    if (!line) return;
    const bool moves = std::ranges::any_of(pins, [](const SupportedPin* pin) { return pin->moves; });
    const bool upright = std::abs(line->direction.dot(sight_.up)) > 0.94;
    if (upright && !moves)
      add_pole(*line);
    else if (pins.size() == count && !moves)
      add_bar(*line);
    else if (!upright)
      add_rail(*line, pins);
    else
      return;
    for (const SupportedPin* pin : pins) held_[pin_of_mass_[pin->mass]] = true;
  }

  // Whether all pins move, and keep their places to each other.
  bool moved_as_one(const std::vector<const SupportedPin*>& pins) const {
    const SupportedPin& first = *pins.front();
    return std::ranges::all_of(pins, [&](const SupportedPin* pin) {
      if (!pin->moves || pin->ways.size() != first.ways.size()) return false;
      for (std::size_t i = 0; i < first.ways.size(); ++i)
        if ((pin->ways[i] - pin->at - first.ways[i] + first.at).norm() > 1e-9 * extent_) return false;
      return true;
    });
  }

  // A bar along an edge that moves along with it.
  void carry_bar(const std::vector<const SupportedPin*>& pins) {
    std::vector<Vec3> places;
    places.reserve(pins.size());
    for (const SupportedPin* pin : pins) places.push_back(pin->at);
    const std::optional<Stretch> line = line_through(places);
    if (!line) return;
    const SupportedPin& first = *pins.front();
    const Vec3 start = line->at(line->low - 3.0 * unit_) - first.at,
               end = line->at(line->high + 3.0 * unit_) - first.at;
    carry(first.mass, {start, end, unit_, unit_, Vec3::Zero(), Material::wood});
    for (const Vec3& tip : {start, end})
      carry(first.mass, {tip, tip, 1.9 * unit_, 1.9 * unit_, Vec3::Zero(), Material::metal});
    for (const SupportedPin* pin : pins) held_[pin_of_mass_[pin->mass]] = true;
  }

  void add_pole(const Stretch& line) {
    const double rise = line.direction.dot(sight_.up) > 0.0 ? 1.0 : -1.0;
    const Vec3 up = rise * line.direction;
    const Vec3 lowest = line.at(rise > 0.0 ? line.low : line.high),
               highest = line.at(rise > 0.0 ? line.high : line.low);
    const std::optional<double> height = above_ground(lowest);
    const Vec3 foot = lowest - height.value_or(0.35 * line.length()) / up.dot(sight_.up) * up;
    const Vec3 top = highest + 5.0 * unit_ * up;
    rod(foot, 1.3, top, 1.0, Material::wood);
    ball(top + 1.5 * unit_ * up, 2.1, Material::metal);
    if (height) disc(foot, 4.5, sight_.up, 0.25, Material::metal);
  }

  void add_bar(const Stretch& line) {
    const Vec3 start = line.at(line.low - 3.0 * unit_), end = line.at(line.high + 3.0 * unit_);
    rod(start, 1.0, end, 1.0, Material::wood);
    for (const Vec3& tip : {start, end}) ball(tip, 1.9, Material::metal);
  }

  void add_rail(const Stretch& line, const std::vector<const SupportedPin*>& pins) {
    // The cloth hangs from the lower side of its rings.
    constexpr double ring = 1.8, lift = 1.7;
    const Vec3 upward =
        (sight_.up - line.direction * line.direction.dot(sight_.up)).normalized() * (lift * unit_);
    const Vec3 start = line.at(line.low - 4.0 * unit_) + upward,
               end = line.at(line.high + 4.0 * unit_) + upward;
    rod(start, 0.8, end, 0.8, Material::wood);
    for (const Vec3& tip : {start, end}) ball(tip, 1.7, Material::wood);
    for (const SupportedPin* pin : pins) {
      const Vec3 squeeze = std::sqrt(1.0 - 0.3) * line.direction;
      carry(pin->mass, {upward, upward, ring * unit_, ring * unit_, squeeze, Material::metal});
    }
  }

  void hold_bodies() {
    const std::vector<BodyParts> parts = body_parts(model_);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Ragdoll& body = model_.ragdolls[i];
      const Vec3 sideways = across_up(start_.at(parts[i].left.shoulder) - start_.at(parts[i].right.shoulder));
      for (Index mass = body.first_mass; mass < body.first_mass + body.mass_count; ++mass) {
        const std::size_t pin = pin_of_mass_[mass];
        if (pin == none || held_[pin]) continue;
        held_[pin] = true;
        add_grip(pins_[pin].at, sideways, parts[i].height);
      }
    }
  }

  // A bar that a hand or foot holds on to, and what it hangs from.
  void add_grip(const Vec3& at, const Vec3& sideways, double height) {
    const double share = 0.0105 * height / unit_;
    const Vec3 along = sideways.norm() > 1e-9 * height ? Vec3(sideways.normalized()) : Vec3(Vec3::Zero());
    const double reach = 8.0 * share * unit_, rise = 14.0 * share * unit_;
    const Vec3 top = at + rise * sight_.up;
    for (const double side : {-1.0, 1.0}) {
      const Vec3 tip = at + side * reach * along;
      ball(tip, 1.5 * share, Material::metal);
      rod(tip, 0.45 * share, top, 0.45 * share, Material::metal);
    }
    rod(at - reach * along, share, at + reach * along, share, Material::wood);
    beam(top, along, share);
  }

  void hold_others() {
    std::vector<const SupportedPin*> others;
    for (std::size_t i = 0; i < pins_.size(); ++i)
      if (!held_[i] && !pins_[i].moves) others.push_back(&pins_[i]);
    const bool on_posts = stand_on_posts(others);
    for (const SupportedPin* pin : others) {
      const std::optional<double> height = above_ground(pin->at);
      if (height && *height < 3.0 * unit_)
        rod(pin->at - (*height + unit_) * sight_.up, 0.9, pin->at + unit_ * sight_.up, 0.9, Material::wood);
      else if (on_posts)
        add_post(*pin, height.value_or(0.5 * extent_), height.has_value());
      else
        add_bracket(*pin);
    }
    for (std::size_t i = 0; i < pins_.size(); ++i)
      if (!held_[i] && pins_[i].moves) add_handle(pins_[i]);
  }

  // Whether pins are spread out level rather than in a row, and all pulled at from the side.
  bool stand_on_posts(const std::vector<const SupportedPin*>& pins) const {
    if (pins.size() < 3) return false;
    Vec3 middle = Vec3::Zero();
    for (const SupportedPin* pin : pins) middle += pin->at / static_cast<double>(pins.size());
    Vec3 farthest = Vec3::Zero();
    double upright = 0.0;
    for (const SupportedPin* pin : pins) {
      const Vec3 off = across_up(pin->at - middle);
      if (off.norm() > farthest.norm()) farthest = off;
      upright = std::max(upright, std::abs((pin->at - middle).dot(sight_.up)));
      if (std::abs(pin->pull.dot(sight_.up)) > 0.7 * pin->pull.norm()) return false;
    }
    const double length = farthest.norm();
    double breadth = 0.0;
    for (const SupportedPin* pin : pins) {
      const Vec3 off = across_up(pin->at - middle);
      if (length > 0.0) breadth = std::max(breadth, off.cross(farthest).norm() / length);
    }
    return upright < 0.3 * length && breadth > 0.1 * length;
  }

  void add_post(const SupportedPin& pin, double height, bool on_ground) {
    // Beside the pin, where it doesn't hide what is tied to it.
    const Vec3 outward = -across_up(pin.pull);
    const double beside = sight_.pin_radius + 0.6 * unit_;
    const Vec3 axis = outward.norm() > 1e-6 * extent_ ? Vec3(pin.at + beside * outward.normalized()) : pin.at;
    const Vec3 foot = axis - height * sight_.up, top = axis + 2.5 * unit_ * sight_.up;
    rod(foot, 1.1, top, 0.85, Material::wood);
    disc(axis, 1.5, sight_.up, 0.5, Material::metal);
    if (on_ground) disc(foot, 3.0, sight_.up, 0.25, Material::wood);
  }

  void add_bracket(const SupportedPin& pin) {
    const Vec3 top = pin.at + (sight_.pin_radius + 4.0 * unit_) * sight_.up;
    rod(pin.at, 0.6, top, 1.1, Material::metal);
    beam(top, across_up(pin.pull), 1.0);
  }

  void add_handle(const SupportedPin& pin) {
    const Vec3 top = (sight_.pin_radius + 3.5 * unit_) * sight_.up;
    carry(pin.mass, {Vec3::Zero(), top, 0.6 * unit_, 0.6 * unit_, Vec3::Zero(), Material::metal});
    carry(pin.mass, {top, top, 1.8 * unit_, 1.8 * unit_, Vec3::Zero(), Material::wood});
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  const Model& model_;
  const Vectors& start_;  // m
  const SupportSight& sight_;
  double extent_, unit_;  // m; thicknesses are in units
  std::vector<SupportedPin> pins_;
  std::vector<std::size_t> pin_of_mass_;
  std::vector<bool> held_;  // one a pin
  Supports made_;
};

}  // namespace

Supports supports(const Model& model, const Vectors& start, const SupportSight& sight) {
  return SupportMaker(model, start, sight).make();
}

}  // namespace taut
