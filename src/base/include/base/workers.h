#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <new>
#include <thread>
#include <vector>

namespace taut {

/// Threads that share a piece of work, over and over. Between two pieces they stay awake for some hundred
/// microseconds, because in a run of many short steps the next one is about to come, and then sleep. Where
/// they don't help, because the pieces are too short or the cores have something else to do, the caller goes
/// on alone: every now and then both ways are timed, and the quicker one taken.
class Workers {
 public:
  /// `count` includes the thread that calls run(); at least 1.
  explicit Workers(int count);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  int count() const { return static_cast<int>(threads_.size()) + 1; }

  /// Calls task(0) … task(count − 1), in any threads and any order, and returns when all have returned. They
  /// must not throw. To be called from one thread at a time, with pieces of work that take about as long as
  /// each other.
  template <class Task>
  void run(const Task& task) {
    run(&task, [](const void* what, int part) { (*static_cast<const Task*>(what))(part); });
  }

 private:
  using Call = void (*)(const void* task, int part);
  using Clock = std::chrono::steady_clock;
  enum class Phase { try_together, try_alone, settled };

  void run(const void* task, Call call);
  void run_together();
  void end_threads();
  void run_alone() const;
  void next_phase();
  void serve(int count);
  void take_parts(int count);

  const void* task_ = nullptr;
  Call call_ = nullptr;
  std::atomic<std::uint64_t> next_part_;  // of this piece, below its number in the upper half
  std::atomic<std::uint32_t> pieces_{0};  // begun so far: what threads wait for
  std::atomic<int> done_{0};              // parts of this piece
  std::atomic<bool> ends_{false};
  Phase phase_ = Phase::try_together;
  bool together_ = true;  // while settled
  int left_in_phase_;
  Clock::duration time_together_{}, time_alone_{};
  std::vector<std::thread> threads_;
};

/// Calls job(0) … job(jobs − 1), each once, in any threads and any order: where there are no workers, in this
/// one. What a job finds too little memory for is thrown here.
template <class Job>
void run_jobs(Workers* workers, std::size_t jobs, const Job& job) {
  if (workers == nullptr || workers->count() == 1 || jobs < 2) {
    for (std::size_t i = 0; i < jobs; ++i) job(i);
    return;
  }
  std::atomic<std::size_t> next{0};
  std::atomic<bool> no_memory{false};
  workers->run([&](int) {
    try {
      for (std::size_t i = next++; i < jobs; i = next++) job(i);
    } catch (const std::bad_alloc&) {
      no_memory = true;
    }
  });
  if (no_memory) throw std::bad_alloc();
}

}  // namespace taut
