#pragma once

#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <string>
#include <thread>

namespace taut {

/// Says what takes so long, from a thread of its own: once nothing has been heard for two seconds, and again
/// after ever longer pauses, until it is destroyed.
class Patience {
 public:
  /// `what` stands behind "still", such as "building the scene". Quiet: says nothing.
  Patience(std::FILE* stream, bool quiet, std::string what);
  ~Patience();
  Patience(const Patience&) = delete;
  Patience& operator=(const Patience&) = delete;

  /// Something else has been said: the next pause is ten seconds. From any thread.
  void heard();

 private:
  void wait();

  std::FILE* stream_;
  std::string what_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ended_ = false, heard_ = false;
  std::thread thread_;  // the last member: it uses the others
};

}  // namespace taut
