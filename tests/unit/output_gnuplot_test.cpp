#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/failure.h"
#include "output/gnuplot.h"
#include "output/png_check.h"
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

}  // namespace
}  // namespace taut
