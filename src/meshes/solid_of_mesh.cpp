#include "solid_of_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "base/failure.h"
#include "model/mesh_triangles.h"
#include "model/solid_mesh.h"
#include "model/tangles.h"

namespace taut {
namespace {

constexpr double no_volume = 1e-9;  // of the cube of a piece's size

class SolidMaker {
 public:
  SolidMaker(const RawMesh& raw, const PlacedMesh& placed, const std::string& file,
             std::vector<std::string>& notes)
      : raw_(raw), placed_(placed), file_(file), notes_(notes) {}

  SolidData make() {
    cut();
    find_pieces();
    require_volume();
    require_plain_corners();
    const SolidMesh as_it_is(vertices_, triangles_);
    require_no_crossing(as_it_is);
    face_outwards(as_it_is);
    return {std::make_shared<const SolidMesh>(vertices_, triangles_), middle_};
  }

 private:
  [[noreturn]] void fail_at(Index triangle, std::string_view message) const {
    throw BadRequest(fmt::format("{}: {}", place_in(file_, raw_.face_line, face_of(triangle)), message));
  }
  // Of the file.
  Index face_of(Index triangle) const { return placed_.from[face_[triangle]]; }
  std::string name_of(Index triangle) const {
    const Index face = face_of(triangle);
    return raw_.face_line.empty() ? fmt::format("face {}, counted from 0", face)
                                  : fmt::format("that of line {}", raw_.face_line[face]);
  }

  void cut() {
    Bounds around;
    for (const Vec3& vertex : placed_.data.vertices) around.take_in(vertex, 0.0);
    middle_ = 0.5 * (around.low + around.high);
    vertices_.reserve(placed_.data.vertices.size());
    for (const Vec3& vertex : placed_.data.vertices) vertices_.push_back(vertex - middle_);
    for (Index face = 0; face < placed_.data.face_count(); ++face)
      for (const auto& corners : triangles_of(placed_.data, face)) {
        triangles_.push_back(corners);
        face_.push_back(face);
      }
  }

  Index leader(Index vertex) {
    while (leader_[vertex] != vertex) vertex = leader_[vertex] = leader_[leader_[vertex]];
    return vertex;
  }

  // What hangs together by corners, numbered as triangles come to it.
  void find_pieces() {
    leader_.resize(vertices_.size());
    std::iota(leader_.begin(), leader_.end(), Index{0});
    for (const auto& [a, b, c] : triangles_)
      for (const Index other : {b, c}) {
        const Index one = leader(a), two = leader(other);
        leader_[std::max(one, two)] = std::min(one, two);
      }
    std::vector<Index> number(vertices_.size(), unknown);
    for (const auto& corners : triangles_) {
      Index& piece = number[leader(corners[0])];
      if (piece == unknown) piece = pieces_++;
      piece_.push_back(piece);
    }
  }

  // The pieces' own, with the sign of the way that their faces run around.
  void require_volume() {
    volume_.assign(pieces_, 0.0);
    std::vector<Bounds> around(pieces_);
    for (Index i = 0; i < triangles_.size(); ++i)
      for (const Index corner : triangles_[i]) around[piece_[i]].take_in(vertices_[corner], 0.0);
    for (Index i = 0; i < triangles_.size(); ++i) {
      const auto& [a, b, c] = triangles_[i];
      const Vec3 middle = 0.5 * (around[piece_[i]].low + around[piece_[i]].high);
      volume_[piece_[i]] +=
          (vertices_[a] - middle).dot((vertices_[b] - middle).cross(vertices_[c] - middle)) / 6.0;
    }
    for (Index i = 0; i < triangles_.size(); ++i) {
      const double size = (around[piece_[i]].high - around[piece_[i]].low).norm();
      if (std::abs(volume_[piece_[i]]) <= no_volume * size * size * size)
        fail_at(i, "there is no volume in this surface: its faces lie on one another");
    }
  }

  // The triangles around a corner hang together by edges: one round, not several that touch at a tip.
  void require_plain_corners() const {
    std::vector<Index> around(vertices_.size(), 0), first(vertices_.size(), unknown);
    for (Index i = 0; i < triangles_.size(); ++i)
      for (const Index corner : triangles_[i]) {
        ++around[corner];
        if (first[corner] == unknown) first[corner] = i;
      }
    std::vector<std::array<Index, 3>> sides;  // from one corner to the next, and the triangle
    sides.reserve(3 * triangles_.size());
    for (Index i = 0; i < triangles_.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k) sides.push_back({triangles_[i][k], triangles_[i][(k + 1) % 3], i});
    std::ranges::sort(sides);
    for (Index vertex = 0; vertex < vertices_.size(); ++vertex) {
      Index triangle = first[vertex], seen = 0;
      do {
        ++seen;
        const auto& corners = triangles_[triangle];
        const auto at = static_cast<std::size_t>(std::ranges::find(corners, vertex) - corners.begin());
        const Index before = corners[(at + 2) % 3];  // the next triangle runs from here to there
        triangle = std::ranges::lower_bound(sides, std::array<Index, 3>{vertex, before, 0})->at(2);
      } while (triangle != first[vertex] && seen <= around[vertex]);
      if (seen != around[vertex])
        fail_at(first[vertex],
                "two parts of the surface touch at a corner of this face alone, with no edge between them");
    }
  }

  void require_no_crossing(const SolidMesh& mesh) const {
    const auto& triangles = mesh.triangles();
    for (const SolidMesh::Edge& edge : mesh.edges()) {
      const std::array ends{mesh.vertices()[edge.ends[0]], mesh.vertices()[edge.ends[1]]};
      Bounds along;
      for (const Vec3& end : ends) along.take_in(end, 0.0);
      std::optional<Index> through;
      mesh.visit_near(along, [&](Index i) {
        const bool joined = std::ranges::find_first_of(triangles[i], edge.ends) != triangles[i].end();
        if (!through && !joined && piercing(ends, mesh.corners_of(i)) == Piercing::through) through = i;
      });
      if (!through) continue;
      fail_at(mesh.made_from()[edge.triangles[0]],
              fmt::format("the surface goes through itself, and so what is inside is in doubt: this face and "
                          "{} cross",
                          name_of(mesh.made_from()[*through])));
    }
  }

  // Whether a piece is within an odd number of others: then it is a hollow's wall.
  bool is_hollow(const SolidMesh& mesh, Index piece, Index triangle) const {
    const auto& [a, b, c] = triangles_[triangle];
    const Vec3 from = (vertices_[a] + vertices_[b] + vertices_[c]) / 3.0;
    const Vec3 size = mesh.bounds().high - mesh.bounds().low;
    const Vec3 to = from + size.norm() * Vec3(0.5772156649, 0.6931471806, 0.4142135624);
    const int others =
        mesh.crossings(from, to, [&](Index i) { return piece_[mesh.made_from()[i]] != piece; });
    return others % 2 == 1;
  }

  void face_outwards(const SolidMesh& mesh) {
    std::vector<bool> known(pieces_, false), turn(pieces_, false);
    std::size_t turned_over = 0;
    for (Index i = 0; i < triangles_.size(); ++i) {
      const Index piece = piece_[i];
      if (!known[piece]) {
        known[piece] = true;
        const bool inwards = pieces_ > 1 && is_hollow(mesh, piece, i);
        turn[piece] = (volume_[piece] < 0.0) != inwards;
        turned_over += turn[piece] ? 1U : 0U;
      }
      if (turn[piece]) std::swap(triangles_[i][1], triangles_[i][2]);
    }
    if (turned_over == 0) return;
    notes_.push_back(pieces_ == 1
                         ? fmt::format("{}: its faces looked inwards, and were turned over", file_)
                         : fmt::format("{}: faces of {} of its {} pieces looked the wrong way, and were "
                                       "turned over",
                                       file_, turned_over, pieces_));
  }

  static constexpr Index unknown = 0xffffffffU;

  const RawMesh& raw_;
  const PlacedMesh& placed_;
  const std::string& file_;
  std::vector<std::string>& notes_;
  Vec3 middle_ = Vec3::Zero();
  std::vector<Vec3> vertices_;
  std::vector<SolidMesh::Corners> triangles_;
  std::vector<Index> face_, piece_;  // of each triangle; faces of the placed mesh
  std::vector<Index> leader_;        // of vertices
  Index pieces_ = 0;
  std::vector<double> volume_;  // m³, of each piece
};

}  // namespace

SolidData solid_of_mesh(const RawMesh& raw, const PlacedMesh& placed, const std::string& file,
                        std::vector<std::string>& notes) {
  return SolidMaker(raw, placed, file, notes).make();
}

}  // namespace taut
