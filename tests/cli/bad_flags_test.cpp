#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "program.h"

// Every command line that can't be meant ends with exit status 2, a message that says what is wrong, and
// nothing written.

namespace taut::testing {
namespace {

struct BadFlags {
  std::string name;
  std::vector<std::string> words;  ///< SCENE stands for a good scene
  std::string said;                ///< part of the message
};

void PrintTo(const BadFlags& flags, std::ostream* out) {
  *out << flags.name;
}

class BadFlagsTest : public ::testing::TestWithParam<BadFlags> {};

TEST_P(BadFlagsTest, EndWithStatus2AndNothingWritten) {
  const TemporaryFolder folder;
  const std::string scene = folder.write("good.toml", small_scene());
  std::vector<std::string> words = GetParam().words;
  for (std::string& word : words)
    if (word == "SCENE") word = scene;
  const Ran ran = taut(words, {}, folder.path());
  EXPECT_EQ(ran.status, 2) << ran.err;
  EXPECT_NE(ran.err.find(GetParam().said), std::string::npos) << ran.err;
  EXPECT_EQ(ran.err.rfind("taut: ", 0), 0U) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(folder.entries(), 1U) << "nothing but the scene itself";
}

INSTANTIATE_TEST_SUITE_P(
    CommandLines, BadFlagsTest,
    ::testing::Values(
        BadFlags{"NoVerb", {}, "taut --help"},
        BadFlags{"UnknownVerb", {"rendr", "SCENE"}, "did you mean \"render\"?"},
        BadFlags{"UnknownFlag", {"render", "SCENE", "--siez", "64x64"}, "did you mean \"--size\"?"},
        BadFlags{"UnknownFlagWithValue", {"render", "SCENE", "--fsp=20"}, "did you mean \"--fps\"?"},
        BadFlags{"NoScene", {"render"}, "SCENE"},
        BadFlags{"TwoScenes", {"render", "SCENE", "another"}, "\"another\" is one word too many"},
        BadFlags{"SizeZero", {"render", "SCENE", "--size", "0x0"}, "0x0"},
        BadFlags{"SizeHuge", {"render", "SCENE", "--size", "1000000x1000000"}, "16384"},
        BadFlags{"SizeBeyondInt", {"render", "SCENE", "--size", "99999999999x64"}, "--size"},
        BadFlags{"SizeNoSize", {"render", "SCENE", "--size", "large"}, "1280x720"},
        BadFlags{"UnknownQuality", {"render", "SCENE", "--quality", "drfat"}, "did you mean \"draft\"?"},
        BadFlags{"UnknownColour", {"render", "SCENE", "--color", "stain"}, "did you mean \"strain\"?"},
        BadFlags{"UnknownBackend", {"render", "SCENE", "--gl", "osmes"}, "did you mean \"osmesa\"?"},
        BadFlags{"ZeroRate", {"render", "SCENE", "--fps", "0"}, "frames per second"},
        BadFlags{"RateNoNumber", {"render", "SCENE", "--fps", "many"}, "24000/1001"},
        BadFlags{"RateOverNothing", {"render", "SCENE", "--fps", "24000/0"}, "frames per second"},
        BadFlags{"RateTooHigh", {"render", "SCENE", "--fps", "1000.5"}, "at most 1000"},
        BadFlags{"BackendsDeviceNoNumber", {"render", "SCENE", "--gl", "egl:one"}, "--gl"},
        BadFlags{"ZeroFrames", {"render", "SCENE", "--set", "world.duration=0.001"}, "not even one frame"},
        BadFlags{
            "TooManyFrames", {"render", "SCENE", "--set", "world.duration=3600", "--fps", "1000"}, "999999"},
        BadFlags{"FramesBeyondTheEnd", {"render", "SCENE", "--frames", "1-31"}, "from 1 to 30"},
        BadFlags{"FramesBackwards", {"render", "SCENE", "--frames", "9-3"}, "\"9-3\" chooses no frames"},
        BadFlags{"FrameZero", {"render", "SCENE", "--frames", "0"}, "\"0\" chooses no frames"},
        BadFlags{"FilmOfUnknownKind", {"render", "SCENE", "--film", "film.avi"}, ".mp4, .webm, .gif, .webp"},
        BadFlags{"FilmOfOddSize",
                 {"render", "SCENE", "--film", "film.mp4", "--size", "65x48"},
                 "66x48 instead of 65x48"},
        BadFlags{
            "TransparentFilm", {"render", "SCENE", "--film", "film.mp4", "--transparent"}, "transparent"},
        BadFlags{"NothingToMake", {"render", "SCENE", "--no-frames"}, "nothing to make"},
        BadFlags{"UnknownMethod", {"render", "SCENE", "--method", "xbpd"}, "did you mean \"xpbd\""},
        BadFlags{"ParameterOutOfRange", {"render", "SCENE", "--set", "passes=-1"}, "passes"},
        BadFlags{"UnknownKey", {"render", "SCENE", "--set", "world.darg=1"}, "drag"},
        BadFlags{"UnknownShaderFolder", {"render", "SCENE", "--shaders", "nowhere"}, "nowhere"},
        BadFlags{"StillWithoutTime", {"still", "SCENE", "-o", "still.png"}, "--at"},
        BadFlags{"StillBeyondTheEnd", {"still", "SCENE", "--at", "1.5s", "-o", "still.png"}, "from 0 to 1 s"},
        BadFlags{"StillAtNoTime", {"still", "SCENE", "--at", "noon", "-o", "still.png"}, "2.5s"},
        BadFlags{"EmptyStrip", {"strip", "SCENE", "--count", "0", "-o", "strip.png"}, "from 1 to 100"},
        BadFlags{"StripTooWide",
                 {"strip", "SCENE", "--count", "50", "--size", "640x480", "-o", "strip.png"},
                 "32000x480"},
        BadFlags{"UnknownList", {"list", "method"}, "did you mean \"methods\"?"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace taut::testing
