#pragma once

#include <algorithm>
#include <cstddef>

namespace taut {

/// Masses, or links of a system, that follow each other: those of [begin, end).
struct Extent {
  std::size_t begin = 0, end = 0;

  std::size_t size() const { return end - begin; }
  bool empty() const { return end <= begin; }
  bool holds(std::size_t i) const { return begin <= i && i < end; }
};

/// An extent that grows at its ends.
class GrowingExtent {
 public:
  bool empty() const { return now_.empty(); }

  /// Lets it grow to an extent that holds it, and calls visit with what has come before it and behind it.
  template <class Visit>
  void grow(Extent larger, const Visit& visit) {
    if (larger.empty()) return;
    if (now_.empty()) now_ = {larger.begin, larger.begin};
    const Extent before{larger.begin, now_.begin}, behind{now_.end, larger.end};
    now_ = larger;
    if (!before.empty()) visit(before);
    if (!behind.empty()) visit(behind);
  }

 private:
  Extent now_;
};

/// What a caller wants done with extents, or nothing: it refers to a function object, which has to outlive
/// it.
class ExtentVisit {
 public:
  ExtentVisit() : visit_(nullptr), call_([](const void*, Extent) {}) {}
  template <class Visit>
  ExtentVisit(const Visit& visit)
      : visit_(&visit),
        call_([](const void* called, Extent extent) { (*static_cast<const Visit*>(called))(extent); }) {}

  void operator()(Extent extent) const { call_(visit_, extent); }

 private:
  const void* visit_;
  void (*call_)(const void*, Extent);
};

}  // namespace taut
