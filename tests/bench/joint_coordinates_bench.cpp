// A chain of 20 links of 0.1 m, released level, after 1 s: what an error of the last mass's place costs here,
// and in MuJoCo, which has such a chain in joint coordinates and knows no error in lengths. Its RK4 converges
// to the reference here, a witness of another kind.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>

#include "bench_scenes.h"

namespace {

using namespace taut;

constexpr int link_count = 20;
constexpr double link_length = 0.1;  // m

Vec3 end_by(const Settings& how) {
  static const Built chain = bench::build_valid(bench::level_chain(link_count, link_length));
  State state = chain.start;
  bench::simulate_all(chain.model, state, complete_settings(how),
                      static_cast<std::int64_t>(how.steps_per_second()));
  return state.position.at(link_count);
}

Settings ours(const char* method, double rate, const char* order) {
  Settings how = bench::settings(method, rate);
  if (*order != '\0') how.values["order"] = std::string(order);
  return how;
}

const Vec3& reference() {
  static const Vec3 end = end_by(ours("rattle", 40000.0, "4"));
  return end;
}

void report(benchmark::State& run, const Vec3& end) {
  run.counters["error"] = (end - reference()).norm() / (link_count * link_length);
}

void here(benchmark::State& run, const char* method, const char* order) {
  const Settings how = ours(method, static_cast<double>(run.range(0)), order);
  Vec3 end = Vec3::Zero();
  for (auto round : run) end = end_by(how);
  report(run, end);
}
BENCHMARK_CAPTURE(here, xpbd, "xpbd", "")->Arg(2400)->Arg(24000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(here, shake, "shake", "")->Arg(2400)->Arg(9600)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(here, rattle, "rattle", "2")->Arg(300)->Arg(1200)->Arg(4800)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(here, rattle_order_4, "rattle", "4")
    ->Arg(600)
    ->Arg(1200)
    ->Arg(2400)
    ->Unit(benchmark::kMillisecond);

void dop853(benchmark::State& run) {
  static const Built chain = bench::build_valid(bench::level_chain(link_count, link_length));
  const Settings how =
      complete_settings({"dop853", {{"tolerance", std::pow(10.0, -static_cast<double>(run.range(0)))}}});
  Vec3 end = Vec3::Zero();
  for (auto round : run) {
    Run motion(chain.model, chain.start, how);
    end = motion.at(1.0)->position.at(link_count);
  }
  report(run, end);
}
BENCHMARK(dop853)->DenseRange(2, 9)->Unit(benchmark::kMillisecond);  // tolerance 1e-2 to 1e-9 m

std::string mujoco_chain() {
  std::string xml = "<mujoco><option gravity=\"0 -9.81 0\"><flag contact=\"disable\"/></option><worldbody>";
  for (int link = 0; link < link_count; ++link)
    xml += fmt::format(
        "<body pos=\"{} 0 0\"><joint type=\"hinge\" axis=\"0 0 1\"/>"
        "<inertial pos=\"{} 0 0\" mass=\"1\" diaginertia=\"1e-12 1e-12 1e-12\"/>",
        link == 0 ? 0.0 : link_length, link_length);
  for (int link = 0; link < link_count; ++link) xml += "</body>";
  return xml + "</worldbody></mujoco>";
}

struct ModelDeleter {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
struct DataDeleter {
  void operator()(mjData* data) const { mj_deleteData(data); }
};

std::unique_ptr<mjModel, ModelDeleter> load_mujoco_chain() {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "taut-mujoco-chain.xml";
  std::ofstream(file) << mujoco_chain();
  char problem[500] = "";
  std::unique_ptr<mjModel, ModelDeleter> model(mj_loadXML(file.c_str(), nullptr, problem, sizeof problem));
  std::filesystem::remove(file);
  if (!model) throw std::runtime_error(problem);
  return model;
}

void mujoco(benchmark::State& run, mjtIntegrator integrator) {
  const auto model = load_mujoco_chain();
  const std::unique_ptr<mjData, DataDeleter> data(mj_makeData(model.get()));
  model->opt.integrator = integrator;
  model->opt.timestep = 1.0 / static_cast<double>(run.range(0));
  for (auto round : run) {
    mj_resetData(model.get(), data.get());
    for (std::int64_t step = 0; step < run.range(0); ++step) mj_step(model.get(), data.get());
  }
  mj_forward(model.get(), data.get());
  const double* last = data->xipos + 3 * (model->nbody - 1);
  report(run, Vec3(last[0], last[1], last[2]));
}
BENCHMARK_CAPTURE(mujoco, rk4, mjINT_RK4)
    ->Arg(100)
    ->Arg(200)
    ->Arg(400)
    ->Arg(1600)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(mujoco, euler, mjINT_EULER)->Arg(400)->Arg(4000)->Unit(benchmark::kMillisecond);

}  // namespace
