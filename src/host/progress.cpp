#include "host/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "host/standard_streams.h"

namespace taut {
namespace {

constexpr double seconds_between_bars = 0.1;
constexpr double seconds_between_lines = 5.0;
constexpr int bar_cells = 28;

bool set_and_not_empty(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value != '\0';
}

}  // namespace

ProgressStyle progress_style(std::FILE* stream, bool quiet) {
  if (quiet) return ProgressStyle::none;
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal == nullptr || std::string_view(terminal) == "dumb";
  if (dumb || ::isatty(::fileno(stream)) == 0) return ProgressStyle::lines;
  return set_and_not_empty("NO_COLOR") ? ProgressStyle::bar : ProgressStyle::colour_bar;
}

Progress::Progress(std::FILE* stream, ProgressStyle style, std::string what)
    : stream_(stream), style_(style), what_(std::move(what)) {
  if (style != ProgressStyle::none) patience_.emplace(stream, false, fmt::format("at the {}", what_));
}

Progress::~Progress() {
  finish();
}

void Progress::start(int total) {
  total_ = total;
  done_ = 0;
  start_ = Clock::now();
  shown_at_ = 0.0;
}

void Progress::update(int done) {
  if (style_ == ProgressStyle::none) return;
  done_ = done;
  if (patience_) patience_->heard();
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  if (done_ >= total_ || due(elapsed)) show(elapsed);
}

void Progress::show_spent(double seconds) {
  if (patience_) patience_->heard();
  if (style_ == ProgressStyle::none || !due(seconds)) return;
  done_ = std::min(static_cast<int>(seconds), total_);
  shown_at_ = seconds;
  show(fmt::format("{} {}, at most {} left", done_, what_, duration_text(total_ - done_)));
}

bool Progress::due(double elapsed) {
  const double pause = style_ == ProgressStyle::lines ? seconds_between_lines : seconds_between_bars;
  return elapsed - shown_at_ >= pause;
}

void Progress::show(double elapsed) {
  const double speed = elapsed > 0.0 ? done_ / elapsed : 0.0;
  std::string text = fmt::format("{}/{} {}", done_, total_, what_);
  if (speed > 0.0) text += fmt::format(", {:.1f} {}/s", speed, what_);
  if (speed > 0.0 && done_ < total_)
    text += fmt::format(", {} left", duration_text((total_ - done_) / speed));
  shown_at_ = elapsed;
  show(text);
}

void Progress::show(const std::string& text) {
  if (style_ == ProgressStyle::lines) {
    show_text(stream_, text + "\n");
  } else {
    constexpr std::string_view erase_to_end_of_line = "\x1b[K";
    show_text(stream_, fmt::format("\r{} {}{}", bar(), text, erase_to_end_of_line));
    on_line_ = true;
  }
  std::fflush(stream_);
}

std::string Progress::bar() const {
  const int full = total_ > 0 ? bar_cells * done_ / total_ : 0;
  std::string cells;
  for (int cell = 0; cell < bar_cells; ++cell) cells += cell < full ? "━" : "─";
  return style_ == ProgressStyle::colour_bar ? fmt::format("\x1b[36m{}\x1b[0m", cells) : cells;
}

void Progress::finish() {
  patience_.reset();
  if (std::exchange(on_line_, false)) show_text(stream_, "\n");
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::lround(std::min(seconds, 1e9)));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace taut
