#include "moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/failure.h"
#include "base/split.h"
#include "frames/film_frames.h"
#include "frames/still.h"
#include "methods/registry.h"
#include "values.h"

namespace taut {
namespace {

int parse_every(const std::string& text) {
  if (text.empty()) return 1;
  constexpr double most = 1e6;
  const double every = parse_number("--every", text);
  if (!(every >= 1.0 && every <= most && every == std::floor(every)))
    throw BadRequest(fmt::format("--every is a whole number from 1 to {}, not {}", most, text));
  return static_cast<int>(every);
}

std::vector<Instant> instants_of_frames(const Scene& scene, const FrameRate& rate, int every) {
  const int count = film_frame_count(scene, rate);
  std::vector<Instant> instants;
  instants.reserve(static_cast<std::size_t>(count));
  for (int frame = 1; frame <= count; frame += every)
    instants.push_back({frame, shown_time(scene, frame, rate)});
  return instants;
}

}  // namespace

std::vector<Instant> chosen_instants(const InstantFlags& flags, const Scene& scene, const FrameRate& rate) {
  if (flags.times.empty()) return instants_of_frames(scene, rate, parse_every(flags.every));
  if (!flags.every.empty()) throw BadRequest("--every is of frames, and --times names instants: one of both");
  std::vector<Instant> instants;
  for (const std::string_view part : split(flags.times, ',')) {
    const double time = parse_seconds("--times", part);
    if (time < 0.0 || (!instants.empty() && time <= instants.back().time))
      throw BadRequest(fmt::format("--times must rise from 0 s on, and {} s does not", time));
    instants.push_back({static_cast<int>(instants.size()) + 1, time});
  }
  check_times(scene, {instants.back().time});
  return instants;
}

bool are_even(const std::vector<Instant>& instants) {
  if (instants.size() < 3) return true;
  const double step = instants[1].time - instants[0].time;
  for (std::size_t i = 2; i < instants.size(); ++i)
    if (std::abs(instants[i].time - instants[i - 1].time - step) > 1e-6 * step) return false;
  return true;
}

MomentSource::MomentSource(const Scene& scene, std::shared_ptr<const MotionReader> motion,
                           const Execution& execution)
    : scene_(scene), motion_(std::move(motion)) {
  if (motion_)
    player_.emplace(scene_, *motion_);
  else
    simulation_.emplace(scene_, execution);
}

MomentSource::MomentSource(const Scene& scene, std::vector<double> times, const std::filesystem::path& folder,
                           const Execution& execution)
    : scene_(scene), kept_(std::in_place, scene, std::move(times), folder, execution) {}

std::optional<State> MomentSource::at(double time, const StopTest& stop) {
  if (kept_) return kept_->next(stop);
  if (simulation_) {
    last_ = simulation_->at(time, stop);
    return last_ ? std::optional(simulation_->reported(*last_)) : std::nullopt;
  }
  if (stop && stop()) return std::nullopt;
  last_ = player_->at(time);
  return reported_state(scene_.model, find_method(scene_.settings.method)->can, *last_);
}

RunMeasures MomentSource::measures() const {
  if (kept_) return kept_->measures();
  return simulation_ ? simulation_->measures(*last_) : player_->measures();
}

}  // namespace taut
