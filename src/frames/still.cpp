#include "frames/still.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/failure.h"
#include "frames/captions.h"
#include "frames/colouring.h"
#include "frames/exact_shape.h"
#include "frames/panels.h"
#include "frames/picture_notes.h"
#include "frames/settled_colours.h"
#include "frames/settled_view.h"
#include "frames/simulation.h"
#include "output/atomic_file.h"
#include "output/png.h"
#include "panel_runs.h"

namespace taut {
namespace {

// Of one picture alone all is said below it; of several in a row, what they share is said below the first.
Caption strip_caption(const Scene& scene, const Simulation& simulation, const State& state, std::size_t which,
                      std::size_t count) {
  if (count == 1)
    return panel_caption(scene, simulation.measures(state), time_text(scene, state.time), {}, true);
  Caption caption{{}, time_text(scene, state.time), {}, false};
  if (which == 0) caption.line = scene.title;
  if (which == 1) caption.line = panel_title(scene);
  return caption;
}

}  // namespace

void check_times(const Scene& scene, const std::vector<double>& times) {
  for (const double time : times)
    if (!(time >= 0.0 && time <= scene.duration))
      throw BadRequest(
          fmt::format("{} lasts from 0 to {} s; {} s is outside", scene.name, scene.duration, time));
}

std::optional<std::string> make_still(Scene& scene, double time, const PictureSettings& settings,
                                      const std::filesystem::path& file, const Execution& execution,
                                      const StopTest& stop) {
  return make_strip(scene, {time}, settings, file, execution, stop);
}

std::vector<double> strip_times(const Scene& scene, double count) {
  if (!(count >= 1.0 && count <= 100.0) || count != std::floor(count))
    throw BadRequest(fmt::format("a strip has from 1 to 100 pictures, not {}", count));
  std::vector<double> times(static_cast<std::size_t>(count));
  for (std::size_t i = 1; i < times.size(); ++i)
    times[i] = std::min(scene.duration, scene.duration * static_cast<double>(i) / (count - 1.0));
  return times;
}

std::optional<std::string> make_strip(Scene& scene, const std::vector<double>& times,
                                      const PictureSettings& settings, const std::filesystem::path& file,
                                      const Execution& execution, const StopTest& stop) {
  require_colours(scene);
  require_exact(scene);
  check_size(settings.render.size);
  check_times(scene, times);
  const SheetGrid grid{settings.render.size, static_cast<int>(times.size()), 1};
  check_size(grid.size());
  Simulation simulation(scene, execution);
  sweep_leftovers(file.parent_path());
  PendingFile pending(file);  // first of all, so that a folder that can't be written costs no simulation
  settle_views({&scene, 1}, settings.drawn_size(), stop);
  std::vector<State> states;
  std::vector<Caption> captions;
  std::vector<std::shared_ptr<const Trails>> trails;
  PictureNotes notes;
  for (const double time : times) {
    std::optional<State> state = simulation.at(time, stop);
    if (!state) throw Interrupted();
    notes.see(scene, settings.drawn_size(), !settings.render.transparent, *state);
    captions.push_back(strip_caption(scene, simulation, *state, states.size(), times.size()));
    trails.push_back(simulation.trails(*state));
    states.push_back(*std::move(state));
  }
  settle_colours(scene, states);
  Painter painter(scene, settings);
  std::vector<Image> pictures;
  for (std::size_t i = 0; i < states.size(); ++i) {
    pictures.push_back(painter.draw(states[i], trails[i].get(), i == 0));
    stop_if_told(stop);
  }
  const std::optional<CaptionWriter> writer =
      settings.captions ? std::optional<CaptionWriter>(scene.look.theme) : std::nullopt;
  const Image sheet = laid_out(grid, pictures, captions, writer ? &*writer : nullptr, scene.look.theme);
  const std::vector<std::uint8_t> png = encode_png(sheet);
  pending.write(std::as_bytes(std::span(png)));
  pending.commit();
  return notes.text();
}

}  // namespace taut
