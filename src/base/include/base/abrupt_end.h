#pragma once

#include <functional>
#include <list>

namespace taut {

/// What must not outlive the process, though it end without unwinding: a half-made file, a child. While this
/// lives, end_abruptly() will call `undo`, from any thread.
class AtAbruptEnd {
 public:
  explicit AtAbruptEnd(std::function<void()> undo);
  ~AtAbruptEnd();
  AtAbruptEnd(const AtAbruptEnd&) = delete;
  AtAbruptEnd& operator=(const AtAbruptEnd&) = delete;

 private:
  std::list<std::function<void()>>::iterator place_;
};

/// Undoes what there is, the latest first, and ends the process with that status.
[[noreturn]] void end_abruptly(int status);

}  // namespace taut
