#include "placed_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <queue>
#include <span>
#include <unordered_map>
#include <utility>

#include "base/failure.h"
#include "model/turned.h"
#include "welding.h"

namespace taut {
namespace {

constexpr double farthest = 1e6;     // m, as of anything in a scene
constexpr double no_height = 1e-9;   // of a face's longest side: it lies on a line then
constexpr double weld_share = 1e-6;  // of the mesh's size

std::string plural(std::size_t count, std::string_view one, std::string_view many) {
  return count == 1 ? fmt::format("a {}", one) : fmt::format("{} {}", count, many);
}

double size_of(const std::vector<Vec3>& places) {
  Vec3 low = places.front(), high = low;
  for (const Vec3& place : places) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  return (high - low).norm();
}

class MeshPlacer {
 public:
  MeshPlacer(const RawMesh& raw, const MeshSpec& spec, MeshUse use, std::vector<std::string>& notes)
      : raw_(raw), spec_(spec), use_(use), notes_(notes) {}

  PlacedMesh make() {
    if (raw_.face_count() == 0)
      throw BadRequest(fmt::format("{}: there are no faces in it, and {} is made of those", spec_.file,
                                   is_cloth() ? "cloth" : "a solid"));
    place();
    stands_for_ = welded(places_, weld_distance());
    for (Index face = 0; face < raw_.face_count(); ++face) take_face(face);
    if (made_.face_count() == 0)
      throw BadRequest(
          fmt::format("{}: no face is left, since all of its corners are within {:.3g} m of each other: is "
                      "\"scale\" right, or \"weld\" too large?",
                      spec_.file, weld_distance()));
    if (!is_cloth()) require_closed();
    turn_alike();
    number_vertices();
    tell();
    return {std::move(made_), std::move(from_)};
  }

 private:
  bool is_cloth() const { return use_ == MeshUse::cloth; }

  [[noreturn]] void fail_at_face(Index face, std::string_view message) const {
    throw BadRequest(fmt::format("{}: {}", place_in(spec_.file, raw_.face_line, face), message));
  }
  // Files without lines name their faces by number.
  std::string the_face(Index face) const {
    return raw_.face_line.empty() ? fmt::format("face {}, counted from 0,", face) : "the face";
  }

  void place() {
    const Eigen::Matrix3d turn = turned(spec_.turn);
    places_.reserve(raw_.vertices.size());
    for (std::size_t i = 0; i < raw_.vertices.size(); ++i) {
      const Vec3& at = raw_.vertices[i];
      if (!at.allFinite())
        throw BadRequest(
            fmt::format("{}: vertex {}, counted from 0, is at no place: its coordinates are no numbers",
                        place_in(spec_.file, raw_.vertex_line, i), i));
      const Vec3 upright = spec_.up == UpAxis::z ? Vec3(at.x(), at.z(), -at.y()) : at;
      places_.push_back(spec_.position + turn * (spec_.scale * upright));
      if (!(places_.back().cwiseAbs().maxCoeff() <= farthest))
        throw BadRequest(fmt::format("{}: a vertex is more than {:.0f} km from the scene's origin",
                                     place_in(spec_.file, raw_.vertex_line, i), farthest / 1e3));
    }
  }

  double weld_distance() const { return spec_.weld.value_or(weld_share * size_of(places_)); }

  // A face's corners as they stand for others, no two in a row the same.
  std::vector<Index> corners_of(Index face) const {
    std::vector<Index> corners;
    for (Index k = raw_.face_begin[face]; k < raw_.face_begin[face + 1]; ++k) {
      const Index corner = stands_for_[raw_.corners[k]];
      if (corners.empty() || corners.back() != corner) corners.push_back(corner);
    }
    while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    return corners;
  }

  void take_face(Index face) {
    const std::vector<Index> corners = corners_of(face);
    if (corners.size() < 3) {
      ++collapsed_;
      return;
    }
    std::vector<Index> sorted = corners;
    std::ranges::sort(sorted);
    if (std::ranges::adjacent_find(sorted) != sorted.end())
      fail_at_face(face, fmt::format("{} comes to one of its corners twice", the_face(face)));
    check_area(face, corners);
    if (corners.size() <= 4) return add_face(face, corners);
    ++cut_;
    const std::size_t hub = hub_of(face, corners);
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
      add_face(face, std::array{corners[hub], corners[(hub + k) % corners.size()],
                                corners[(hub + k + 1) % corners.size()]});
  }

  // Twice the area, as long as that, across the face (Newell's sum over its sides).
  Vec3 area_of(std::span<const Index> corners) const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
      sum += (places_[corners[k]] - places_[corners[0]]).cross(places_[corners[k + 1]] - places_[corners[0]]);
    return sum;
  }

  void check_area(Index face, const std::vector<Index>& corners) const {
    double longest = 0.0;
    for (std::size_t k = 0; k < corners.size(); ++k)
      longest = std::max(longest, (places_[corners[k]] - places_[corners[(k + 1) % corners.size()]]).norm());
    if (!(area_of(corners).norm() > no_height * longest * longest))
      fail_at_face(face, fmt::format("{} has no area: its corners lie on a line", the_face(face)));
  }

  // The corner from which a polygon is cut into triangles that all face as it does.
  std::size_t hub_of(Index face, const std::vector<Index>& corners) const {
    const Vec3 whole = area_of(corners);
    for (std::size_t hub = 0; hub < corners.size(); ++hub) {
      bool sound = true;
      for (std::size_t k = 1; sound && k + 1 < corners.size(); ++k) {
        const std::array triangle{corners[hub], corners[(hub + k) % corners.size()],
                                  corners[(hub + k + 1) % corners.size()]};
        sound = area_of(triangle).dot(whole) > 1e-9 * whole.squaredNorm();
      }
      if (sound) return hub;
    }
    fail_at_face(face, fmt::format("{} has {} corners and can't be cut into triangles from any of them: "
                                   "triangulate it before it is exported",
                                   the_face(face), corners.size()));
  }

  static std::uint64_t edge_key(Index a, Index b) {
    return std::uint64_t{std::min(a, b)} << 32U | std::max(a, b);
  }

  void add_face(Index from, std::span<const Index> corners) {
    const auto face = static_cast<Index>(made_.face_count());
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Index a = corners[k], b = corners[(k + 1) % corners.size()];
      const auto [known, is_new] = faces_of_edge_.try_emplace(edge_key(a, b), std::array{face, face});
      if (is_new) continue;
      if (known->second[0] != known->second[1]) report_crowded(from, a, b, known->second);
      known->second[1] = face;
    }
    made_.corners.insert(made_.corners.end(), corners.begin(), corners.end());
    made_.face_begin.push_back(static_cast<Index>(made_.corners.size()));
    from_.push_back(from);
  }

  [[noreturn]] void report_crowded(Index face, Index a, Index b, const std::array<Index, 2>& others) const {
    const std::string where =
        raw_.face_line.empty()
            ? fmt::format("faces {}, {} and {}, counted from 0", from_[others[0]], from_[others[1]], face)
            : fmt::format("those of lines {}, {} and {}", raw_.face_line[from_[others[0]]],
                          raw_.face_line[from_[others[1]]], raw_.face_line[face]);
    fail_at_face(face, fmt::format("three faces meet at one edge, and {}: {}, {} in the file",
                                   is_cloth() ? "cloth has two at most" : "a solid's surface has two at each",
                                   where, the_edge(a, b)));
  }

  std::string the_edge(Index a, Index b) const {
    const Vec3 &from = raw_.vertices[a], &to = raw_.vertices[b];
    return fmt::format("from ({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g})", from.x(), from.y(),
                       from.z(), to.x(), to.y(), to.z());
  }

  // Every edge has a face on either side; says of the first one that hasn't.
  void require_closed() const {
    std::size_t open = 0;
    for (const auto& [key, faces] : faces_of_edge_) open += faces[0] == faces[1] ? 1U : 0U;
    if (open == 0) return;
    for (Index face = 0; face < made_.face_count(); ++face) {
      const auto corners = made_.face(face);
      for (std::size_t k = 0; k < corners.size(); ++k) {
        const Index a = corners[k], b = corners[(k + 1) % corners.size()];
        const auto& [one, other] = faces_of_edge_.at(edge_key(a, b));
        if (one != other) continue;
        fail_at_face(from_[face],
                     fmt::format("the surface is open, and a solid's is closed: {} has no neighbour at its "
                                 "edge {} in the file{}; \"weld\" joins corners that are near",
                                 the_face(from_[face]), the_edge(a, b),
                                 open > 1 ? fmt::format(", and there are {} such edges", open) : ""));
      }
    }
  }

  bool runs_along(Index face, Index a, Index b) const {
    const auto corners = made_.face(face);
    for (std::size_t k = 0; k < corners.size(); ++k)
      if (corners[k] == a && corners[(k + 1) % corners.size()] == b) return true;
    return false;
  }

  [[noreturn]] void report_one_sided(Index face, Index a, Index b) const {
    fail_at_face(
        from_[face],
        fmt::format("the surface has one side only, as a Möbius strip has, and so no inside: seen at "
                    "the edge {} in the file",
                    the_edge(a, b)));
  }

  // From the first face of each piece on, neighbours are turned to run along their edge the other way.
  void turn_alike() {
    std::vector<bool> seen(made_.face_count(), false);
    made_.pieces = 0;
    std::size_t turned_faces = 0;
    std::queue<Index> next;
    for (Index first = 0; first < made_.face_count(); ++first) {
      if (seen[first]) continue;
      ++made_.pieces;
      seen[first] = true;
      next.push(first);
      while (!next.empty()) {
        const Index face = next.front();
        next.pop();
        const std::vector<Index> corners(made_.face(face).begin(), made_.face(face).end());
        for (std::size_t k = 0; k < corners.size(); ++k) {
          const Index a = corners[k], b = corners[(k + 1) % corners.size()];
          const auto [one, other] = faces_of_edge_.at(edge_key(a, b));
          const Index beside = one == face ? other : one;
          if (seen[beside]) {
            if (!is_cloth() && runs_along(beside, a, b)) report_one_sided(face, a, b);
            continue;
          }
          seen[beside] = true;
          next.push(beside);
          if (!runs_along(beside, a, b)) continue;
          ++turned_faces;
          std::reverse(made_.corners.begin() + made_.face_begin[beside] + 1,
                       made_.corners.begin() + made_.face_begin[beside + 1]);
        }
      }
    }
    if (turned_faces > 0)
      notes_.push_back(fmt::format("{}: {} ran around the other way than {} and {} turned over", spec_.file,
                                   plural(turned_faces, "face", "faces"),
                                   turned_faces == 1 ? "its neighbours" : "their neighbours",
                                   turned_faces == 1 ? "was" : "were"));
  }

  // Masses are numbered as their vertices come in the file, without gaps.
  void number_vertices() {
    std::vector<Index> number(raw_.vertices.size(), no_number);
    for (const Index corner : made_.corners) number[corner] = 0;
    for (Index vertex = 0; vertex < number.size(); ++vertex) {
      if (number[vertex] == no_number) continue;
      number[vertex] = static_cast<Index>(made_.vertices.size());
      made_.vertices.push_back(places_[vertex]);
    }
    for (Index& corner : made_.corners) corner = number[corner];
    gather_groups();
    for (Index vertex = 0; vertex < number.size(); ++vertex)
      if (number[stands_for_[vertex]] == no_number) ++unused_;
  }

  void gather_groups() {
    made_.groups = raw_.groups;
    made_.group_vertices.resize(raw_.groups.size());
    std::unordered_map<Index, std::vector<Index>> groups_of;  // of faces in the file
    for (const auto& [face, group] : raw_.face_groups) groups_of[face].push_back(group);
    for (Index face = 0; face < made_.face_count(); ++face) {
      const auto of = groups_of.find(from_[face]);
      if (of == groups_of.end()) continue;
      for (const Index group : of->second)
        for (const Index corner : made_.face(face)) made_.group_vertices[group].push_back(corner);
    }
    for (std::vector<Index>& vertices : made_.group_vertices) {
      std::ranges::sort(vertices);
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }
  }

  void tell() {
    const auto note = [&](std::string text) { notes_.push_back(fmt::format("{}: {}", spec_.file, text)); };
    if (made_.pieces > 1 && is_cloth())
      note(
          fmt::format("it is in {} pieces, which nothing holds together: were they to be one, \"weld\" joins "
                      "corners that are near",
                      made_.pieces));
    if (unused_ > 0)
      note(fmt::format("{} of no face {} left out", plural(unused_, "vertex", "vertices"),
                       unused_ == 1 ? "was" : "were"));
    if (collapsed_ > 0)
      note(fmt::format("{} smaller than \"weld\" {} left out", plural(collapsed_, "face", "faces"),
                       collapsed_ == 1 ? "was" : "were"));
    if (cut_ > 0)
      note(fmt::format("{} of more than four corners {} cut into triangles", plural(cut_, "face", "faces"),
                       cut_ == 1 ? "was" : "were"));
  }

  static constexpr Index no_number = 0xffffffffU;

  const RawMesh& raw_;
  const MeshSpec& spec_;
  MeshUse use_;
  std::vector<std::string>& notes_;
  std::vector<Vec3> places_;       // m, of the file's vertices
  std::vector<Index> stands_for_;  // of each vertex, the first one that is welded with it
  std::vector<Index> from_;        // of each face that is made, the one in the file
  std::unordered_map<std::uint64_t, std::array<Index, 2>> faces_of_edge_;  // the same twice at a border
  std::size_t collapsed_ = 0, cut_ = 0, unused_ = 0;
  MeshData made_;
};

}  // namespace

PlacedMesh placed_mesh(const RawMesh& raw, const MeshSpec& spec, MeshUse use,
                       std::vector<std::string>& notes) {
  return MeshPlacer(raw, spec, use, notes).make();
}

}  // namespace taut
