#include "flags_target.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "base/failure.h"
#include "frames/frame_selection.h"
#include "frames/painter.h"
#include "host/shard.h"
#include "measure/plan.h"
#include "render/gl_context.h"
#include "scene/scene.h"
#include "values.h"

namespace taut::testing {
namespace {

constexpr int frames = 180;

struct TooManyParts {};

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

void try_number(const std::string& text) {
  require(std::isfinite(parse_number("--count", text)), "a number that is not finite");
}

void try_time(const std::string& text) {
  require(std::isfinite(parse_seconds("--at", text)), "a time that is not finite");
}

void try_size(const std::string& text) {
  const Size size = parse_size("--size", text);
  check_size(size);
  require(size.width > 0 && size.height > 0, "a picture without an area");
}

void try_rate(const std::string& text) {
  const FrameRate rate = parse_frame_rate("--fps", text);
  require(rate.value() > 0.0 && rate.value() <= 1000.0, "a frame rate out of bounds");
  require(frame_rate_from(rate.text()).has_value(), "a frame rate that does not read back");
  require(frame_count(6.0, rate) > 0, "no frames");
}

void try_selection(const std::string& text) {
  const std::vector<int> chosen = select_frames(text, frames);
  require(!chosen.empty() && chosen.front() >= 1 && chosen.back() <= frames, "frames that there are none of");
  require(select_frames(selection_text(chosen), frames) == chosen, "a selection that does not read back");
}

void try_shard(const std::string& text) {
  const Shard shard = parse_shard(text);
  require(shard.index >= 1 && shard.index <= shard.count, "a shard that there is none of");
}

void try_words(const std::string& text) {
  if (const auto target = parse_accuracy(text)) require(target->error > 0.0, "an accuracy of nothing");
  gl_choice_named(text);
  quality_named(text);
}

void try_set(const std::string& text) {
  const std::string scene =
      "[world]\nduration = 1\n[[chain]]\nname = \"rope\"\nfrom = [0, 2, 0]\nto = [2, 2, 0]\nlinks = 3\n"
      "[[mass]]\nname = \"bob\"\nposition = [3, 0, 0]\n[[link]]\na = \"rope.3\"\nb = \"bob\"\n";
  parse_scene(scene, "fuzz.toml", {{text}, std::nullopt}, [](const Counts& counts) {
    if (std::max(counts.masses, counts.links) > 500.0) throw TooManyParts();
  });
}

void try_as(char kind, const std::string& text) {
  switch (kind) {
    case 'n':
      return try_number(text);
    case 't':
      return try_time(text);
    case 'x':
      return try_size(text);
    case 'r':
      return try_rate(text);
    case 'f':
      return try_selection(text);
    case '/':
      return try_shard(text);
    case 'w':
      return try_words(text);
    default:
      return try_set(text);
  }
}

}  // namespace

void try_flag(const std::string& text) {
  if (text.empty()) return;
  try {
    try_as(text.front(), text.substr(1));
  } catch (const BadRequest& failure) {
    require(failure.what()[0] != '\0', "an error without a message");
  } catch (const TooManyParts&) {
  }
}

}  // namespace taut::testing
