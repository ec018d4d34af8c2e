#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "contact/face_search.h"
#include "contact/face_sweep.h"
#include "model/model.h"
#include "model/state.h"

namespace taut {

/// Contact of a model's faces with one another, with masses that are balls, and with the edges, corners and
/// balls of solids, for methods
/// that move positions and derive velocities from them. It remembers nothing from step to step. See
/// face_contacts.cpp.
class FaceContacts {
 public:
  /// `workers` share what looks at pairs without moving anything; null: this thread alone.
  FaceContacts(const Model& model, const std::shared_ptr<Workers>& workers);

  /// Whether the model has no faces.
  bool none() const { return none_; }

  /// To be called before the first step and whenever other links are whole than before.
  void links_changed(const State& state);

  /// To be called once positions of the step have been predicted, with those at its start.
  void begin_step(const Vectors& start, const Vectors& predicted, double start_time, double end_time);

  /// One pass: keeps faces that are near as far apart as they are thick, and takes from their sliding on one
  /// another what friction allows.
  void solve(Vectors& position);

  /// To be called after the last pass: sees to it that nothing has passed through anything on the straight
  /// way from the start of the step. False: that can't be had, for pins press faces through each other.
  bool finish(Vectors& position);

  /// Whether any have touched in this step.
  bool touched() const { return touched_; }

  /// What solids that move, and pins that are moved, have done to faces in this step of h seconds (J).
  double work(double h) const { return impulse_way_ / (h * h); }

 private:
  // What keeps a pair apart: Σ weightₖ xₖ·normal ≥ gap.
  struct Contact {
    FacePair pair;
    std::array<double, 4> weights{};
    Vec3 normal = Vec3::UnitY();
    Vec3 at_start = Vec3::Zero();  // Σ weightₖ xₖ at the start of the step (m)
    double gap = 0.0;              // m
    double friction = 0.0;
  };
  // A half-space, at both ends of the step.
  struct Ground {
    const Collider* collider = nullptr;
    HalfSpace start, end;
    Placement from{}, to{};  // where it moves
  };
  class Clusters;
  static constexpr std::size_t most_sections = 16;

  void find_pairs(bool from_new_start);
  Contact contact_at(const FacePair& pair, const FaceGap& gap) const;
  std::size_t sections() const;
  std::size_t section_begin(std::size_t section) const;
  void prepare(std::size_t pair, std::vector<Contact>& contacts);
  std::size_t first_that_meets();
  double distance_at_start(std::size_t pair);
  double stop(std::size_t pair);
  bool push(const Contact& contact, std::vector<Vec3>& places);
  void put(Vectors& position) const;
  FaceMeeting meeting(std::size_t pair);
  bool push_apart_what_meets();
  bool lift_from_ground();
  bool hold_together();
  bool under(const Ground& ground, std::uint32_t node) const;

  const Model& model_;
  bool none_;
  FaceSearch search_;
  std::vector<Ground> grounds_;
  std::vector<Vec3> start_, end_;          // m, of the nodes
  std::vector<double> distance_at_start_;  // m, of each pair of the search, where it was asked for
  // Pairs in sections, which threads look at each by itself; the contacts of each.
  std::shared_ptr<Workers> workers_;
  std::array<std::vector<Contact>, most_sections> contacts_;
  double end_time_ = 0.0;     // s
  double impulse_way_ = 0.0;  // kg m²: Σ impulse × h · way of what is moved as prescribed
  bool finite_ = true, touched_ = false;
};

}  // namespace taut
