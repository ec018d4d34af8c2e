// What Assimp makes of exported meshes: every corner is found again as the mass that stands there.

#include <assimp/scene.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "export/export_shape.h"
#include "exported_states.h"
#include "model/measures.h"

namespace taut::testing {
namespace {

using Corners = std::vector<Index>;

Vec3 place_of(const aiVector3D& vector) {
  return {vector.x, vector.y, vector.z};
}

// The only mass at a place, to single precision.
Index mass_at(const State& state, const Vec3& place) {
  Index found = 0;
  int count = 0;
  for (Index mass = 0; mass < state.position.size(); ++mass)
    if ((state.position.at(mass) - place).norm() < 2e-6) {
      found = mass;
      ++count;
    }
  EXPECT_EQ(count, 1) << place.transpose();
  return found;
}

// From the smallest corner on: the same for every way to write a face of one sense.
Corners turned(Corners corners) {
  std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
  return corners;
}

// Faces, lines and points that a scene of Assimp holds, as masses, in rising order.
std::vector<Corners> cells_of(const aiScene& scene, const State& state) {
  std::vector<Corners> cells;
  for (unsigned int i = 0; i < scene.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[i];
    for (unsigned int face = 0; face < mesh.mNumFaces; ++face) {
      Corners corners;
      for (unsigned int corner = 0; corner < mesh.mFaces[face].mNumIndices; ++corner)
        corners.push_back(mass_at(state, place_of(mesh.mVertices[mesh.mFaces[face].mIndices[corner]])));
      cells.push_back(turned(corners));
    }
  }
  std::ranges::sort(cells);
  return cells;
}

// The same of a model. `triangles`: four corners as two triangles.
std::vector<Corners> wanted_cells(const ExportedStates& exported, const State& state, bool triangles,
                                  bool lines_and_points) {
  const ExportShape shape = export_shape(exported.model(), {true, false}, state);
  std::vector<Corners> cells;
  for (const auto& sheet : shape.sheets)
    for (const ExportFace& face : sheet) {
      const auto& [a, b, c, d] = face.masses;
      if (face.corners == 3 || triangles) cells.push_back(turned({a, b, c}));
      if (face.corners == 4) cells.push_back(triangles ? turned({a, c, d}) : turned({a, b, c, d}));
    }
  if (lines_and_points) {
    const Links& links = exported.model().links;
    for (const Index link : shape.links) cells.push_back(turned({links.a[link], links.b[link]}));
    for (const Index mass : shape.masses) cells.push_back({mass});
  }
  std::ranges::sort(cells);
  return cells;
}

class ExportAssimpTest : public ::testing::Test {
 protected:
  const aiScene& read(const std::filesystem::path& file) {
    const aiScene* scene = importer_.ReadFile(file.string(), 0);
    if (scene == nullptr) throw std::runtime_error(importer_.GetErrorString());
    return *scene;
  }

  Assimp::Importer importer_;
  TemporaryFolder folder_;
  ExportedStates exported_;
};

TEST_F(ExportAssimpTest, TheSceneHasAllThatBreaks) {
  ASSERT_EQ(exported_.states().size(), 5U);
  const ExportShape before = export_shape(exported_.model(), {true, false}, exported_.states().front());
  const ExportShape after = export_shape(exported_.model(), {true, false}, exported_.states().back());
  EXPECT_EQ(before.sheets[0].size(), 20U) << "4 × 5 cells";
  EXPECT_EQ(after.sheets[0].size(), 16U) << "those along the seam are gone";
  EXPECT_TRUE(before.sheets[1].empty()) << "the net has no faces";
  EXPECT_EQ(before.links.size(), 17U + 4U + 1U) << "the net's, the rope's, and the one that breaks";
  EXPECT_EQ(after.links.size(), 17U + 4U) << "the one that broke is gone";
  EXPECT_EQ(before.masses.size(), 1U) << "the ball";
  EXPECT_EQ(after.masses.size(), 2U) << "and the stone";
}

TEST_F(ExportAssimpTest, ObjHoldsEveryFrame) {
  exported_.write("obj", folder_);
  for (std::size_t i = 0; i < exported_.states().size(); ++i) {
    const State& state = exported_.states()[i];
    const aiScene& scene = read(folder_.path() / fmt::format("frame-{:06}.obj", i + 1));
    EXPECT_EQ(cells_of(scene, state), wanted_cells(exported_, state, false, true)) << "frame " << i + 1;
  }
}

// Assimp leaves edges out.
TEST_F(ExportAssimpTest, PlyHoldsEveryFrame) {
  exported_.write("ply", folder_);
  for (std::size_t i = 0; i < exported_.states().size(); ++i) {
    const State& state = exported_.states()[i];
    const aiScene& scene = read(folder_.path() / fmt::format("frame-{:06}.ply", i + 1));
    EXPECT_EQ(cells_of(scene, state), wanted_cells(exported_, state, false, false)) << "frame " << i + 1;
  }
}

TEST_F(ExportAssimpTest, GlbHoldsTheMeshAndTheWayOfEveryMass) {
  const aiScene& scene = read(exported_.write("glb", folder_));
  const std::vector<State>& states = exported_.states();
  EXPECT_EQ(cells_of(scene, states[0]), wanted_cells(exported_, states[0], true, true));
  ASSERT_EQ(scene.mNumMeshes, 3U);
  for (unsigned int i = 0; i < scene.mNumMeshes; ++i) {
    const aiMesh& mesh = *scene.mMeshes[i];
    ASSERT_EQ(mesh.mNumAnimMeshes, states.size() - 1);
    for (unsigned int vertex = 0; vertex < mesh.mNumVertices; ++vertex) {
      const Index mass = mass_at(states[0], place_of(mesh.mVertices[vertex]));
      for (unsigned int target = 0; target < mesh.mNumAnimMeshes; ++target) {
        const Vec3 place = place_of(mesh.mAnimMeshes[target]->mVertices[vertex]);
        EXPECT_LT((place - states[target + 1].position.at(mass)).norm(), 1e-6)
            << exported_.model().masses.name[mass] << " " << target;
      }
    }
  }
}

TEST_F(ExportAssimpTest, GlbTurnsFromInstantToInstant) {
  const aiScene& scene = read(exported_.write("glb", folder_));
  const std::vector<State>& states = exported_.states();
  ASSERT_EQ(scene.mNumAnimations, 1U);
  const aiAnimation& animation = *scene.mAnimations[0];
  ASSERT_EQ(animation.mNumMorphMeshChannels, 3U);
  for (unsigned int channel = 0; channel < 3; ++channel) {
    const aiMeshMorphAnim& keys = *animation.mMorphMeshChannels[channel];
    ASSERT_EQ(keys.mNumKeys, states.size());
    for (unsigned int key = 0; key < keys.mNumKeys; ++key) {
      EXPECT_NEAR(keys.mKeys[key].mTime / animation.mTicksPerSecond, states[key].time, 1e-7);
      ASSERT_EQ(keys.mKeys[key].mNumValuesAndWeights, states.size() - 1);
      for (unsigned int target = 0; target + 1 < states.size(); ++target)
        EXPECT_EQ(keys.mKeys[key].mWeights[target], target + 1 == key ? 1.0 : 0.0) << key << " " << target;
    }
  }
}

TEST_F(ExportAssimpTest, GlbHasNormalsOfTheClothAtEveryInstant) {
  const aiScene& scene = read(exported_.write("glb", folder_));
  const aiMesh& cloth = *scene.mMeshes[0];
  ASSERT_TRUE(cloth.HasNormals());
  // At the start it is flat.
  const Vec3 flat = Vec3(0.0, -0.7, 0.3).cross(Vec3(1.0, 0.1, 0.0)).normalized();
  for (unsigned int vertex = 0; vertex < cloth.mNumVertices; ++vertex) {
    EXPECT_LT((place_of(cloth.mNormals[vertex]) - flat).norm(), 1e-6);
    for (unsigned int target = 0; target < cloth.mNumAnimMeshes; ++target)
      EXPECT_NEAR(place_of(cloth.mAnimMeshes[target]->mNormals[vertex]).norm(), 1.0, 1e-6);
  }
}

// glTF has y up.
TEST_F(ExportAssimpTest, GlbStandsUpright) {
  for (const std::string gravity : {"[0, -9.81, 0]", "[0, 0, -9.81]", "[9.81, 0, 0]", "[0, 9.81, 0]"}) {
    const ExportedStates exported({"world.gravity=" + gravity});
    const aiScene& scene = read(exported.write("glb", folder_));
    const aiNode* root = scene.mRootNode;
    while (root->mNumMeshes == 0 && root->mNumChildren == 1) root = root->mChildren[0];
    const Vec3 up = up_direction(exported.model());
    const aiVector3D turned =
        root->mTransformation *
        aiVector3D(static_cast<ai_real>(up.x()), static_cast<ai_real>(up.y()), static_cast<ai_real>(up.z()));
    EXPECT_LT((place_of(turned) - Vec3::UnitY()).norm(), 1e-6)
        << gravity << ": " << place_of(turned).transpose();
  }
}

}  // namespace
}  // namespace taut::testing
