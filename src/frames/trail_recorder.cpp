#include "frames/trail_recorder.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "base/bytes.h"

namespace taut {

TrailRecorder::TrailRecorder(const Scene& scene)
    : kept_(scene.look.trail_time > 0.0 ? scene.look.trail_time : infinity) {
  std::unordered_map<std::string_view, Index> by_name;
  for (Index mass = 0; mass < scene.model.masses.size() && !scene.look.trails.empty(); ++mass)
    by_name.emplace(scene.model.masses.name[mass], mass);
  for (const std::string& name : scene.look.trails)
    if (const auto found = by_name.find(name); found != by_name.end()) masses_.push_back(found->second);
  trails_.resize(masses_.size());
}

double TrailRecorder::next() const {
  return masses_.empty() ? infinity : static_cast<double>(taken_) / trail_points_a_second;
}

void TrailRecorder::add(const State& state) {
  ++taken_;
  for (std::size_t i = 0; i < masses_.size(); ++i) {
    std::vector<TrailPoint>& trail = trails_[i];
    trail.push_back({state.time, state.position.at(masses_[i])});
    // One more than is seen, where the end fades out between two.
    const auto seen = std::ranges::find_if(
        trail, [&](const TrailPoint& point) { return point.time >= state.time - kept_; });
    if (seen - trail.begin() > 1) trail.erase(trail.begin(), seen - 1);
  }
}

std::shared_ptr<const Trails> TrailRecorder::up_to(const State& now) const {
  if (masses_.empty()) return nullptr;
  auto trails = std::make_shared<Trails>(trails_);
  for (std::size_t i = 0; i < masses_.size(); ++i)
    (*trails)[i].push_back({now.time, now.position.at(masses_[i])});
  return trails;
}

std::string TrailRecorder::save() const {
  std::string bytes;
  append_bytes(taken_, bytes);
  for (const std::vector<TrailPoint>& trail : trails_) append_bytes(trail, bytes);
  return bytes;
}

void TrailRecorder::restore(std::string_view bytes) {
  ByteReader reader(bytes);
  reader.take(taken_);
  for (std::vector<TrailPoint>& trail : trails_) reader.take(trail);
  if (!reader.at_end()) throw BadRequest("these are the trails of another scene");
}

}  // namespace taut
