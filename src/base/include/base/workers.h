#pragma once

#include <atomic>
#include <cstdint>
#include <thread>
#include <vector>

namespace taut {

/// Threads that share a piece of work, over and over: between two pieces they stay awake for a few
/// microseconds, because in a run of many short steps the next one is about to come, and then sleep.
class Workers {
 public:
  /// `count` includes the thread that calls run(); at least 1.
  explicit Workers(int count);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int count() const { return static_cast<int>(threads_.size()) + 1; }

  /// Calls task(0) … task(count − 1), each in a thread of its own, the first in the caller's, and returns
  /// when all have returned. They must not throw. To be called from one thread at a time.
  template <class Task>
  void run(const Task& task) {
    run(&task, [](const void* what, int part) { (*static_cast<const Task*>(what))(part); });
  }

 private:
  using Call = void (*)(const void* task, int part);

  void run(const void* task, Call call);
  void serve(int part);

  std::atomic<std::uint32_t> round_{0};  // counts the pieces of work
  std::atomic<int> left_{0};             // of the threads' shares of this one
  std::atomic<bool> ends_{false};
  const void* task_ = nullptr;
  Call call_ = nullptr;
  std::vector<std::thread> threads_;
};

}  // namespace taut
