// Faces that touch. What is kept, step after step, is that no two of them pass through each other: when a
// step begins nothing does, and it ends only where nothing has met on the straight ways of all nodes from its
// start. (Frames between two steps lie on those ways.) Each pair of a point and a triangle, or of two edges,
// that is near is seen to in three ways, each for what the one before it leaves:
//
// 1. Passes. A pair is to be its thickness t apart. With the weights wₖ of the two places that are nearest to
//    each other and the direction n from one to the other,
//      C = Σ wₖ xₖ·n − g ≥ 0,   xₖ ← xₖ + (vₖ wₖ/Σ vⱼ wⱼ²) (−C n + f),     vₖ the inverse masses,
//    as a link that only pushes; f is Coulomb's friction on the way that the places have slid on each other
//    since the start of the step (contact/friction.h). n and wₖ are those where the nodes are going, or,
//    where the two could pass each other on the way there, those at the moment before they meet: so n always
//    points to the side that the pair was on. The gap g is t; a pair that began the step nearer than that is
//    let out by a quarter of what is missing, for to push all of it at once would give it that much speed.
// 2. Impulses. After the passes every pair that would still meet on its straight way gets the impulse of a
//    plastic impact there, as in 1 with g the distance that it had along n, or t. That is done over and over,
//    for one push may lead to another (Bridson, Fedkiw and Anderson, Robust Treatment of Collisions, Contact
//    and Friction for Cloth Animation, 2002, section 7.3).
// 3. Clusters. What still meets then moves on together, with the momentum that it has: all its nodes go the
//    same way, on which nothing can meet (rigid impact zones, the same, 7.5; Provot, 1997; without rotation).
//    What holds a pin goes the pin's way, and what touches a solid stays with it. Clusters that meet become
//    one, so this ends.
//
// Each push changes no momentum, for Σ wₖ = 0.

#include "contact/face_contacts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "contact/friction.h"

namespace taut {
namespace {

constexpr double not_known = -1.0;    // m
constexpr double let_out = 0.25;      // of what is missing of a gap, in a step
constexpr double never_nearer = 0.1;  // thicknesses, that pairs never come nearer than where they can help it
constexpr int most_rounds = 16;       // of impulses
constexpr std::size_t fewest_pairs_to_share = 4000;

bool finite(const std::vector<Vec3>& places) {
  return std::ranges::all_of(places, [](const Vec3& place) { return place.allFinite(); });
}

double friction_of(const FaceMesh& mesh, const FacePair& pair) {
  const FaceMesh::Group &a = mesh.groups[mesh.group[pair.nodes[0]]],
                        &b = mesh.groups[mesh.group[pair.nodes[3]]];
  if (a.faces == nullptr) return a.friction;
  if (b.faces == nullptr) return b.friction;
  return std::sqrt(a.friction * b.friction);
}

// Whether contact of a pair is seen to elsewhere: that of corners with solids by ContactSolver, that of an
// edge's end by the pair of it and a triangle.
bool left_to_others(const FaceMesh& mesh, const FacePair& pair, const FaceGap& gap) {
  if (pair.edges) return std::ranges::any_of(gap.weights, [](double weight) { return weight == 0.0; });
  if (mesh.of_solid(pair.nodes[1])) return true;
  return mesh.of_solid(pair.nodes[0]) && std::any_of(gap.weights.begin() + 1, gap.weights.end(),
                                                     [](double weight) { return weight == -1.0; });
}

double height_above(const HalfSpace& ground, const Vec3& place) {
  return (place - ground.point).dot(ground.normal);
}

Vec3 weighed(const FacePair& pair, const std::array<double, 4>& weights, const std::vector<Vec3>& places) {
  return (weights[0] * places[pair.nodes[0]] + weights[1] * places[pair.nodes[1]]) +
         (weights[2] * places[pair.nodes[2]] + weights[3] * places[pair.nodes[3]]);
}

}  // namespace

FaceContacts::FaceContacts(const Model& model, const std::shared_ptr<Workers>& workers)
    : model_(model), none_(model.faces.empty()), search_(model, workers), workers_(workers) {
  if (none_) return;
  for (const Collider& collider : model.colliders)
    if (const auto* half_space = std::get_if<HalfSpace>(&collider.shape))
      grounds_.push_back({&collider, *half_space, *half_space});
}

void FaceContacts::links_changed(const State& state) {
  if (!none_) search_.links_changed(state);
}

void FaceContacts::find_pairs(bool from_new_start) {
  if (search_.cover(start_, end_) || from_new_start)
    distance_at_start_.assign(search_.pairs().size(), not_known);
}

double FaceContacts::distance_at_start(std::size_t pair) {
  double& distance = distance_at_start_[pair];
  if (distance == not_known) distance = nearest_gap(search_.pairs()[pair], start_).distance;
  return distance;
}

// Nearer than which a pair never comes: a small part of its thickness, or half the gap that there is.
double FaceContacts::stop(std::size_t pair) {
  const FacePair& which = search_.pairs()[pair];
  const double clear = kept_clear(search_.mesh(), which);
  return clear + std::min(never_nearer * (kept_apart(search_.mesh(), which) - clear),
                          0.5 * (distance_at_start(pair) - clear));
}

FaceContacts::Contact FaceContacts::contact_at(const FacePair& pair, const FaceGap& gap) const {
  Contact contact;
  contact.pair = pair;
  contact.weights = gap.weights;
  contact.normal = gap.apart / gap.distance;
  contact.at_start = weighed(pair, gap.weights, start_);
  contact.friction = friction_of(search_.mesh(), pair);
  return contact;
}

std::size_t FaceContacts::sections() const {
  return search_.pairs().size() < fewest_pairs_to_share ? 1 : most_sections;
}

std::size_t FaceContacts::section_begin(std::size_t section) const {
  return search_.pairs().size() * section / sections();
}

void FaceContacts::prepare(std::size_t pair, std::vector<Contact>& contacts) {
  const FacePair& which = search_.pairs()[pair];
  const double apart = kept_apart(search_.mesh(), which), clear = kept_clear(search_.mesh(), which);
  const double thickness = apart - clear, watched = watched_apart(search_.mesh(), which);
  if (search_.least_distance(which) > watched) return;
  const double distance = distance_at_start(pair), approach = most_approach(which, start_, end_);
  if (distance - approach > watched || !(distance > clear)) return;
  FaceMeeting met;
  if (approach > distance - clear)
    met = first_meeting(which, start_, end_, distance, clear + std::min(thickness, 0.5 * (distance - clear)));
  const FaceGap gap = met.met ? met.gap : nearest_gap(which, end_);
  if (gap.distance > watched || !(gap.distance > 0.0) || left_to_others(search_.mesh(), which, gap)) return;
  Contact contact = contact_at(which, gap);
  contact.gap = distance + (distance < apart ? let_out * (apart - distance) : apart - distance);
  contacts.push_back(contact);
}

void FaceContacts::begin_step(const Vectors& start, const Vectors& predicted, double start_time,
                              double end_time) {
  if (none_) return;
  touched_ = false;
  impulse_way_ = 0.0;
  end_time_ = end_time;
  for (std::vector<Contact>& contacts : contacts_) contacts.clear();
  search_.mesh().places(start, start_time, start_);
  search_.mesh().places(predicted, end_time, end_);
  for (Ground& ground : grounds_) {
    if (!ground.collider->motion) continue;
    ground.from = placement_at(*ground.collider->motion, start_time);
    ground.to = placement_at(*ground.collider->motion, end_time);
    ground.start = std::get<HalfSpace>(shape_at(*ground.collider, start_time));
    ground.end = std::get<HalfSpace>(shape_at(*ground.collider, end_time));
  }
  finite_ = finite(start_) && finite(end_);
  if (!finite_) return;  // the step will be refused
  search_.begin_step(start_, end_);
  find_pairs(true);
  run_jobs(workers_.get(), sections(), [&](std::size_t section) {
    for (std::size_t pair = section_begin(section); pair < section_begin(section + 1); ++pair)
      prepare(pair, contacts_.at(section));
  });
}

bool FaceContacts::push(const Contact& contact, std::vector<Vec3>& places) {
  const std::vector<double>& inverse_mass = search_.mesh().inverse_mass;
  const Vec3 apart = weighed(contact.pair, contact.weights, places);
  const double depth = contact.gap - apart.dot(contact.normal);
  if (!(depth > 0.0)) return false;
  double sum = 0.0;
  for (std::size_t k = 0; k < 4; ++k)
    sum += inverse_mass[contact.pair.nodes[k]] * contact.weights[k] * contact.weights[k];
  if (!(sum > 0.0)) return false;
  const Vec3 change = depth * contact.normal +
                      coulomb_friction(contact.friction, depth, contact.normal, apart - contact.at_start);
  for (std::size_t k = 0; k < 4; ++k) {
    const std::uint32_t node = contact.pair.nodes[k];
    places[node] += (inverse_mass[node] * contact.weights[k] / sum) * change;
    if (inverse_mass[node] == 0.0)
      impulse_way_ -= contact.weights[k] / sum * change.dot(end_[node] - start_[node]);
  }
  return true;
}

void FaceContacts::put(Vectors& position) const {
  const FaceMesh& mesh = search_.mesh();
  for (std::size_t node = 0; node < mesh.mass.size(); ++node)
    if (mesh.inverse_mass[node] > 0.0) position.set(mesh.mass[node], end_[node]);
}

void FaceContacts::solve(Vectors& position) {
  if (std::ranges::all_of(contacts_, &std::vector<Contact>::empty)) return;
  search_.mesh().places(position, end_time_, end_);
  bool pushed = false;
  for (const std::vector<Contact>& contacts : contacts_)
    for (const Contact& contact : contacts) pushed = push(contact, end_) || pushed;
  if (!pushed) return;
  touched_ = true;
  put(position);
}

FaceMeeting FaceContacts::meeting(std::size_t pair) {
  const FacePair& which = search_.pairs()[pair];
  if (search_.least_distance(which) > kept_apart(search_.mesh(), which)) return {};
  return first_meeting(which, start_, end_, distance_at_start(pair), stop(pair));
}

// As many as there are where none does. Most steps end with that.
std::size_t FaceContacts::first_that_meets() {
  std::array<std::size_t, most_sections> first{};
  first.fill(search_.pairs().size());
  run_jobs(workers_.get(), sections(), [&](std::size_t section) {
    const std::size_t end = section_begin(section + 1);
    std::size_t pair = section_begin(section);
    while (pair < end && !meeting(pair).met) ++pair;
    if (pair < end) first.at(section) = pair;
  });
  return *std::ranges::min_element(first);
}

// One push may lead to another meeting further on: so pairs are gone through one by one.
bool FaceContacts::push_apart_what_meets() {
  bool any = false;
  for (std::size_t pair = first_that_meets(); pair < search_.pairs().size(); ++pair) {
    const FaceMeeting met = meeting(pair);
    if (!met.met) continue;
    any = true;
    const FacePair& which = search_.pairs()[pair];
    Contact contact = contact_at(which, met.gap);
    const double clear = kept_clear(search_.mesh(), which);
    contact.gap = std::max(std::min(kept_apart(search_.mesh(), which), contact.at_start.dot(contact.normal)),
                           clear + 2.0 * (stop(pair) - clear));
    push(contact, end_);
  }
  return any;
}

// Straight ways that begin above the ground and end there never leave it.
bool FaceContacts::under(const Ground& ground, std::uint32_t node) const {
  const double start = height_above(ground.start, start_[node]);
  return search_.mesh().inverse_mass[node] > 0.0 && start > 0.0 &&
         height_above(ground.end, end_[node]) <
             std::min(never_nearer * search_.mesh().radius[node], 0.5 * start);
}

bool FaceContacts::lift_from_ground() {
  bool any = false;
  for (const Ground& ground : grounds_)
    for (const std::uint32_t node : search_.whole().points) {
      if (!under(ground, node)) continue;
      any = true;
      const double wanted = std::min(search_.mesh().radius[node], height_above(ground.start, start_[node]));
      const Vec3 lift = (wanted - height_above(ground.end, end_[node])) * ground.end.normal;
      if (ground.collider->motion)
        impulse_way_ += lift.dot(end_[node] - ground.from.place(ground.to.back(end_[node]))) /
                        search_.mesh().inverse_mass[node];
      end_[node] += lift;
    }
  return any;
}

// Nodes that move on together, and the grounds, which are one more node each.
class FaceContacts::Clusters {
 public:
  Clusters(const FaceMesh& mesh, const Model& model, std::size_t grounds)
      : mesh_(mesh), model_(model), leader_(mesh.size() + grounds) {
    std::iota(leader_.begin(), leader_.end(), 0U);
  }

  // Whether they were apart. The lowest number leads.
  bool unite(std::uint32_t a, std::uint32_t b) {
    a = leader(a);
    b = leader(b);
    leader_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }
  bool unite_with_ground(std::uint32_t node, std::size_t ground) {
    return unite(node, mesh_.size() + static_cast<std::uint32_t>(ground));
  }

  // Gives what those that are held have done (kg m²): Σ impulse × h · way.
  double move(const std::vector<Ground>& grounds, const std::vector<Vec3>& start, std::vector<Vec3>& end) {
    double done = 0.0;
    ways_.assign(leader_.size(), Way{});
    for (std::uint32_t node = 0; node < mesh_.size(); ++node) {
      const Vec3 moved = end[node] - start[node];
      if (mesh_.inverse_mass[node] == 0.0)
        hold(node, moved);
      else
        carry(node, model_.masses.mass[mesh_.mass[node]], moved);
    }
    for (std::uint32_t i = 0; i < grounds.size(); ++i)
      hold(mesh_.size() + i, grounds[i].end.point - grounds[i].start.point);
    for (std::uint32_t node = 0; node < mesh_.mass.size(); ++node) {
      const Way& way = ways_[leader(node)];
      if (way.count < 2 || mesh_.inverse_mass[node] == 0.0) continue;
      const Vec3 goes = start[node] + (way.held ? way.of_held : Vec3(way.momentum / way.mass));
      if (way.held) done += (goes - end[node]).dot(way.of_held) * model_.masses.mass[mesh_.mass[node]];
      end[node] = goes;
    }
    return done;
  }

 private:
  struct Way {
    std::uint32_t count = 0;
    bool held = false;
    Vec3 of_held = Vec3::Zero(), momentum = Vec3::Zero();  // m; kg m
    double mass = 0.0;                                     // kg
  };

  void hold(std::uint32_t node, const Vec3& moved) {
    Way& way = ways_[leader(node)];
    ++way.count;
    if (!way.held) way.of_held = moved;
    way.held = true;
  }
  void carry(std::uint32_t node, double mass, const Vec3& moved) {
    Way& way = ways_[leader(node)];
    ++way.count;
    way.mass += mass;
    way.momentum += mass * moved;
  }

  std::uint32_t leader(std::uint32_t node) {
    while (leader_[node] != node) node = leader_[node] = leader_[leader_[node]];
    return node;
  }

  const FaceMesh& mesh_;
  const Model& model_;
  std::vector<std::uint32_t> leader_;
  std::vector<Way> ways_;  // of each leader
};

bool FaceContacts::hold_together() {
  Clusters clusters(search_.mesh(), model_, grounds_.size());
  for (;;) {
    bool met = false, grown = false;
    for (std::size_t pair = 0; pair < search_.pairs().size(); ++pair) {
      if (!meeting(pair).met) continue;
      met = true;
      const auto& nodes = search_.pairs()[pair].nodes;
      for (std::size_t k = 1; k < 4; ++k) grown = clusters.unite(nodes[0], nodes[k]) || grown;
    }
    for (std::size_t ground = 0; ground < grounds_.size(); ++ground)
      for (const std::uint32_t node : search_.whole().points) {
        if (!under(grounds_[ground], node)) continue;
        met = true;
        grown = clusters.unite_with_ground(node, ground) || grown;
      }
    if (!met) return true;
    if (!grown) return false;
    impulse_way_ += clusters.move(grounds_, start_, end_);
    find_pairs(false);
  }
}

bool FaceContacts::finish(Vectors& position) {
  if (none_ || !finite_) return true;
  search_.mesh().places(position, end_time_, end_);
  if (!finite(end_)) return true;
  bool pushed = false;
  for (int round = 0; round < most_rounds; ++round) {
    find_pairs(false);
    const bool met = push_apart_what_meets(), low = lift_from_ground();
    if (!met && !low) {
      if (pushed) put(position);
      return true;
    }
    pushed = touched_ = true;
  }
  find_pairs(false);
  if (!hold_together()) return false;
  put(position);
  return true;
}

}  // namespace taut
