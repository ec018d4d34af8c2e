// How long a mesh takes from its file to a model, by its number of faces: it is to grow as they do, so that
// the time a face takes stays the same.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "meshes/read_mesh.h"
#include "model/description.h"

namespace {

using namespace taut;

std::string grid_text(int cells) {
  std::string text;
  for (int row = 0; row <= cells; ++row)
    for (int column = 0; column <= cells; ++column)
      text += fmt::format("v {} {} {}\n", 0.01 * column, -0.01 * row, 0.001 * ((row * 7 + column * 3) % 5));
  for (int row = 0; row < cells; ++row)
    for (int column = 0; column < cells; ++column) {
      const int corner = row * (cells + 1) + column + 1;
      text += fmt::format("f {} {} {}\nf {} {} {}\n", corner, corner + cells + 1, corner + 1, corner + 1,
                          corner + cells + 1, corner + cells + 2);
    }
  return text;
}

void load(benchmark::State& run) {
  const int cells = static_cast<int>(std::lround(std::sqrt(0.5 * static_cast<double>(run.range(0)))));
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "taut-mesh-bench.obj";
  std::ofstream(file) << grid_text(cells);
  for (auto round : run) {
    MeshSpec mesh;
    mesh.name = "cloth";
    mesh.file = file.string();
    mesh.data = read_mesh(file, mesh).data;
    mesh.skip_one = LinkProperties{};
    mesh.bending = BendingSpec{1e-4, true};
    Description description;
    description.meshes = {mesh};
    const Built built = build(description);
    if (!built.problems.empty()) run.SkipWithError(built.problems[0].message.c_str());
  }
  std::filesystem::remove(file);
  const double faces = 2.0 * cells * cells;
  run.counters["faces"] = faces;
  run.counters["s/face"] =
      benchmark::Counter(faces, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(load)->Arg(1'000)->Arg(10'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

}  // namespace
