#pragma once

#include <chrono>
#include <cstdio>
#include <optional>
#include <string>

#include "host/patience.h"

namespace taut {

/// How progress is shown.
enum class ProgressStyle {
  none,
  lines,       ///< a line now and then
  bar,         ///< one line that is drawn over and over
  colour_bar,  ///< the same, coloured
};

/// The style for a stream: a bar on a terminal (coloured unless NO_COLOR is set), lines elsewhere.
ProgressStyle progress_style(std::FILE* stream, bool quiet);

/// Tells how far something has come, how fast it goes and how long it will take; where it comes no further
/// for long, that it is still at it. Not for several threads at once.
class Progress {
 public:
  /// `what` is counted, such as "frames".
  Progress(std::FILE* stream, ProgressStyle style, std::string what);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// How many there will be.
  void start(int total);
  /// How many are done by now.
  void update(int done);
  /// Where seconds are what is counted: how many are spent by now.
  void show_spent(double seconds);
  /// Ends the line that a bar stands on; to be called before anything else is printed.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  bool due(double elapsed);
  void show(double elapsed);
  void show(const std::string& text);
  std::string bar() const;

  std::FILE* stream_;
  ProgressStyle style_;
  std::string what_;
  int total_ = 0, done_ = 0;
  Clock::time_point start_ = Clock::now();
  double shown_at_ = 0.0;  ///< s since start_
  bool on_line_ = false;   ///< the cursor stands behind a bar
  std::optional<Patience> patience_;
};

/// A number of seconds for people: "8 s", "3 min 20 s", "2 h 5 min".
std::string duration_text(double seconds);

}  // namespace taut
