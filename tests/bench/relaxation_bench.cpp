// The relaxation methods' cost per link and pass on square sheets with diagonals, hung by two corners,
// integration and all overhead in, one pass a step, on one thread and on two: as the sheet has its links, and
// in a shuffled order.
// And the same sheets in Bullet's soft body, one position iteration a step, in its single precision. It also
// keeps a tree of its nodes up to date, which takes most of the time on large sheets.
#include <BulletSoftBody/btSoftBody.h>
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>

#include "bench_scenes.h"
#include "study/speed.h"

namespace {

using namespace taut;

void shuffle_links(Links& links) {
  std::vector<std::size_t> order(links.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 random(1);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
  const Links before = links;
  for (std::size_t i = 0; i < order.size(); ++i) {
    links.a[i] = before.a[order[i]];
    links.b[i] = before.b[order[i]];
    links.length[i] = before.length[order[i]];
  }
}

void pass_over_a_sheet(benchmark::State& run, const char* name, const char* precision, int threads,
                       const char* relax = "") {
  Built built = bench::build_valid(square_sheet(static_cast<int>(run.range(0))));
  if (run.range(1) != 0) shuffle_links(built.model.links);
  constexpr double rate = 9600.0;
  Settings how = bench::settings(name, rate);
  if (*precision != '\0') how.values["precision"] = std::string(precision);
  if (*relax != '\0') how.values["relax"] = std::string(relax);
  Run moving(built.model, built.start, complete_settings(how), {}, {std::make_shared<Workers>(threads)});
  moving.step();
  const std::int64_t before = moving.report().counts.link_solves;
  for (auto round : run) moving.step();
  if (moving.ended()) run.SkipWithError("a step was not solved");
  run.counters["s/link/pass"] =
      benchmark::Counter(static_cast<double>(moving.report().counts.link_solves - before),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
#define PASS_OVER_A_SHEET(label, ...)                      \
  BENCHMARK_CAPTURE(pass_over_a_sheet, label, __VA_ARGS__) \
      ->ArgsProduct({{64, 256, 1024}, {0, 1}})             \
      ->ArgNames({"size", "shuffled"})                     \
      ->UseRealTime()
PASS_OVER_A_SHEET(xpbd, "xpbd", "", 1);
PASS_OVER_A_SHEET(xpbd_on_2_threads, "xpbd", "", 2);
PASS_OVER_A_SHEET(xpbd_lines, "xpbd", "", 1, "lines");
PASS_OVER_A_SHEET(xpbd_lines_on_2_threads, "xpbd", "", 2, "lines");
PASS_OVER_A_SHEET(xpbd_single, "xpbd", "single", 1);
PASS_OVER_A_SHEET(xpbd_single_on_2_threads, "xpbd", "single", 2);
PASS_OVER_A_SHEET(verlet, "verlet", "", 1);
PASS_OVER_A_SHEET(shake, "shake", "", 1);

void pass_over_a_sheet_in_bullet(benchmark::State& run) {
  const Built built = bench::build_valid(square_sheet(static_cast<int>(run.range(0))));
  const Model& model = built.model;
  btSoftBodyWorldInfo world;
  world.m_gravity = btVector3(0, btScalar(-9.81), 0);
  std::vector<btVector3> positions;
  std::vector<btScalar> masses;
  for (std::size_t i = 0; i < model.masses.size(); ++i) {
    const Vec3 at = built.start.position.at(i);
    positions.emplace_back(static_cast<btScalar>(at.x()), static_cast<btScalar>(at.y()),
                           static_cast<btScalar>(at.z()));
    masses.push_back(model.masses.pinned(i) ? btScalar(0) : static_cast<btScalar>(model.masses.mass[i]));
  }
  btSoftBody body(&world, static_cast<int>(positions.size()), positions.data(), masses.data());
  for (std::size_t i = 0; i < model.links.size(); ++i)
    body.appendLink(static_cast<int>(model.links.a[i]), static_cast<int>(model.links.b[i]), nullptr);
  body.m_materials[0]->m_kLST = 1;
  body.m_cfg.piterations = 1;
  body.m_cfg.kDP = 0;
  body.updateConstants();
  constexpr btScalar step = btScalar(1.0 / 2400.0);
  for (auto round : run) {
    body.predictMotion(step);
    body.solveConstraints();
    body.integrateMotion();
  }
  run.counters["s/link/pass"] =
      benchmark::Counter(static_cast<double>(run.iterations()) * static_cast<double>(body.m_links.size()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(pass_over_a_sheet_in_bullet)->Arg(64)->Arg(256)->ArgName("size")->UseRealTime();

}  // namespace
