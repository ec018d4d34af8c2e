// PNG encoders on one frame of the curtain, 1280×720 RGB, as taut draws it: stb_image_write with ISA-L as its
// compressor, which is in use, and with those that it was chosen over. Run it alone on the machine:
//
//   cmake --preset tested && cmake --build --preset tested --target png_bench &&
//   build/tested/tests/bench/png_bench
//
// Measured on two shared cores (ISA-L 2.30, libdeflate 1.14), time and size of a frame:
//
//   with ISA-L level 1 (in use)     3.4 ms   428 kB
//   with libdeflate level 1         9.4 ms   389 kB
//                   level 3        11.4 ms   340 kB
//                   level 6        22.0 ms   304 kB
#include <benchmark/benchmark.h>
#include <libdeflate.h>

#include <cstdlib>
#include <filesystem>

#include "frames/painter.h"
#include "frames/simulation.h"
#include "output/png.h"
#include "scene/scene.h"

namespace {

// stb's hook for another compressor.
unsigned char* compress_for_stb(unsigned char* data, int length, int* compressed_length, int level) {
  libdeflate_compressor* compressor = libdeflate_alloc_compressor(level);
  const std::size_t room = libdeflate_zlib_compress_bound(compressor, static_cast<std::size_t>(length));
  auto* compressed = static_cast<unsigned char*>(std::malloc(room));
  *compressed_length = static_cast<int>(
      libdeflate_zlib_compress(compressor, data, static_cast<std::size_t>(length), compressed, room));
  libdeflate_free_compressor(compressor);
  return compressed;
}

}  // namespace

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBIW_ZLIB_COMPRESS compress_for_stb
#include <stb_image_write.h>

namespace {

const taut::Image& frame() {
  static const taut::Image image = [] {
    const taut::Scene scene = taut::load_scene(std::filesystem::path(TAUT_SCENE_FOLDER) / "curtain.toml");
    taut::PictureSettings settings;
    settings.render = taut::render_settings_for(taut::Quality::standard);
    return taut::Painter(scene, settings).draw(*taut::Simulation(scene).at(1.0));
  }();
  return image;
}

void report_size(benchmark::State& state, std::size_t bytes) {
  state.counters["kB"] = static_cast<double>(bytes) / 1000.0;
}

void in_use(benchmark::State& state) {
  std::size_t bytes = 0;
  for (auto round : state) bytes = taut::encode_png(frame()).size();
  report_size(state, bytes);
}
BENCHMARK(in_use)->Name("stb with ISA-L, SUB filter, level 1 (in use)")->Unit(benchmark::kMillisecond);

void stb_with_libdeflate(benchmark::State& state) {
  constexpr int filter_sub = 1;
  stbi_write_force_png_filter = filter_sub;
  stbi_write_png_compression_level = static_cast<int>(state.range(0));
  const taut::Image& image = frame();
  int bytes = 0;
  for (auto round : state) {
    unsigned char* png = stbi_write_png_to_mem(image.pixels.data(), 0, image.size.width, image.size.height,
                                               image.channels, &bytes);
    std::free(png);
  }
  report_size(state, static_cast<std::size_t>(bytes));
}
BENCHMARK(stb_with_libdeflate)
    ->Name("stb with libdeflate, SUB filter, level")
    ->Arg(1)
    ->Arg(3)
    ->Arg(6)
    ->Unit(benchmark::kMillisecond);

}  // namespace
