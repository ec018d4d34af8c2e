#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "mesh_texts.h"
#include "meshes/read_mesh.h"
#include "model/solid_mesh.h"

namespace taut::testing {

/// A surface that is to become a file.
struct Surfaces {
  std::vector<Vec3> vertices;
  std::vector<std::vector<std::size_t>> faces;  // corners counted from 0

  std::string obj() const {
    std::string text;
    for (const Vec3& v : vertices) text += fmt::format("v {} {} {}\n", v.x(), v.y(), v.z());
    for (const auto& face : faces) {
      text += "f";
      for (const std::size_t corner : face) text += fmt::format(" {}", corner + 1);
      text += "\n";
    }
    return text;
  }
  /// Puts another one beside it.
  void add(const Surfaces& other, const Vec3& shift, bool turned_over = false) {
    const std::size_t first = vertices.size();
    for (const Vec3& vertex : other.vertices) vertices.emplace_back(vertex + shift);
    for (std::vector<std::size_t> face : other.faces) {
      for (std::size_t& corner : face) corner += first;
      if (turned_over) std::reverse(face.begin(), face.end());
      faces.push_back(face);
    }
  }
};

/// A box around the origin, of quads that look outwards.
inline Surfaces box_surface(const Vec3& edges) {
  Surfaces box;
  for (int corner = 0; corner < 8; ++corner)
    box.vertices.emplace_back(0.5 * edges.x() * (corner & 1 ? 1 : -1),
                              0.5 * edges.y() * (corner & 2 ? 1 : -1),
                              0.5 * edges.z() * (corner & 4 ? 1 : -1));
  box.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return box;
}

/// A ball around the origin: an icosahedron whose triangles are cut into four, and that `level` times.
inline Surfaces ball_surface(double radius, int level) {
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  Surfaces ball;
  for (const double one : {-1.0, 1.0})
    for (const double far : {-golden, golden}) {
      ball.vertices.emplace_back(0.0, one, far);
      ball.vertices.emplace_back(one, far, 0.0);
      ball.vertices.emplace_back(far, 0.0, one);
    }
  const auto apart = [&](std::size_t a, std::size_t b) {
    return (ball.vertices[a] - ball.vertices[b]).norm();
  };
  for (std::size_t a = 0; a < 12; ++a)
    for (std::size_t b = a + 1; b < 12; ++b)
      for (std::size_t c = b + 1; c < 12; ++c) {
        if (apart(a, b) > 2.1 || apart(b, c) > 2.1 || apart(c, a) > 2.1) continue;
        const Vec3 &p = ball.vertices[a], &q = ball.vertices[b], &r = ball.vertices[c];
        const bool outward = (q - p).cross(r - p).dot(p) > 0.0;
        ball.faces.push_back(outward ? std::vector{a, b, c} : std::vector{a, c, b});
      }
  for (int cut = 0; cut < level; ++cut) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t a, std::size_t b) {
      const auto [known, is_new] = middles.try_emplace(std::minmax(a, b), ball.vertices.size());
      if (is_new) ball.vertices.emplace_back(0.5 * (ball.vertices[a] + ball.vertices[b]));
      return known->second;
    };
    std::vector<std::vector<std::size_t>> finer;
    for (const auto& face : ball.faces) {
      const std::size_t ab = middle(face[0], face[1]), bc = middle(face[1], face[2]),
                        ca = middle(face[2], face[0]);
      finer.push_back({face[0], ab, ca});
      finer.push_back({face[1], bc, ab});
      finer.push_back({face[2], ca, bc});
      finer.push_back({ab, bc, ca});
    }
    ball.faces = finer;
    for (Vec3& vertex : ball.vertices) vertex.normalize();
  }
  for (Vec3& vertex : ball.vertices) vertex = radius * vertex.normalized();
  return ball;
}

/// A ring about the y axis, of quads.
inline Surfaces ring_surface(double large, double small, std::size_t around, std::size_t across) {
  Surfaces ring;
  for (std::size_t i = 0; i < around; ++i)
    for (std::size_t j = 0; j < across; ++j) {
      const double u = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(around),
                   v = 2.0 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(across);
      const double out = large + small * std::cos(v);
      ring.vertices.emplace_back(out * std::cos(u), small * std::sin(v), out * std::sin(u));
      const std::size_t next = (i + 1) % around, above = (j + 1) % across;
      ring.faces.push_back({i * across + j, i * across + above, next * across + above, next * across + j});
    }
  return ring;
}

/// A solid of a scene out of a surface.
inline MeshSolidSpec solid_of(const Surfaces& surface, MeshSolidSpec spec = {}) {
  spec.file = "solid.obj";
  spec.data = SolidFiles().read(spec.file, surface.obj(), spec).data;
  return spec;
}

/// The same as a shape, where it stands.
inline MeshSolid shape_of(const Surfaces& surface, const MeshSolidSpec& spec = {}) {
  const MeshSolidSpec made = solid_of(surface, spec);
  return {made.data->mesh, made.data->middle, Eigen::Matrix3d::Identity()};
}

}  // namespace taut::testing
