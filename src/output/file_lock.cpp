#include "output/file_lock.h"

#include <sys/file.h>

#include <cerrno>
#include <chrono>
#include <thread>

namespace taut {

bool lock_file(int descriptor, LockWait wait) {
  constexpr int tries = 40;
  constexpr std::chrono::milliseconds between{50};
  for (int i = 1;;) {
    if (::flock(descriptor, wait == LockWait::for_ever ? LOCK_EX : LOCK_EX | LOCK_NB) == 0) return true;
    if (errno == EINTR) continue;
    if (errno != EWOULDBLOCK || wait != LockWait::a_while || i++ == tries) return false;
    std::this_thread::sleep_for(between);
  }
}

}  // namespace taut
