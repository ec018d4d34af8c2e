#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace taut {

using Vec3 = Eigen::Vector3d;

/// Index of a mass or of a link in the arrays of a Model.
using Index = std::uint32_t;

/// Many three-vectors as a structure of arrays, one array a coordinate.
struct Vectors {
  std::vector<double> x, y, z;

  std::size_t size() const { return x.size(); }
  void resize(std::size_t count) {
    x.resize(count);
    y.resize(count);
    z.resize(count);
  }
  Vec3 at(std::size_t i) const { return {x[i], y[i], z[i]}; }
  void set(std::size_t i, const Vec3& v) {
    x[i] = v.x();
    y[i] = v.y();
    z[i] = v.z();
  }
  void add(std::size_t i, const Vec3& v) {
    x[i] += v.x();
    y[i] += v.y();
    z[i] += v.z();
  }
  void push_back(const Vec3& v) {
    x.push_back(v.x());
    y.push_back(v.y());
    z.push_back(v.z());
  }
  bool operator==(const Vectors&) const = default;
};

}  // namespace taut
