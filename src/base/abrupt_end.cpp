#include "base/abrupt_end.h"

#include <cstdlib>
#include <mutex>
#include <utility>

namespace taut {
namespace {

// What ends the process knows nothing of who made what, so this has to be found from anywhere.
struct Undoings {
  std::mutex mutex;
  std::list<std::function<void()>> latest_first;
};

Undoings& undoings() {
  static Undoings undoings;
  return undoings;
}

}  // namespace

AtAbruptEnd::AtAbruptEnd(std::function<void()> undo) {
  const std::lock_guard lock(undoings().mutex);
  place_ = undoings().latest_first.insert(undoings().latest_first.begin(), std::move(undo));
}

AtAbruptEnd::~AtAbruptEnd() {
  const std::lock_guard lock(undoings().mutex);
  undoings().latest_first.erase(place_);
}

void end_abruptly(int status) {
  // Kept to the end: nothing that is undone may be made again.
  const std::lock_guard lock(undoings().mutex);
  for (const auto& undo : undoings().latest_first) undo();
  std::_Exit(status);
}

}  // namespace taut
