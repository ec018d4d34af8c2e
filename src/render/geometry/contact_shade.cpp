#include "geometry/contact_shade.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/hiders.h"
#include "geometry/torso.h"

namespace taut {
namespace {

// What is smaller than so much of the reach neither hides anything nor shows that it is hidden.
constexpr float least_size = 0.15F;
// Rods of a radius of less than so much of it are thin.
constexpr float thin_rod = 0.25F;

/// A ball around a thing (m).
struct Surrounded {
  glm::vec3 centre;
  float radius;
};

Surrounded surrounded(const Hider& hider) {
  const float grown = std::abs(hider.taper) * hider.halves.x;
  return {hider.centre, glm::length(hider.halves) + hider.radius + grown};
}

Surrounded surrounded(const MeshRecord& mesh) {
  float square = 0.0F;
  for (const SolidVertex& vertex : mesh.surface->vertices)
    square = std::max(square, glm::dot(vertex.position, vertex.position));
  return {mesh.centre, std::sqrt(square)};
}

/// Finds what is near, and how much it hides.
class ContactShader {
 public:
  ContactShader(Bodies& bodies, const std::vector<GroundPatch>& grounds, float reach)
      : bodies_(bodies), reach_(reach) {
    for (const GroundPatch& ground : grounds)
      if (ground.solid) grounds_.push_back(hider_of(ground, reach));
    things_.reserve(bodies.rods.size() + bodies.torsos.size() + bodies.boxes.size());
    for (const TaperedRod& rod : bodies.rods) add_thing(hider_of(rod));
    for (const TorsoRecord& torso : bodies.torsos) add_thing(hider_of(torso));
    for (const BoxRecord& box : bodies.boxes) add_thing(hider_of(box));
    for (std::size_t i = 0; i < things_.size(); ++i)
      if (balls_[i].radius > least_size * reach) order_.push_back(i);
    std::ranges::sort(order_, {}, [this](std::size_t i) { return balls_[i].centre.x; });
  }

  void shade() {
    std::size_t thing = 0;
    bodies_.shades.add({1, 1})[0] = 255;  // of what has nothing near it
    for (TaperedRod& rod : bodies_.rods) shade(rod, thing++);
    for (TorsoRecord& torso : bodies_.torsos) shade(torso, thing++);
    for (BoxRecord& box : bodies_.boxes) shade(box, thing++);
    for (MeshRecord& mesh : bodies_.meshes) shade(mesh);
  }

 private:
  void add_thing(const Hider& hider) {
    things_.push_back(hider);
    balls_.push_back(surrounded(hider));
    largest_ = std::max(largest_, balls_.back().radius);
  }

  /// Sets near_ to what may hide anything from what is in a ball; whether there is anything.
  bool find_near(const Surrounded& ball, std::size_t itself) {
    near_.clear();
    if (ball.radius <= least_size * reach_) return false;
    for (const Hider& ground : grounds_)
      if (distance_to(ground, ball.centre) < ball.radius + reach_) near_.push_back(&ground);
    const float widest = ball.radius + reach_ + largest_;
    const auto centre = [this](std::size_t i) { return balls_[i].centre.x; };
    for (auto next = std::ranges::lower_bound(order_, ball.centre.x - widest, {}, centre);
         next != order_.end() && centre(*next) < ball.centre.x + widest; ++next) {
      const Surrounded& other = balls_[*next];
      const float most = ball.radius + reach_ + other.radius;
      const glm::vec3 way = other.centre - ball.centre;
      if (*next != itself && glm::dot(way, way) < most * most &&
          distance_to(things_[*next], ball.centre) < ball.radius + reach_)
        near_.push_back(&things_[*next]);
    }
    return !near_.empty();
  }

  /// Works out how open each of points_ is, 0 to 255.
  const std::vector<std::uint8_t>& worked_out() {
    for (const Hider* hider : near_) points_.hide_by(*hider, reach_);
    open_.clear();
    for (std::size_t i = 0; i < points_.size(); ++i)
      open_.push_back(static_cast<std::uint8_t>(std::lround(255.0F * points_.openness(i))));
    return open_;
  }

  void shade(TaperedRod& rod, std::size_t thing) {
    if (!find_near(balls_[thing], thing)) return;
    // Of which two rows each is the mean: a ball has no length, and a thin rod's ends need no rows of their
    // own half way to their tips, and half as many columns.
    std::array<std::array<std::size_t, 2>, rod_tile.y> from{
        {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}, {6, 6}}};
    if (rod.start == rod.end) from[3] = from[4] = from[2];
    const bool thin = std::max(rod.start_radius, rod.end_radius) < thin_rod * reach_;
    if (thin) {
      from[1] = {0, 2};
      from[5] = {from[4][0], 6};
    }
    constexpr std::size_t columns = rod_tile.x - 1, last_row = rod_tile.y - 1;
    const std::size_t step = thin ? 2 : 1;
    std::array<std::size_t, rod_tile.y> first{};
    points_.clear();
    for (std::size_t row = 0; row <= last_row; ++row) {
      if (from[row][0] != row) continue;
      first[row] = points_.size();
      const bool tip = row == 0 || row == last_row;
      for (std::size_t column = 0; column < (tip ? 1 : columns); column += step)
        add_rod_point(rod, row, column);
    }
    const std::vector<std::uint8_t>& open = worked_out();
    const auto point = [&](std::size_t row, std::size_t column) {
      const bool tip = row == 0 || row == last_row;
      return int{open[first[row] + (tip ? 0 : column % columns / step)]};
    };
    const ShadeTiles::Tile made = bodies_.shades.add(rod_tile);
    for (std::size_t row = 0; row <= last_row; ++row)
      for (std::size_t column = 0; column <= columns; ++column) {
        int sum = 2;  // so that a fourth of it is rounded
        for (const std::size_t near_row : from[row])
          sum += point(near_row, column) + point(near_row, column + column % step);
        made[row * ShadeTiles::width + column] = static_cast<std::uint8_t>(sum / 4);
      }
    rod.shade = made.corner;
  }

  void shade(TorsoRecord& torso, std::size_t thing) {
    if (!find_near(balls_[thing], thing)) return;
    static const std::vector<TorsoVertex> skin = torso_vertices(torso_tile.x - 1, torso_tile.y - 1);
    points_.clear();
    const auto& axes = torso.axes;
    for (const TorsoVertex& vertex : skin)
      points_.add(
          torso.origin + axes[0] * vertex.place.x + axes[1] * vertex.place.y + axes[2] * vertex.place.z,
          glm::normalize(glm::cross(axes[1], axes[2]) * vertex.outward.x +
                         glm::cross(axes[2], axes[0]) * vertex.outward.y +
                         glm::cross(axes[0], axes[1]) * vertex.outward.z));
    const std::vector<std::uint8_t>& open = worked_out();
    const ShadeTiles::Tile made = bodies_.shades.add(torso_tile);
    const std::size_t columns = torso_tile.x - 1;
    for (std::size_t row = 0; row < static_cast<std::size_t>(torso_tile.y); ++row)
      for (std::size_t column = 0; column <= columns; ++column)
        made[row * ShadeTiles::width + column] = open[row * columns + column % columns];
    torso.shade = made.corner;
  }

  // As shaders/rod.vert places its vertices.
  void add_rod_point(const TaperedRod& rod, std::size_t row, std::size_t column) {
    const glm::vec3& squeeze = rod.squeeze;
    const auto unsqueezed = [&](const glm::vec3& v) {
      return v + squeeze * (glm::dot(squeeze, v) / (1.0F - glm::dot(squeeze, squeeze)));
    };
    const glm::vec3 span = unsqueezed(rod.end - rod.start);
    const float length = glm::length(span);
    const glm::vec3 axis = length > 0.0F ? span / length : glm::vec3(0, 1, 0);
    const glm::vec3 right =
        glm::normalize(glm::cross(axis, std::abs(axis.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0)));
    const float seam =
        std::asin(std::clamp((rod.start_radius - rod.end_radius) / std::max(length, 1e-12F), -1.0F, 1.0F));
    // Tip, half way, the start's seam, the middle, the end's seam, half way, tip.
    constexpr std::array<float, 7> tilts{-1.0F, -0.5F, 0.0F, 0.0F, 0.0F, 0.5F, 1.0F};
    constexpr std::array<float, 7> ends{0.0F, 0.0F, 0.0F, 0.5F, 1.0F, 1.0F, 1.0F};
    const float tilt = tilts.at(row), end = ends.at(row);
    constexpr float half_turn = std::numbers::pi_v<float>;
    const float latitude = seam + std::abs(tilt) * (std::copysign(0.5F * half_turn, tilt) - seam);
    const float angle = 2.0F * half_turn * static_cast<float>(column) / static_cast<float>(rod_tile.x - 1);
    const glm::vec3 normal =
        std::cos(latitude) * (right * std::cos(angle) + glm::cross(axis, right) * std::sin(angle)) +
        std::sin(latitude) * axis;
    const glm::vec3 from_centre = glm::mix(rod.start_radius, rod.end_radius, end) * normal;
    points_.add(glm::mix(rod.start, rod.end, end) + from_centre - squeeze * glm::dot(squeeze, from_centre),
                glm::normalize(unsqueezed(normal)));
  }

  // Three faces beside each other, and the opposite ones below them, as shaders/box.vert counts.
  void shade(BoxRecord& box, std::size_t thing) {
    if (!find_near(balls_[thing], thing)) return;
    const float longest =
        2.0F * std::max({glm::length(box.edges[0]), glm::length(box.edges[1]), glm::length(box.edges[2])});
    // So fine that what touches it shows where, and no finer.
    const int cells = std::clamp(static_cast<int>(std::ceil(6.0F * longest / reach_)), 2, 24);
    points_.clear();
    for (int face = 0; face < 6; ++face) {
      const float side = face % 2 == 0 ? 1.0F : -1.0F;
      const glm::vec3 out = side * box.edges[face / 2], along = side * box.edges[(face / 2 + 1) % 3],
                      across = box.edges[(face / 2 + 2) % 3];
      for (int y = 0; y <= cells; ++y)
        for (int x = 0; x <= cells; ++x) {
          const glm::vec2 at = 2.0F * glm::vec2(x, y) / static_cast<float>(cells) - 1.0F;
          points_.add(box.centre + out + at.x * along + at.y * across, glm::normalize(out));
        }
    }
    const std::size_t row = static_cast<std::size_t>(cells) + 1;
    const ShadeTiles::Tile made = bodies_.shades.add({3 * row, 2 * row});
    const std::vector<std::uint8_t>& open = worked_out();
    for (std::size_t i = 0; i < open.size(); ++i) {
      const std::size_t face = i / (row * row), y = i / row % row, x = i % row;
      made[(face % 2 * row + y) * ShadeTiles::width + face / 2 * row + x] = open[i];
    }
    box.shade = glm::vec3(made.corner, cells);
  }

  // A texel a vertex, one after the other.
  void shade(MeshRecord& mesh) {
    if (!find_near(surrounded(mesh), things_.size())) return;
    points_.clear();
    for (const SolidVertex& vertex : mesh.surface->vertices)
      points_.add(
          mesh.centre + mesh.axes[0] * vertex.position.x + mesh.axes[1] * vertex.position.y +
              mesh.axes[2] * vertex.position.z,
          mesh.axes[0] * vertex.normal.x + mesh.axes[1] * vertex.normal.y + mesh.axes[2] * vertex.normal.z);
    const std::size_t rows = (points_.size() + ShadeTiles::width - 1) / ShadeTiles::width;
    const ShadeTiles::Tile made = bodies_.shades.add({ShadeTiles::width, rows});
    std::ranges::copy(worked_out(), made.first);
    mesh.shade = static_cast<int>(made.corner.y);
  }

  Bodies& bodies_;
  float reach_, largest_ = 0.0F;
  std::vector<Hider> things_, grounds_;
  std::vector<Surrounded> balls_;   // around things
  std::vector<std::size_t> order_;  // of those that are large enough, by their centres' x
  std::vector<const Hider*> near_;
  ShadedPoints points_;
  std::vector<std::uint8_t> open_;
};

}  // namespace

ShadeTiles::Tile ShadeTiles::add(const glm::uvec2& size) {
  if (next_.x + size.x > width) next_ = {0, next_.y + height_};
  if (next_.x == 0) height_ = 0;
  const glm::uvec2 corner = next_;
  height_ = std::max(height_, size.y);
  next_.x += size.x;
  texels.resize(std::size_t{width} * (next_.y + height_), 255);
  return {glm::vec2(corner), texels.data() + std::size_t{corner.y} * width + corner.x};
}

void add_contact_shades(Bodies& bodies, const std::vector<GroundPatch>& grounds, float reach) {
  ContactShader(bodies, grounds, reach).shade();
}

}  // namespace taut
