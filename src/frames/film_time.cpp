#include "frames/film_time.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/failure.h"

namespace taut {
namespace {

// Calls visit(from, speed) for each stretch of even speed, in order: from its first time of the scene on (s).
template <typename Visit>
void for_each_stretch(const Look& look, const Visit& visit) {
  if (look.speed.empty() || look.speed.front()[0] > 0.0) visit(0.0, 1.0);
  for (const auto& [from, speed] : look.speed) visit(from, speed);
}

}  // namespace

double film_duration(const Look& look, double duration) {
  double film = 0.0, begin = 0.0, rate = 1.0;
  for_each_stretch(look, [&](double from, double speed) {
    const double end = std::min(from, duration);
    film += std::max(end - begin, 0.0) / rate;
    begin = std::max(begin, end);
    rate = speed;
  });
  return film + (duration - begin) / rate;
}

double scene_time(const Look& look, double film_time) {
  // Where nothing is slowed down no digit changes.
  if (look.speed.empty()) return film_time;
  double film = 0.0, begin = 0.0, rate = 1.0, time = 0.0;
  bool found = false;
  for_each_stretch(look, [&](double from, double speed) {
    const double stretch = (from - begin) / rate;
    if (!found && film + stretch > film_time) {
      time = begin + (film_time - film) * rate;
      found = true;
    }
    film += stretch;
    begin = from;
    rate = speed;
  });
  return found ? time : begin + (film_time - film) * rate;
}

void slow_down(Look& look, double times) {
  constexpr double slowest = 1e-3, fastest = 1e3;
  if (look.speed.empty() || look.speed.front()[0] > 0.0) look.speed.insert(look.speed.begin(), {0.0, 1.0});
  for (auto& [from, speed] : look.speed) {
    speed /= times;
    if (!(speed >= slowest && speed <= fastest))
      throw BadRequest(
          fmt::format("{} times as slow, {:.6g} s of the scene would pass in a second of film from {:.6g} s "
                      "on; from {} to "
                      "{} can",
                      times, speed, from, slowest, fastest));
  }
}

double film_speed(const Look& look, double time) {
  double now = 1.0;
  for_each_stretch(look, [&](double from, double speed) {
    if (from <= time) now = speed;
  });
  return now;
}

}  // namespace taut
