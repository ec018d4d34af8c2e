#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/failure.h"
#include "output/gnuplot.h"
#include "output/png.h"
#include "output/png_check.h"
#include "program_on_the_path.h"
#include "temporary_folder.h"

namespace taut {
namespace {

using testing::read_file;
using testing::TemporaryFolder;

TEST(Gnuplot, DrawsOnePngAndOneSvg) {
  const TemporaryFolder folder;
  const std::string title = "a_b^c {it's} @ \\ \"q\" & é";
  write_plot({"set title " + plot_text(title) + "\nplot x lt 1\n", {1600, 900}}, folder / "it's.a plot");
  EXPECT_TRUE(is_whole_png(folder / "it's.a plot.png", {1600, 900}));
  const std::string svg = read_file(folder / "it's.a plot.svg");
  EXPECT_NE(svg.find("a_b^c {it's} @ \\ \"q\" &amp; é"), std::string::npos) << svg;
  EXPECT_EQ(folder.entries(), 2U);
}

TEST(Gnuplot, AFailureIsQuotedAndLeavesNothing) {
  const TemporaryFolder folder;
  try {
    write_plot({"plot no_such_function(x)\n"}, folder / "plot");
    FAIL() << "it was drawn";
  } catch (const RunFailure& failure) {
    EXPECT_NE(std::string(failure.what()).find("undefined function: no_such_function"), std::string::npos)
        << failure.what();
  }
  EXPECT_EQ(folder.entries(), 0U);
}

// What drawing a plot throws when gnuplot is a script that knows, as $out, what it is to write.
std::string failure_with_gnuplot(const std::string& script) {
  const TemporaryFolder programs, folder;
  testing::write_program(programs, "gnuplot", "out=$(sed -n \"s/^set output '\\(.*\\)'/\\1/p\")\n" + script);
  const testing::FirstOnThePath path(programs);
  folder.write("plot.png", "before");
  folder.write("plot.svg", "before");
  std::string failure = "no failure";
  try {
    write_plot({"plot x\n", {40, 30}}, folder / "plot");
  } catch (const RunFailure& problem) {
    failure = problem.what();
    failure.replace(failure.find(folder.path().string()), folder.path().string().size(), "FOLDER");
  }
  EXPECT_EQ(read_file(folder / "plot.png"), "before");
  EXPECT_EQ(read_file(folder / "plot.svg"), "before");
  EXPECT_EQ(folder.entries(), 2U);
  return failure;
}

constexpr const char* png_is_bad =
    "gnuplot could not draw FOLDER/plot.png: what it made is cut short or blank";
constexpr const char* svg_is_bad =
    "gnuplot could not draw FOLDER/plot.svg: what it made is cut short or blank";

TEST(Gnuplot, IsNotBelievedThatSaysAllIsWell) {
  EXPECT_EQ(failure_with_gnuplot("exit 0"), png_is_bad);
  EXPECT_EQ(failure_with_gnuplot("echo picture >\"$out\""), png_is_bad);
}

TEST(Gnuplot, APngThatIsCutOrBlankIsNone) {
  const TemporaryFolder folder;
  Image image = Image::blank({40, 30}, 3);
  const auto write = [&](const std::string& name, std::size_t left_out) {
    std::vector<std::uint8_t> png = encode_png(image);
    return folder.write(name, {png.begin(), png.end() - static_cast<std::ptrdiff_t>(left_out)});
  };
  const std::string blank = write("blank.png", 0);
  image.pixels[100] = 77;
  const std::string drawn = write("drawn.png", 0), cut = write("cut.png", 3);
  const auto copy = [](const std::string& file) {
    return "case $out in *png*) cp " + file + " \"$out\";; esac";
  };
  EXPECT_EQ(failure_with_gnuplot(copy(blank)), png_is_bad);
  EXPECT_EQ(failure_with_gnuplot(copy(cut)), png_is_bad);
  EXPECT_EQ(failure_with_gnuplot(copy(drawn)), svg_is_bad);
  for (const std::string svg :
       {"<svg><path d=\"M0,0\"/>", "<svg><g></g></svg>", "<svg><path d=\"M0,0\"/></svg><!--"})
    EXPECT_EQ(failure_with_gnuplot(copy(drawn) + "\ncase $out in *svg*) echo '" + svg + "' >\"$out\";; esac"),
              svg_is_bad)
        << svg;
}

TEST(Gnuplot, ThatHangsIsEndedWhenToldToStop) {
  const TemporaryFolder programs, folder;
  testing::write_program(programs, "gnuplot", "sleep 600");
  const testing::FirstOnThePath path(programs);
  EXPECT_THROW(write_plot({"plot x\n"}, folder / "plot", [] { return true; }), Interrupted);
  int asked = 0;
  EXPECT_THROW(write_plot({"plot x\n"}, folder / "plot", [&] { return ++asked > 5; }), Interrupted);
  EXPECT_EQ(folder.entries(), 0U);
}

}  // namespace
}  // namespace taut
