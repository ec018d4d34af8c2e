#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <thread>

#include "base/failure.h"
#include "render/gl_context.h"
#include "render/renderer.h"
#include "small_scenes.h"

namespace taut {
namespace {

using testing::bare_look;
using testing::cut_out;
using testing::row_of_masses;

/// What a call complains about; empty when it doesn't.
template <typename Call>
std::string complaint(const Call& call) {
  try {
    call();
  } catch (const RunFailure& failure) {
    return failure.what();
  }
  return {};
}

/// A folder that is gone when the test is over.
class TemporaryFolder {
 public:
  TemporaryFolder()
      : path_(std::filesystem::temp_directory_path() /
              ("taut-shaders-" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) + "-" +
               ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    std::filesystem::create_directories(path_);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

TEST(GlContext, BackendsHaveNames) {
  EXPECT_EQ(GlBackend::osmesa, gl_backend_named("osmesa"));
  EXPECT_EQ(GlBackend::egl, gl_backend_named("egl"));
  EXPECT_EQ(GlBackend::automatic, gl_backend_named("auto"));
  EXPECT_FALSE(gl_backend_named("vulkan").has_value());
}

TEST(GlContext, BackendsAgreeOnAPicture) {
  if (const std::string reason = complaint([] { make_gl_context(GlBackend::egl); }); !reason.empty()) {
    EXPECT_NE(std::string::npos, reason.find("osmesa, egl")) << reason;
    GTEST_SKIP() << reason;
  }
  const Built scene = row_of_masses({{-1, 0, 0}, {0, 0.4, 0}, {1, 0, 0}});
  const auto draw = [&](GlBackend backend) {
    return testing::draw_once(scene.model, scene.start, Look{}, {.size = {160, 90}}, testing::straight_on(),
                              backend);
  };
  const Image osmesa = draw(GlBackend::osmesa), egl = draw(GlBackend::egl);
  ASSERT_EQ(osmesa.pixels.size(), egl.pixels.size());
  int worst = 0;
  for (std::size_t i = 0; i < egl.pixels.size(); ++i) {
    worst = std::max(worst, std::abs(osmesa.pixels[i] - egl.pixels[i]));
  }
  EXPECT_LE(worst, 2);
}

TEST(GlContext, MovesBetweenThreads) {
  const Built scene = row_of_masses({{0, 0, 0}, {1, 0, 0}});
  const auto context = make_gl_context();
  Renderer renderer(*context, scene.model, scene.start, Look{}, {.size = {64, 36}});
  const Image here = renderer.draw(scene.start, testing::straight_on());
  Image there;
  std::thread([&] { there = renderer.draw(scene.start, testing::straight_on()); }).join();
  EXPECT_EQ(here.pixels, there.pixels);
}

TEST(Shaders, FolderTakesThePlaceOfTheBuiltInOnes) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "sky.frag") << "#version 330 core\nout vec4 pixel;\n"
                                               "void main() { pixel = vec4(0.0, 1.0, 0.0, 1.0); }\n";
  const Built scene = row_of_masses({{0, 0, 0}});
  const auto context = make_gl_context();
  Renderer renderer(*context, scene.model, scene.start, bare_look(), {.size = {8, 8}}, folder.path());
  const Image image = renderer.draw(scene.start, testing::straight_on());
  EXPECT_EQ((std::vector<std::uint8_t>{0, 255, 0}),
            std::vector<std::uint8_t>(image.pixels.begin(), image.pixels.begin() + 3));
}

TEST(Shaders, ErrorsCarryFileAndLog) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "link.frag") << "#version 330 core\nvoid main() { nonsense(); }\n";
  const Built scene = row_of_masses({{0, 0, 0}});
  const auto context = make_gl_context();
  const std::string message = complaint([&] {
    Renderer(*context, scene.model, scene.start, bare_look(), {.size = {8, 8}}, folder.path());
  });
  EXPECT_NE(std::string::npos, message.find("link.frag")) << message;
  EXPECT_NE(std::string::npos, message.find("nonsense")) << message;
}

TEST(Shaders, FolderMustExist) {
  const Built scene = row_of_masses({{0, 0, 0}});
  const auto context = make_gl_context();
  const std::string message = complaint([&] {
    Renderer(*context, scene.model, scene.start, bare_look(), {.size = {8, 8}}, "/no/such/folder");
  });
  EXPECT_NE(std::string::npos, message.find("/no/such/folder")) << message;
}

}  // namespace
}  // namespace taut
