#include "motion/run_state.h"

#include <cstring>
#include <type_traits>

#include "base/failure.h"

namespace taut {
namespace {

constexpr std::string_view begins_with = "taut run state 2\n";

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
  pass(saved.report);
  pass(saved.work);
}

void write(const void* from, std::size_t size, std::string& bytes) {
  bytes.append(static_cast<const char*>(from), size);
}

class Reader {
 public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}

  void take(void* to, std::size_t size) {
    if (left_.size() < size) throw BadRequest("the saved state of a run ends too early");
    if (size > 0) std::memcpy(to, left_.data(), size);
    left_.remove_prefix(size);
  }
  std::size_t left() const { return left_.size(); }

 private:
  std::string_view left_;
};

template <class T>
constexpr bool plain = std::is_trivially_copyable_v<T> || std::is_same_v<T, Vec3>;

}  // namespace

std::string to_bytes(const RunState& saved) {
  std::string bytes(begins_with);
  const auto pass = [&bytes](const auto& part) {
    if constexpr (requires { part.data(); }) {
      const std::uint64_t count = part.size();
      write(&count, sizeof count, bytes);
      write(part.data(), count * sizeof part[0], bytes);
    } else {
      static_assert(plain<std::remove_cvref_t<decltype(part)>>);
      write(&part, sizeof part, bytes);
    }
  };
  for_each_part(saved, pass);
  return bytes;
}

RunState run_state_from(std::string_view bytes, const Model& model) {
  if (!bytes.starts_with(begins_with)) throw BadRequest("this is not the saved state of a run");
  bytes.remove_prefix(begins_with.size());
  Reader reader(bytes);
  RunState saved;
  const auto pass = [&reader](auto& part) {
    if constexpr (requires { part.data(); }) {
      std::uint64_t count = 0;
      reader.take(&count, sizeof count);
      if (count > reader.left() / sizeof part[0]) throw BadRequest("the saved state of a run ends too early");
      part.resize(count);
      reader.take(static_cast<void*>(part.data()), count * sizeof part[0]);
    } else {
      reader.take(&part, sizeof part);
    }
  };
  for_each_part(saved, pass);
  const State& state = saved.state;
  const std::size_t masses = model.masses.size(), links = model.links.size();
  const bool fits = state.position.x.size() == masses && state.position.y.size() == masses &&
                    state.position.z.size() == masses && state.velocity.x.size() == masses &&
                    state.velocity.y.size() == masses && state.velocity.z.size() == masses &&
                    state.tension.size() == links && state.broken_at.size() == links &&
                    (state.tension_before.empty() || state.tension_before.size() == links) &&
                    state.static_friction.joints.size() == model.joints.size();
  if (!fits || reader.left() != 0) throw BadRequest("the saved state of a run is of another scene");
  return saved;
}

}  // namespace taut
