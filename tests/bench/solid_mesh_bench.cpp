// What solids out of meshes cost by the number of their triangles, on one thread: a look for the nearest
// place of a point that is near the surface; a step of each of a thousand masses that lie on one, and for
// comparison on the ball that it stands for; a step of a cloth with faces on it; and the time from vertices
// to a solid.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <random>
#include <vector>

#include "bench_scenes.h"
#include "model/solid_data.h"
#include "model/solid_mesh.h"

namespace {

using namespace taut;

constexpr double rate = 600.0;  // 1/s

struct BallMesh {
  std::vector<Vec3> vertices;
  std::vector<SolidMesh::Corners> triangles;
};

// A ball of a metre by latitude and longitude.
BallMesh ball_of(std::int64_t triangles) {
  const auto rings = static_cast<Index>(std::lround(std::sqrt(static_cast<double>(triangles) / 4.0)));
  const Index around = 2 * rings;
  BallMesh ball;
  for (Index ring = 1; ring < rings; ++ring)
    for (Index side = 0; side < around; ++side) {
      const double latitude = std::numbers::pi * ring / rings,
                   longitude = 2.0 * std::numbers::pi * side / around;
      ball.vertices.emplace_back(std::sin(latitude) * std::cos(longitude), std::cos(latitude),
                                 std::sin(latitude) * std::sin(longitude));
    }
  const auto top = static_cast<Index>(ball.vertices.size()), bottom = top + 1;
  ball.vertices.emplace_back(Vec3::UnitY());
  ball.vertices.emplace_back(-Vec3::UnitY());
  for (Index side = 0; side < around; ++side) {
    const Index next = (side + 1) % around, last = (rings - 2) * around;
    ball.triangles.push_back({top, next, side});
    ball.triangles.push_back({bottom, last + side, last + next});
    for (Index ring = 0; ring + 2 < rings; ++ring) {
      const Index above = ring * around, below = above + around;
      ball.triangles.push_back({above + side, above + next, below + next});
      ball.triangles.push_back({above + side, below + next, below + side});
    }
  }
  return ball;
}

MeshSolidSpec solid_of(std::int64_t triangles) {
  const BallMesh ball = ball_of(triangles);
  MeshSolidSpec solid;
  solid.data = std::make_shared<const SolidData>(
      SolidData{std::make_shared<const SolidMesh>(ball.vertices, ball.triangles), Vec3::Zero()});
  return solid;
}

void make(benchmark::State& run) {
  const BallMesh ball = ball_of(run.range(0));
  for (auto round : run) benchmark::DoNotOptimize(SolidMesh(ball.vertices, ball.triangles));
}
BENCHMARK(make)->RangeMultiplier(10)->Range(100, 100'000)->Unit(benchmark::kMillisecond);

void nearest(benchmark::State& run) {
  const MeshSolidSpec solid = solid_of(run.range(0));
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  std::vector<Vec3> places;
  for (int i = 0; i < 1000; ++i)
    places.emplace_back((1.0 + 0.01 * normal(random)) *
                        Vec3(normal(random), normal(random), normal(random)).normalized());
  std::size_t i = 0;
  for (auto round : run) benchmark::DoNotOptimize(solid.data->mesh->within(places[++i % 1000], 0.02));
}
BENCHMARK(nearest)->RangeMultiplier(10)->Range(100, 100'000);

void step(benchmark::State& run, const Description& description) {
  const Built built = bench::build_valid(description);
  Run moving(built.model, built.start, complete_settings(bench::settings("xpbd", rate)), {},
             {std::make_shared<Workers>(1)});
  for (int i = 0; i < 60; ++i) moving.step();
  for (auto round : run) moving.step();
  if (moving.ended()) run.SkipWithError("a step was not solved");
  const auto masses = static_cast<double>(built.model.masses.size());
  run.counters["s/mass"] =
      benchmark::Counter(masses, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// A thousand masses strewn over the upper half.
Description strewn_masses() {
  Description description;
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 1000; ++i) {
    const double up = 0.8 + 0.2 * unit(random), around = 2.0 * std::numbers::pi * unit(random);
    MassSpec mass;
    mass.name = fmt::format("m{}", i);
    mass.radius = 0.01;
    mass.position = 1.02 * Vec3(std::sqrt(1.0 - up * up) * std::cos(around), up,
                                std::sqrt(1.0 - up * up) * std::sin(around));
    description.masses.push_back(mass);
  }
  return description;
}

void masses_on_it(benchmark::State& run) {
  Description description = strewn_masses();
  description.mesh_solids = {solid_of(run.range(0))};
  description.mesh_solids[0].friction = 1.0;
  step(run, description);
}
BENCHMARK(masses_on_it)->RangeMultiplier(10)->Range(100, 100'000)->Unit(benchmark::kMicrosecond);

void masses_on_a_ball(benchmark::State& run) {
  Description description = strewn_masses();
  description.spheres = {SphereSpec{}};
  description.spheres[0].friction = 1.0;
  step(run, description);
}
BENCHMARK(masses_on_a_ball)->Unit(benchmark::kMicrosecond);

void cloth_on_it(benchmark::State& run) {
  Description description;
  SheetSpec sheet;
  sheet.name = "cloth";
  sheet.rows = sheet.columns = 33;
  sheet.from = {-0.6, 1.02, -0.6};
  sheet.to = {0.6, 1.02, -0.6};
  sheet.down = {0.0, 0.0, 1.2};
  sheet.mass = 0.2;
  sheet.properties.stiffness = 500.0;
  sheet.diagonals = sheet.properties;
  sheet.faces = FacesSpec{0.01, 0.5, true};
  description.sheets = {sheet};
  description.drag = 1.0;
  if (run.range(0) == 0)
    description.spheres = {SphereSpec{}};
  else
    description.mesh_solids = {solid_of(run.range(0))};
  step(run, description);
}
BENCHMARK(cloth_on_it)->Arg(0)->RangeMultiplier(10)->Range(100, 100'000)->Unit(benchmark::kMillisecond);

}  // namespace
