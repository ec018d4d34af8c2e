#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "methods/registry.h"
#include "motion/simulate.h"
#include "output/export.h"
#include "scene/scene.h"
#include "temporary_folder.h"

namespace taut::testing {

/// The scene tests/foreign/shapes.toml at some times, and exports of that.
class ExportedStates {
 public:
  explicit ExportedStates(const std::vector<std::string>& sets = {})
      : scene_(parse_scene(read_file(TAUT_TEST_DATA "/foreign/shapes.toml"), "shapes.toml", {sets, {}})),
        states_(sampled_run(scene_.model, scene_.start, scene_.settings, times()).states) {}

  static std::vector<double> times() { return {0.0, 0.1, 0.25, 0.4, 0.5}; }  ///< s
  const Scene& scene() const { return scene_; }
  const Model& model() const { return scene_.model; }
  const std::vector<State>& states() const { return states_; }

  /// The cloth has faces, the net has none.
  ExportSubject subject() const {
    ExportSubject subject{scene_.model, scene_.start, scene_.title, times(), FrameRate{10, 1}};
    subject.faces = {true, false};
    subject.colours.sheets = {{0.5, 0.2, 0.2}, {0.2, 0.2, 0.5}};
    return subject;
  }

  /// Exports all states into FOLDER/motion and the format's ending; or, as many files, into the folder.
  std::filesystem::path write(std::string_view name, const TemporaryFolder& folder,
                              ExportTable table = ExportTable::usual) const {
    const ExportFormat& format = export_format(name);
    ExportSubject what = subject();
    what.table = table;
    std::string bytes;
    const std::unique_ptr<MotionExport> writer =
        format.make(what, {[&bytes](std::string_view more) { bytes += more; }, folder.path()});
    int frame = 0;
    for (const State& state : states_) writer->add({++frame, state, state.time > 0.0, {}});
    writer->finish();
    if (format.layout != ExportLayout::one_file) return folder.path();
    return folder.write("motion" + std::string(format.ending), bytes);
  }

 private:
  Scene scene_;
  std::vector<State> states_;
};

}  // namespace taut::testing
