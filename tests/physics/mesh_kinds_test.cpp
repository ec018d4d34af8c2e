// Three kinds of mesh, as the scenes have them: a rectangle of quads, a round cloth of irregular triangles
// and a garment with holes. Each hangs, falls over a ball, and tears.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fixtures.h"
#include "meshes/read_mesh.h"
#include "model/measures.h"

namespace taut::test {
namespace {

class MeshKinds : public ::testing::TestWithParam<std::string> {};

MeshSpec mesh_of_scenes(const std::string& kind) {
  MeshSpec mesh;
  mesh.name = "cloth";
  mesh.mass = 0.3;
  mesh.properties.stiffness = 1500.0;
  mesh.properties.damping = 0.2;
  mesh.diagonals = LinkProperties{};
  mesh.diagonals->stiffness = 60.0;
  mesh.file = kind + ".obj";
  mesh.data = read_mesh(std::string(TAUT_SCENE_FOLDER) + "/meshes/" + mesh.file, mesh).data;
  return mesh;
}

Description world_with(const MeshSpec& mesh) {
  Description description;
  description.drag = 3.0;
  description.meshes = {mesh};
  return description;
}

// How many links end at each mass, broken ones left out.
std::size_t lone_masses(const Model& model, const State& state) {
  std::vector<int> ends(model.masses.size());
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    if (state.broken(i)) continue;
    ++ends[model.links.a[i]];
    ++ends[model.links.b[i]];
  }
  return static_cast<std::size_t>(std::ranges::count(ends, 0));
}

// Hooke's forces of the links that end at pins, on what they hold: at rest that is all of its weight. By a
// method whose stretch is its force; relaxation that is short of passes leaves more stretch than that.
TEST_P(MeshKinds, HangByTheirWeight) {
  MeshSpec mesh = mesh_of_scenes(GetParam());
  mesh.pinned_masses = {0, 9, 18};
  const Built built = build_valid(world_with(mesh));
  const Model& model = built.model;
  const double rate = GetParam() == "shirt" ? 24000.0 : 8000.0;  // steps/s; masses around its holes are light
  const State end = run(built, settings("spring-explicit", rate), 4.0);
  Vec3 held = Vec3::Zero();
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const bool a_is_pin = model.masses.pinned(model.links.a[i]);
    if (a_is_pin == model.masses.pinned(model.links.b[i])) continue;
    const Vec3 along = end.position.at(model.links.b[i]) - end.position.at(model.links.a[i]);
    held += (a_is_pin ? -1.0 : 1.0) * model.links.stiffness[i] * model.links.strain(i, along.norm()) *
            model.links.length[i] * along.normalized();
  }
  const double weight = -9.81 * free_mass(model);
  EXPECT_NEAR(held.y(), -weight, 0.01 * -weight);
  EXPECT_LT(std::hypot(held.x(), held.z()), 0.01 * -weight);
  EXPECT_EQ(broken_links(end), 0u);
}

// On the ball and down around it, nothing of it inside.
TEST_P(MeshKinds, FallOverABall) {
  MeshSpec mesh = mesh_of_scenes(GetParam());
  if (GetParam() == "grid") mesh.turn = {-90.0, 0.0, 0.0};
  mesh.radius = 0.01;
  Description description = world_with(mesh);
  SphereSpec ball;
  ball.radius = 0.2;
  ball.friction = 0.6;
  const Built at_origin = build_valid(description);
  const Vec3 middle = centre_of_mass(at_origin.model, at_origin.start);
  double lowest = middle.y();
  for (std::size_t i = 0; i < at_origin.model.masses.size(); ++i)
    lowest = std::min(lowest, at_origin.start.position.at(i).y());
  ball.centre = {middle.x(), lowest - ball.radius - 0.1, middle.z()};
  description.spheres = {ball};
  const Built built = build_valid(description);
  taut::Run run(built.model, built.start, settings("xpbd", 1200.0, 2.0));
  while (run.state().time < 3.0) {
    ASSERT_TRUE(run.step()) << run.failure();
    if (run.steps() % 20 == 0) {
      ASSERT_LT(deepest_penetration(built.model, run.state()), 1e-4);
    }
  }
  // Held by the ball alone, for there is no ground: it has come down by what it fell and stayed there.
  EXPECT_GT(centre_of_mass(built.model, run.state()).y(), ball.centre.y() - 0.45);
  EXPECT_LT(centre_of_mass(built.model, run.state()).y(), middle.y());
  EXPECT_EQ(broken_links(run.state()), 0u);
}

// Pulled ever harder it holds, and tears; torn it parts from its pins, and nothing is lost to dust.
TEST_P(MeshKinds, Tear) {
  MeshSpec mesh = mesh_of_scenes(GetParam());
  mesh.pinned_masses = {0, 9, 18};
  mesh.properties.break_stretch = 1.3;
  mesh.diagonals->break_stretch = 1.6;
  Description description = world_with(mesh);
  LoadSpec load;
  load.masses = {"cloth.*"};
  load.from = 1.0;
  load.to = 3.0;
  const Built weighed = build_valid(description);
  const auto count = static_cast<double>(weighed.model.masses.size());
  load.force = {0.0, -120.0 * 9.81 * free_mass(weighed.model) / count, 0.0};
  description.loads = {load};
  const Built built = build_valid(description);
  taut::Run run(built.model, built.start, settings("xpbd", 2400.0, 2.0));
  while (run.state().time < 1.0) ASSERT_TRUE(run.step()) << run.failure();
  EXPECT_EQ(broken_links(run.state()), 0u);
  while (run.state().time < 3.5) ASSERT_TRUE(run.step()) << run.failure();
  EXPECT_GE(broken_links(run.state()), 6u);  // all that three pins hold by, at least
  EXPECT_LT(static_cast<double>(lone_masses(built.model, run.state())), 0.05 * count);
  EXPECT_LT(centre_of_mass(built.model, run.state()).y(), centre_of_mass(built.model, built.start).y() - 1.0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, MeshKinds, ::testing::Values("grid", "disk", "poncho", "shirt"), case_name);

}  // namespace
}  // namespace taut::test
