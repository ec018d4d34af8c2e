#include "base/workers.h"

namespace taut {
namespace {

// Some hundred microseconds: to wake a thread can take nearly as long.
constexpr int looks_before_sleep = 300000;

// Waits until a value is no longer `old`.
template <class Value>
void wait_for_change(std::atomic<Value>& value, Value old) {
  for (int look = 0; look < looks_before_sleep; ++look)
    if (value.load(std::memory_order_acquire) != old) return;
  value.wait(old, std::memory_order_acquire);
}

}  // namespace

Workers::Workers(int count) {
  for (int part = 1; part < count; ++part) threads_.emplace_back([this, part] { serve(part); });
}

Workers::~Workers() {
  ends_.store(true);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Workers::run(const void* task, Call call) {
  task_ = task;
  call_ = call;
  left_.store(static_cast<int>(threads_.size()), std::memory_order_relaxed);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  call(task, 0);
  for (int left = left_.load(std::memory_order_acquire); left != 0;
       left = left_.load(std::memory_order_acquire))
    wait_for_change(left_, left);
}

void Workers::serve(int part) {
  for (std::uint32_t round = 0;;) {
    wait_for_change(round_, round);
    if (ends_.load()) return;
    ++round;
    call_(task_, part);
    left_.fetch_sub(1, std::memory_order_acq_rel);
    left_.notify_one();
  }
}

}  // namespace taut
