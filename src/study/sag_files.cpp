#include "study/sag_files.h"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "host/build_info.h"
#include "output/gnuplot.h"
#include "output/plot_colour.h"
#include "output/png.h"
#include "study/sag_sheet.h"
#include "study/study_folder.h"

namespace taut {
namespace {

std::string csv_table(const SagStudy& study) {
  std::string table = "passes,velocities_kept,at_rest,time,sag,exact_sag,sag_error,position_error,strain\n";
  for (const SagEntry& entry : study.entries)
    fmt::format_to(std::back_inserter(table), "{},{},{},{},{},{},{},{},{}\n", entry.passes, entry.growing,
                   entry.shape.at_rest, entry.shape.state.time, entry.sag, study.exact_sag, entry.sag_error,
                   entry.position_error, entry.largest_strain);
  return table;
}

// Sag over passes, with the exact one as a line across that has its name in the margin.
PlotScript sag_plot(const Scene& scene, const SagStudy& study) {
  std::string data = "$sag << END\n", marks;
  for (const SagEntry& entry : study.entries)
    if (!entry.growing) {
      fmt::format_to(std::back_inserter(data), "{} {}\n", entry.passes, entry.sag);
      marks += fmt::format("{0}'{1}' {1}", marks.empty() ? "" : ", ", entry.passes);
    }
  data += "END\n";
  PlotScript plot;
  plot.size = {1700, 1100};
  plot.commands = data +
                  fmt::format(
                      "set lmargin at screen 0.14\nset rmargin at screen 0.78\nset tmargin at screen 0.86\n"
                      "set bmargin at screen 0.16\n"
                      "set label {} at screen 0.018,0.955 left font ',{}' tc rgb '{}'\n"
                      "set label {} at screen 0.018,0.905 left font ',{}' tc rgb '{}'\n"
                      "set xlabel 'passes over all links in each step'\nset logscale x 2\n"
                      "set xtics ({})\nunset mxtics\n",
                      plot_text(scene.title), plot_letters + 6, plot_ink,
                      plot_text(fmt::format("{} at {:.6g} steps/s, at rest", study.settings.method,
                                            study.settings.steps_per_second())),
                      plot_small_letters, plot_ink, marks) +
                  fmt::format(
                      "set label 'sag (m)' at screen 0.028,0.5 center rotate by 90 tc rgb '{}'\n"
                      "set label {} at graph 1.015, first {} left font ',{}' tc rgb '{}'\n"
                      "set offsets graph 0.04, graph 0.02, graph 0.06, graph 0.10\n"
                      "plot {} with lines lw 3 dt 2 lc rgb '{}', $sag with linespoints lt 3 lw 4\n",
                      plot_ink, plot_text(fmt::format("exact: {:.4f} m", study.exact_sag)), study.exact_sag,
                      plot_small_letters, plot_text_colour(4), study.exact_sag, plot_colour(4));
  return plot;
}

}  // namespace

std::string sag_json(const Scene& scene, const SagStudy& study) {
  nlohmann::ordered_json json{{"scene", scene.name},
                              {"method", study.settings.method},
                              {"steps_per_second", study.settings.steps_per_second()},
                              {"exact", {{"sag", study.exact_sag}, {"how", study.exact.how}}},
                              {"entries", nlohmann::ordered_json::array()},
                              {"build", build_info()}};
  for (const SagEntry& entry : study.entries)
    json["entries"].push_back({{"passes", entry.passes},
                               {"velocities_kept", entry.growing},
                               {"at_rest", entry.shape.at_rest},
                               {"how", entry.shape.how},
                               {"time", entry.shape.state.time},
                               {"sag", entry.sag},
                               {"sag_error", entry.sag_error},
                               {"position_error", entry.position_error},
                               {"largest_strain", entry.largest_strain}});
  return json_text(json, 2) + "\n";
}

void write_sag_files(const Scene& scene, const SagStudy& study, const PictureSettings& settings,
                     const std::filesystem::path& folder, const StopTest& stop) {
  StudyFolder files(folder, "sag");
  files.write("sag.csv", csv_table(study));
  files.write("sag.json", sag_json(scene, study));
  files.write("sag.png", encode_png(sag_sheet(scene, study, settings)));
  files.draw("sag-over-passes", sag_plot(scene, study), stop);
  files.know("shapes.jsonl");
  files.finish(scene.name, {});
}

}  // namespace taut
