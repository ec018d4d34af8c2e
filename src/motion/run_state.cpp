#include "motion/run_state.h"

#include <cstdint>

#include "base/bytes.h"
#include "base/failure.h"

namespace taut {
namespace {

constexpr std::string_view begins_with = "taut run state 5\n";

// One list of the parts serves both ways: `pass` is called for each of them.
template <class Pass, class Saved>
void for_each_part(Saved& saved, const Pass& pass) {
  pass(saved.state.time);
  for (auto* vectors : {&saved.state.position, &saved.state.velocity}) {
    pass(vectors->x);
    pass(vectors->y);
    pass(vectors->z);
  }
  pass(saved.state.tension);
  pass(saved.state.broken_at);
  pass(saved.state.unanswered_kick);
  pass(saved.state.tension_before);
  pass(saved.state.static_friction.solids);
  pass(saved.state.static_friction.bodies);
  pass(saved.state.static_friction.joints);
  pass(saved.state.own_steps.next);
  pass(saved.state.own_steps.settled);
  pass(saved.state.own_steps.held);
  // One by one: between them there would be bytes that mean nothing and differ from run to run.
  pass(saved.report.end);
  pass(saved.report.counts.status);
  pass(saved.report.counts.worst_link);
  pass(saved.report.counts.rounds);
  pass(saved.report.counts.link_solves);
  pass(saved.report.counts.factorisations);
  pass(saved.report.counts.halvings);
  pass(saved.report.counts.breaks);
  pass(saved.report.steps);
  pass(saved.report.halved_steps);
  pass(saved.report.deepest_halving);
  pass(saved.report.first_halved_at);
  pass(saved.report.last_halved_at);
  pass(saved.report.halved_at_link);
  pass(saved.work);
  pass(saved.parts);
}

void append_parts(const RunState& saved, std::string& bytes) {
  bytes += begins_with;
  for_each_part(saved, [&bytes](const auto& part) { append_bytes(part, bytes); });
}

}  // namespace

std::size_t size_in_bytes(const RunState& saved) {
  std::size_t size = begins_with.size();
  for_each_part(saved, [&size](const auto& part) { size += size_in_bytes(part); });
  return size;
}

std::string to_bytes(const RunState& saved) {
  std::string bytes;
  bytes.reserve(size_in_bytes(saved));
  append_parts(saved, bytes);
  return bytes;
}

void append_run_state(const RunState& saved, std::string& bytes) {
  append_bytes(static_cast<std::uint64_t>(size_in_bytes(saved)), bytes);
  append_parts(saved, bytes);
}

RunState run_state_from(std::string_view bytes, const Model& model) {
  if (!bytes.starts_with(begins_with)) throw BadRequest("this is not the saved state of a run");
  ByteReader reader(bytes.substr(begins_with.size()));
  RunState saved;
  for_each_part(saved, [&reader](auto& part) { reader.take(part); });
  const State& state = saved.state;
  const std::size_t masses = model.masses.size(), links = model.links.size();
  const bool fits = state.position.x.size() == masses && state.position.y.size() == masses &&
                    state.position.z.size() == masses && state.velocity.x.size() == masses &&
                    state.velocity.y.size() == masses && state.velocity.z.size() == masses &&
                    state.tension.size() == links && state.broken_at.size() == links &&
                    (state.tension_before.empty() || state.tension_before.size() == links) &&
                    state.static_friction.joints.size() == model.joints.size();
  if (!fits || !reader.at_end()) throw BadRequest("the saved state of a run is of another scene");
  return saved;
}

}  // namespace taut
