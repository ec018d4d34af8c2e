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
  for (const char* name : {"auto", "osmesa", "egl", "egl:0", "egl:12"}) {
    ASSERT_TRUE(gl_choice_named(name).has_value()) << name;
    EXPECT_EQ(name, gl_choice_named(name)->name());
  }
  EXPECT_EQ(GlBackend::egl, gl_choice_named("egl:3")->backend);
  EXPECT_EQ(3, gl_choice_named("egl:3")->device);
  for (const char* name : {"vulkan", "egl:", "egl:-1", "egl:x", "egl:0x", "osmesa:0", ""})
    EXPECT_FALSE(gl_choice_named(name).has_value()) << name;
}

TEST(GlContext, BackendsAgreeOnAPicture) {
  for (const GlBackend backend : {GlBackend::osmesa, GlBackend::egl}) {
    const std::string reason = complaint([&] { make_gl_context(backend); });
    if (reason.empty()) continue;
    EXPECT_NE(std::string::npos, reason.find("osmesa, egl")) << reason;
    GTEST_SKIP() << reason;
  }
  const Built scene = testing::all_kinds();
  Look look;
  look.surface = true;
  look.pattern = Pattern::woven;
  const CameraPose pose{{1.5, 1.6, 4.2}, {0.0, 0.8, 0.0}, 38.0};
  const auto draw = [&](GlBackend backend) {
    return testing::draw_once(scene.model, scene.start, look, {.size = {640, 360}}, pose, backend);
  };
  const Image osmesa = draw(GlBackend::osmesa), egl = draw(GlBackend::egl);
  ASSERT_EQ(osmesa.pixels.size(), egl.pixels.size());
  std::size_t apart = 0;
  for (std::size_t i = 0; i < egl.pixels.size(); i += 3) {
    int worst = 0;
    for (std::size_t channel = i; channel < i + 3; ++channel)
      worst = std::max(worst, std::abs(osmesa.pixels[channel] - egl.pixels[channel]));
    apart += worst > 2 ? 1 : 0;
  }
  EXPECT_LE(static_cast<double>(apart), 0.001 * static_cast<double>(egl.pixels.size()) / 3.0);
}

TEST(GlContext, SaysWhatDraws) {
  const std::string description = make_gl_context()->description();
  EXPECT_NE(description.find("OpenGL"), std::string::npos) << description;
  std::size_t usable = 0;
  for (const GlDevice& device : gl_devices()) {
    EXPECT_TRUE(gl_choice_named(device.name).has_value()) << device.name;
    EXPECT_NE(device.description.empty(), device.problem.empty()) << device.name;
    usable += device.problem.empty() ? 1 : 0;
  }
  EXPECT_GE(usable, 1U);
  EXPECT_NE(complaint([] { make_gl_context({GlBackend::egl, 99}); }), "");
}

TEST(GlContext, MovesBetweenThreads) {
  const Built scene = row_of_masses({{0, 0, 0}, {1, 0, 0}});
  testing::StatePainter painter(scene, Look{}, {.size = {64, 36}});
  const Image here = painter.draw(scene.start, testing::straight_on());
  Image there;
  std::thread([&] { there = painter.draw(scene.start, testing::straight_on()); }).join();
  EXPECT_EQ(here.pixels, there.pixels);
}

TEST(Shaders, FolderTakesThePlaceOfTheBuiltInOnes) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "sky.frag") << "#version 330 core\nout vec4 pixel;\n"
                                               "void main() { pixel = vec4(0.0, 1.0, 0.0, 1.0); }\n";
  const Built scene = row_of_masses({{0, 0, 0}});
  const auto context = make_gl_context();
  Renderer renderer(*context, bare_look(), {.size = {8, 8}}, folder.path());
  GeometryMaker maker(scene.model, scene.start, bare_look());
  const Image image = flatten(*renderer.draw(*maker.make(scene.start, testing::straight_on())));
  EXPECT_EQ((std::vector<std::uint8_t>{0, 255, 0}),
            std::vector<std::uint8_t>(image.pixels.begin(), image.pixels.begin() + 3));
}

TEST(Shaders, ErrorsCarryFileAndLog) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "link.frag") << "#version 330 core\nvoid main() { nonsense(); }\n";
  const Built scene = row_of_masses({{0, 0, 0}});
  const auto context = make_gl_context();
  const std::string message = complaint([&] {
    Renderer(*context, bare_look(), {.size = {8, 8}}, folder.path());
  });
  EXPECT_NE(std::string::npos, message.find("link.frag")) << message;
  EXPECT_NE(std::string::npos, message.find("nonsense")) << message;
}

TEST(Shaders, FolderMustExist) {
  const Built scene = row_of_masses({{0, 0, 0}});
  const auto context = make_gl_context();
  const std::string message = complaint([&] {
    Renderer(*context, bare_look(), {.size = {8, 8}}, "/no/such/folder");
  });
  EXPECT_NE(std::string::npos, message.find("/no/such/folder")) << message;
}

}  // namespace
}  // namespace taut
