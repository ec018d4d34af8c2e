#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace taut {

/// Allocates from where a line of the cache begins, which no vector of numbers then lies across for as long
/// as it is loaded from a multiple of its size.
template <class T>
struct LineAllocator {
  using value_type = T;
  static constexpr std::align_val_t line{64};

  LineAllocator() = default;
  template <class Other>
  LineAllocator(const LineAllocator<Other>&) {}

  T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), line)); }
  void deallocate(T* first, std::size_t) { ::operator delete(first, line); }
  friend bool operator==(LineAllocator, LineAllocator) { return true; }
};

template <class T>
using AlignedVector = std::vector<T, LineAllocator<T>>;

}  // namespace taut
