// Meshes as cloth: that a grid of quads is a sheet, and what its masses, links and pins are.

#include <algorithm>
#include <cmath>
#include <memory>

#include "fixtures.h"
#include "mesh_texts.h"
#include "model/face_depth.h"
#include "model/measures.h"

namespace taut::test {
namespace {

constexpr int rows = 6, columns = 8;
constexpr double spacing = 0.1;  // m

MeshSpec mesh_of(const std::string& name, const std::string& text, MeshSpec spec = {}) {
  const testing::MeshFiles files;
  spec.name = "cloth";
  spec.file = name;
  spec.data = files.read(name, text, spec).data;
  return spec;
}

LinkProperties soft(double stiffness) {
  LinkProperties properties;
  properties.stiffness = stiffness;
  properties.damping = 0.05;
  return properties;
}

template <class Spec>
void give_links(Spec& spec) {
  spec.mass = 0.3;
  spec.properties = soft(500.0);
  spec.diagonals = soft(50.0);
  spec.skip_one = soft(20.0);
}

Description as_sheet() {
  SheetSpec sheet;
  sheet.name = "cloth";
  sheet.rows = rows;
  sheet.columns = columns;
  sheet.to = {spacing * (columns - 1), 0.0, 0.0};
  sheet.down = {0.0, -spacing * (rows - 1), 0.0};
  sheet.pinned = {"top"};
  sheet.bending = SheetBendingSpec{};
  sheet.bending->stiffness = 1e-4;
  give_links(sheet);
  Description description;
  description.gravity = {1.0, -9.0, 3.0};
  description.sheets = {sheet};
  return description;
}

Description as_mesh() {
  MeshSpec mesh = mesh_of("grid.obj", testing::grid_obj(rows, columns, spacing));
  mesh.shares = MassShares::equal;
  mesh.pinned_box = {{{-1.0, -0.01, -1.0}, {1.0, 0.01, 1.0}}};
  mesh.bending = BendingSpec{1e-4, false};
  give_links(mesh);
  Description description;
  description.gravity = {1.0, -9.0, 3.0};
  description.meshes = {mesh};
  return description;
}

std::vector<std::array<double, 4>> sorted_links(const Model& model) {
  std::vector<std::array<double, 4>> links;
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const auto [a, b] = std::minmax(model.links.a[i], model.links.b[i]);
    links.push_back({static_cast<double>(a), static_cast<double>(b),
                     static_cast<double>(model.links.family[i]), std::round(model.links.length[i] * 1e9)});
  }
  std::ranges::sort(links);
  return links;
}

TEST(Meshes, AGridOfQuadsHasTheLinksAndBendsOfASheet) {
  const Built sheet = build(as_sheet()), mesh = build(as_mesh());
  ASSERT_TRUE(sheet.problems.empty() && mesh.problems.empty());
  EXPECT_EQ(sorted_links(mesh.model), sorted_links(sheet.model));
  EXPECT_EQ(mesh.model.triangles.size(), sheet.model.triangles.size());
  const auto places = [](const Model& model) {
    std::vector<std::array<Index, 3>> all;
    for (const Bend& bend : model.bends)
      all.push_back({std::min(bend.masses[0], bend.masses[2]), bend.masses[1],
                     std::max(bend.masses[0], bend.masses[2])});
    std::ranges::sort(all);
    return all;
  };
  EXPECT_EQ(places(mesh.model), places(sheet.model));
}

TEST(Meshes, AGridOfQuadsMovesAsASheetToRounding) {
  const Built sheet = build(as_sheet()), mesh = build(as_mesh());
  // Methods that add forces up, so that the order of links matters to rounding alone.
  for (const std::string method : {"spring-explicit", "dop853"}) {
    const Settings how = settings(method, 4000.0);
    const State of_sheet = run(sheet, how, 0.5), of_mesh = run(mesh, how, 0.5);
    double apart = 0.0;
    for (std::size_t i = 0; i < of_sheet.position.size(); ++i)
      apart = std::max(apart, (of_sheet.position.at(i) - of_mesh.position.at(i)).norm());
    EXPECT_LT(apart, 1e-9) << method;
    EXPECT_GT((of_mesh.position.at(rows * columns - 1) - mesh.start.position.at(rows * columns - 1)).norm(),
              0.02);
  }
}

TEST(Meshes, MassesAreSharedByArea) {
  // Two triangles of 1 m² and 3 m² with a common side.
  MeshSpec spec;
  spec.mass = 8.0;
  MeshSpec mesh = mesh_of("a.obj", "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 -3 0\nf 1 2 3\nf 2 1 4\n", spec);
  Description description;
  description.meshes = {mesh};
  const Built built = build(description);
  ASSERT_TRUE(built.problems.empty());
  const std::vector<double> expected{8.0 / 3.0, 8.0 / 3.0, 2.0 / 3.0, 6.0 / 3.0};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(built.model.masses.mass[i], expected[i], 1e-12) << i;
  EXPECT_NEAR(free_mass(built.model), 8.0, 1e-12);
  description.meshes[0].shares = MassShares::equal;
  const Built equal = build(description);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(equal.model.masses.mass[i], 2.0) << i;
}

TEST(Meshes, ArePinnedByGroupBoxAndNumber) {
  const std::string text =
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\ng left\nf 1 2 3\nf 1 3 4\ng right\nf 2 5 3\n";
  const auto pins = [&](MeshSpec spec) {
    Description description;
    description.meshes = {mesh_of("a.obj", text, std::move(spec))};
    const Built built = build(description);
    EXPECT_TRUE(built.problems.empty()) << built.problems[0].message;
    std::vector<Index> pinned;
    for (Index i = 0; i < built.model.masses.size(); ++i)
      if (built.model.masses.pinned(i)) pinned.push_back(i);
    return pinned;
  };
  MeshSpec by_group, by_box, by_number;
  by_group.pinned = {"right"};
  by_box.pinned_box = {{{0.5, 2.0, 1.0}, {-1.0, 0.0, -1.0}}};
  by_number.pinned_masses = {4, 0};
  EXPECT_EQ(pins(by_group), (std::vector<Index>{1, 2, 4}));
  EXPECT_EQ(pins(by_box), (std::vector<Index>{0, 3}));
  EXPECT_EQ(pins(by_number), (std::vector<Index>{0, 4}));
}

TEST(Meshes, TrianglesAreLinkedAcrossTheirEdges) {
  MeshSpec spec;
  spec.skip_one = LinkProperties{};
  Description description;
  description.meshes = {mesh_of("a.obj", testing::square_obj, spec)};
  const Built built = build(description);
  ASSERT_TRUE(built.problems.empty());
  ASSERT_EQ(built.model.links.size(), 6U);  // five edges, and the other diagonal
  EXPECT_EQ(built.model.links.family.back(), LinkFamily::skip_one);
  EXPECT_NEAR(built.model.links.length.back(), std::sqrt(2.0), 1e-15);
}

// Faces of a mesh keep off a ball as a sheet's do.
TEST(Meshes, FacesTouchSolids) {
  MeshSpec spec;
  spec.mass = 0.1;
  spec.properties = soft(800.0);
  spec.diagonals = soft(80.0);
  spec.turn = {-90.0, 0.0, 0.0};
  spec.position = {-0.35, 0.72, -0.25};
  spec.faces = FacesSpec{0.01, 0.5, true};
  Description description;
  description.drag = 1.0;
  description.meshes = {mesh_of("grid.obj", testing::grid_obj(rows, columns, spacing), spec)};
  SphereSpec ball;
  ball.centre = {0.0, 0.4, 0.0};
  ball.radius = 0.3;
  description.spheres = {ball};
  const Built built = build(description);
  ASSERT_TRUE(built.problems.empty()) << built.problems[0].message;
  const State end = run(built, settings("xpbd", 1200.0), 0.8);
  EXPECT_LT(deepest_face(built.model, end), 2e-4);
  EXPECT_LT(end.position.at(0).y(), 0.6);  // its corners hang down
}

TEST(Meshes, WhatIsWrongWithThemIsSaid) {
  const auto problem = [](MeshSpec spec) {
    Description description;
    description.meshes = {mesh_of("a.obj", "g left\n" + testing::square_obj, std::move(spec))};
    const Built built = build(description);
    return built.problems.empty() ? std::string()
                                  : built.problems[0].message + "|" + built.problems[0].suggestion;
  };
  MeshSpec group, number, box, still, thick;
  group.pinned = {"lft"};
  EXPECT_EQ(problem(group), "\"a.obj\" has no group or material named \"lft\"|left");
  number.pinned_masses = {4};
  EXPECT_EQ(problem(number), "\"cloth\" has masses 0 to 3, and no 4|");
  box.pinned_box = {{{5.0, 5.0, 5.0}, {6.0, 6.0, 6.0}}};
  EXPECT_EQ(problem(box), "no mass of the mesh starts in this box|");
  still.release = 1.0;
  EXPECT_EQ(problem(still), "release is only for what is pinned|");
  thick.faces = FacesSpec{0.5, 0.5, true};
  EXPECT_TRUE(
      problem(thick).starts_with("faces must be at most half as thick as the least height of one, 0.3536 m"))
      << problem(thick);
}

}  // namespace
}  // namespace taut::test
