#include "base/workers.h"

namespace taut {
namespace {

// Some hundred microseconds: to wake a thread can take nearly as long.
constexpr int looks_before_sleep = 300000;
constexpr int pieces_of_a_trial = 32;
constexpr int pieces_between_trials = 3000;
constexpr int bits_of_part = 32;

// Waits until a value is no longer `old`.
template <class Value>
void wait_for_change(std::atomic<Value>& value, Value old) {
  for (int look = 0; look < looks_before_sleep; ++look)
    if (value.load(std::memory_order_acquire) != old) return;
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

Workers::Workers(int count)
    : next_part_(static_cast<std::uint64_t>(count)), left_in_phase_(pieces_of_a_trial) {
  try {
    for (int part = 1; part < count; ++part) threads_.emplace_back([this, count] { serve(count); });
  } catch (...) {  // the system gives no more threads
    end_threads();
    throw;
  }
}

Workers::~Workers() {
  end_threads();
}

void Workers::end_threads() {
  ends_.store(true);
  pieces_.fetch_add(1, std::memory_order_release);
  pieces_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Workers::run(const void* task, Call call) {
  task_ = task;
  call_ = call;
  if (threads_.empty()) return run_alone();
  if (phase_ == Phase::settled) {
    together_ ? run_together() : run_alone();
  } else {
    const Clock::time_point start = Clock::now();
    phase_ == Phase::try_together ? run_together() : run_alone();
    (phase_ == Phase::try_together ? time_together_ : time_alone_) += Clock::now() - start;
  }
  if (--left_in_phase_ == 0) next_phase();
}

void Workers::next_phase() {
  if (phase_ == Phase::try_together) {
    phase_ = Phase::try_alone;
    left_in_phase_ = pieces_of_a_trial;
  } else if (phase_ == Phase::try_alone) {
    phase_ = Phase::settled;
    together_ = time_together_ < time_alone_;
    left_in_phase_ = pieces_between_trials;
  } else {
    phase_ = Phase::try_together;
    time_together_ = time_alone_ = {};
    left_in_phase_ = pieces_of_a_trial;
  }
}

void Workers::run_alone() const {
  for (int part = 0; part < count(); ++part) call_(task_, part);
}

void Workers::run_together() {
  done_.store(0, std::memory_order_relaxed);
  const std::uint32_t piece = pieces_.load(std::memory_order_relaxed) + 1;
  next_part_.store(std::uint64_t{piece} << bits_of_part, std::memory_order_release);
  pieces_.store(piece, std::memory_order_release);
  pieces_.notify_all();
  take_parts(count());
  for (int done = done_.load(std::memory_order_acquire); done != count();
       done = done_.load(std::memory_order_acquire))
    wait_for_change(done_, done);
}

void Workers::serve(int count) {
  for (std::uint32_t seen = 0;;) {
    wait_for_change(pieces_, seen);
    seen = pieces_.load(std::memory_order_acquire);
    if (ends_.load()) return;
    take_parts(count);
  }
}

// Whoever is awake takes the next part; one that another thread has just taken, or whose piece is over, can't
// be taken again, because the number has changed.
void Workers::take_parts(int count) {
  std::uint64_t next = next_part_.load(std::memory_order_acquire);
  for (;;) {
    const auto part = static_cast<int>(static_cast<std::uint32_t>(next));
    if (part >= count) return;
    if (!next_part_.compare_exchange_weak(next, next + 1, std::memory_order_acq_rel)) continue;
    call_(task_, part);
    if (done_.fetch_add(1, std::memory_order_acq_rel) + 1 == count) done_.notify_one();
    next = next_part_.load(std::memory_order_acquire);
  }
}

}  // namespace taut
