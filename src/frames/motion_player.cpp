#include "frames/motion_player.h"

#include <fmt/format.h>

#include "base/failure.h"
#include "methods/registry.h"

namespace taut {

MotionPlayer::MotionPlayer(const Scene& scene, const MotionReader& motion)
    : scene_(scene),
      motion_(motion),
      energy_base_{energy(scene.model, scene.start), energy_scale(scene.model, scene.start)},
      trails_(scene) {}

State MotionPlayer::at(double time) {
  const MotionRecord* record = motion_.find(time);
  if (record == nullptr) throw BadRequest(fmt::format("the motion has no moment at t = {:.6g} s", time));
  while (trails_.next() <= time) trails_.add(motion_.between(trails_.next(), scene_.model));
  now_ = motion_.read(*record, scene_.model);
  return now_.state;
}

RunMeasures MotionPlayer::measures() const {
  const Capabilities& can = find_method(scene_.settings.method)->can;
  return measure_run(scene_.model, energy_base_, reported_state(scene_.model, can, now_.state), now_.work,
                     now_.report);
}

}  // namespace taut
