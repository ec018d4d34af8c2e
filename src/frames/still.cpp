#include "frames/still.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/failure.h"
#include "frames/colouring.h"
#include "frames/ground_note.h"
#include "frames/simulation.h"
#include "output/atomic_file.h"
#include "output/png.h"

namespace taut {
namespace {

void paste(const Image& panel, std::size_t column, Image& sheet) {
  const auto channels = static_cast<std::size_t>(panel.channels);
  const std::size_t row_bytes = static_cast<std::size_t>(panel.size.width) * channels;
  const std::size_t sheet_row_bytes = static_cast<std::size_t>(sheet.size.width) * channels;
  for (std::size_t row = 0; row < static_cast<std::size_t>(panel.size.height); ++row)
    std::memcpy(sheet.pixels.data() + row * sheet_row_bytes + column * row_bytes,
                panel.pixels.data() + row * row_bytes, row_bytes);
}

}  // namespace

void check_times(const Scene& scene, const std::vector<double>& times) {
  for (const double time : times)
    if (!(time >= 0.0 && time <= scene.duration))
      throw BadRequest(
          fmt::format("{} lasts from 0 to {} s; {} s is outside", scene.name, scene.duration, time));
}

std::optional<std::string> make_still(const Scene& scene, double time, const PictureSettings& settings,
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

std::optional<std::string> make_strip(const Scene& scene, const std::vector<double>& times,
                                      const PictureSettings& settings, const std::filesystem::path& file,
                                      const Execution& execution, const StopTest& stop) {
  require_colours(scene);
  check_size(settings.render.size);
  check_times(scene, times);
  const Size whole{settings.render.size.width * static_cast<int>(times.size()), settings.render.size.height};
  check_size(whole);
  Simulation simulation(scene, execution);
  PendingFile pending(file);  // first of all, so that a folder that can't be written costs no simulation
  Painter painter(scene, settings);
  Image sheet = Image::blank(whole, settings.render.transparent ? 4 : 3);
  std::optional<std::string> note;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const std::optional<State> state = simulation.at(times[i], stop);
    if (!state) throw Interrupted();
    if (!note && !settings.render.transparent) note = ground_note(scene, *state);
    paste(painter.draw(*state), i, sheet);
    stop_if_told(stop);
  }
  const std::vector<std::uint8_t> png = encode_png(sheet);
  pending.write(std::as_bytes(std::span(png)));
  pending.commit();
  return note;
}

}  // namespace taut
