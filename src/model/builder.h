#pragma once

#include <numbers>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/description.h"
#include "model/size.h"
#include "model/turned.h"

namespace taut {

inline constexpr double degree = std::numbers::pi / 180.0;  // rad

/// A Model and its start while they grow, mass by mass and link by link.
class Builder {
 public:
  /// What is added from now on is a body of its own, which touches other bodies or none.
  void begin_body(bool collides) { body_ = collides ? bodies_++ : no_body; }
  /// Links that are added from now on come from this entry of this section.
  void begin_entry(std::string_view section, std::size_t index) {
    entries.push_back({section, index, static_cast<Index>(model.links.size())});
  }
  /// Adds a mass and returns its index. Its radius is that of contact (m).
  Index add_mass(std::string name, const Vec3& position, const Vec3& velocity, double mass, bool pinned,
                 double radius = 0.0);
  /// Adds a link and returns its index.
  Index add_link(Index a, Index b, double length, const LinkProperties& properties,
                 LinkFamily family = LinkFamily::structural);
  /// Adds a bend, unless its stiffness is 0, which rests as it starts or as it says.
  void add_bend(Bend bend, bool from_start);
  /// Adds a bone, which touches what there is to touch in place of the masses at its ends.
  void add_bone(const Bone& bone);
  /// Drives a pinned mass, which is put where the motion begins; a spec that names no motion does nothing.
  void drive(Index mass, const MotionSpec& motion);
  void drive(Index mass, Motion motion);
  /// The body that is being added; no_body where it touches none.
  Index body() const { return body_; }
  /// Multiplies what a link bears: its tension, and its stretch beyond its length.
  void weaken(Index link, double share);
  /// Lets links break, and the pin of a mass go, at a time (s); nothing where there is no pin or no time.
  void break_links_at(double time, const std::vector<Index>& links);
  void release_at(Index mass, const std::optional<double>& time);
  /// Whether anything touches other bodies.
  bool any_body() const { return bodies_ > 0; }

  Model model;
  State start;
  std::vector<Index> body_of_mass, body_of_bone;
  std::unordered_map<std::string, SolidMotion> solid_motions;  ///< of those that have a name

  /// An entry of a description and the first of its links, which reach to the first one of the next entry.
  struct Entry {
    std::string_view section;
    std::size_t index;
    Index first_link;
  };
  std::vector<Entry> entries;
  /// The entry that a link comes from.
  const Entry& entry_of(Index link) const;

 private:
  Change& change_at(double time);
  void add_free_range(Index link, const LinkProperties& properties);

  Index body_ = no_body, bodies_ = 0;
};

/// An entry of a description: its section, and which of that it is.
struct SectionEntry {
  std::string_view section;
  std::size_t index = 0;
};

using MassesByName = std::unordered_map<std::string_view, Index>;

/// Adds all of a valid chain; the description has the solids that it may be wound around.
void add_chain(Builder& builder, const ChainSpec& spec, const Description& description);

/// Adds all of a valid sheet.
void add_sheet(Builder& builder, const SheetSpec& spec);

/// Adds all of a valid mesh, and of valid points.
void add_mesh(Builder& builder, const MeshSpec& spec);
void add_points(Builder& builder, const PointsSpec& spec);

/// Which vertices of a valid mesh are pinned.
std::vector<bool> pinned_vertices(const MeshSpec& spec);

/// The entry of a description that one of the model's sheets comes from: a sheet's or a mesh's.
SectionEntry sheet_entry(const Description& description, std::size_t sheet);

/// Adds all of a valid ragdoll; reports joints that are outside their ranges at the start.
void add_ragdoll(Builder& builder, const RagdollSpec& spec, std::size_t index,
                 std::vector<Problem>& problems);

/// Adds the links of ties; reports names that no mass has, and masses that can't be tied.
void add_ties(Builder& builder, const std::vector<TieSpec>& specs, std::vector<Problem>& problems);

/// Lets links give way where seams are; reports names that nothing has, and seams without links.
void add_seams(Builder& builder, const Description& description, std::vector<Problem>& problems);

/// Adds the limits on angles; reports names that no mass has, angles without a direction, and those outside
/// their range at the start.
void add_limits(Builder& builder, const Description& description, const MassesByName& by_name,
                std::vector<Problem>& problems);

/// Adds what masses can hit: before the pins that solids carry.
void add_solids(Builder& builder, const Description& description);

/// The entry of a description that a collider comes from.
SectionEntry solid_entry(const Description& description, std::size_t collider);

/// Adds what of the masses and bones touches solids or each other: after all of them.
void add_contact_points(Builder& builder);

/// Reports what starts inside a solid that moves, which would throw it out.
void find_starts_inside(const Builder& builder, const Description& description,
                        std::vector<Problem>& problems);

/// Reports bodies that are so close together at the start that their contacts can't be counted, let alone be
/// solved.
void find_crowds(const Builder& builder, const Description& description, std::vector<Problem>& problems);

/// Reports a rigid link that acts one way only and is further apart, or nearer, at the start than it lets its
/// masses be.
void find_overreach(const Builder& builder, std::vector<Problem>& problems);

/// Reports faces that start through each other or through solids, or nearer than their thickness; nothing
/// where there are other problems.
void find_face_problems(const Builder& builder, const Description& description,
                        std::vector<Problem>& problems);

/// Of a description whose masses can't be built, what can be known all the same: what they will be called,
/// and which names that links, loads and limits use are none of theirs. Nothing where the names themselves,
/// or how many there are of them, is what is wrong.
void build_names_alone(const Description& description, Built& built);

/// The mass that may have been meant, looked for only while the problems are few: in a file of bad names it
/// would take bad names × masses.
std::string nearest_mass(std::string_view name, const Masses& masses, const std::vector<Problem>& problems);

/// What each of them has.
Counts count(const SheetSpec& spec);
Counts count(const ChainSpec& spec);
Counts count(const MeshSpec& spec);
Counts count(const PointsSpec& spec);
Counts count(const RagdollSpec& spec);

/// Everything wrong with a description that shows without building it: numbers, names and counts.
std::vector<Problem> find_problems(const Description& description);

/// What a sound description allows though it is seldom meant: rigid links that don't start with their length,
/// that reach from pin to pin without slack, or that break by stretch.
std::vector<Problem> find_notes(const Description& description, const Builder& builder);

}  // namespace taut
