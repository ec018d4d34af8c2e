#pragma once

#include <cstddef>

#include "relax/aligned_vector.h"
#include "relax/packed.h"

namespace taut {

/// How three-vectors lie in memory.
enum class Layout {
  packed,  ///< four numbers of one side by side: quick wherever the masses of links lie
  split,   ///< all x, then all y, then all z: quicker where links follow each other as their masses do
};

/// Three-vectors as the kernels see them.
template <class Number>
struct RoomView {
  Number* first;          ///< the x of the first one
  std::size_t component;  ///< numbers from the x of one to its y, and from that to its z
};

/// Room for three-vectors, one for each place where a mass lies.
template <class Real>
class VectorRoom {
 public:
  VectorRoom() = default;
  /// Zeros.
  VectorRoom(std::size_t size, Layout layout);

  Packed<Real> at(std::size_t place) const {
    const Real* x = numbers() + place * between_;
    return {*x, x[component_], x[2 * component_], Real(0)};
  }
  void set(std::size_t place, const Packed<Real>& vector) {
    Real* x = numbers() + place * between_;
    *x = vector.x;
    x[component_] = vector.y;
    x[2 * component_] = vector.z;
    if (between_ > 1) x[3] = Real(0);
  }

  /// For kernels that write, and for those that don't.
  RoomView<Real> view() { return {numbers(), component_}; }
  RoomView<const Real> read() const { return {numbers(), component_}; }

 private:
  Real* numbers() { return storage_.data(); }
  const Real* numbers() const { return storage_.data(); }

  std::size_t between_ = 4;    // numbers from one x to the next
  std::size_t component_ = 1;  // and from an x to its y
  AlignedVector<Real> storage_;
};

template <class Real>
VectorRoom<Real>::VectorRoom(std::size_t size, Layout layout) {
  if (layout == Layout::split) {
    // A kernel may read as many as a vector holds from the last place on. And x, y and z of a mass are to lie
    // in different sets of a cache, which come again every 4096 bytes.
    constexpr std::size_t page = 4096 / sizeof(Real), beyond = 64 / sizeof(Real);
    between_ = 1;
    component_ = (size + beyond + page - 1) / page * page + page / 3 / beyond * beyond;
    storage_.resize(3 * component_);
  } else {
    storage_.resize(4 * size);
  }
}

}  // namespace taut
