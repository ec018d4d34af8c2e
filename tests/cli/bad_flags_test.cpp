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
        BadFlags{"SizeHuge",
                 {"render", "SCENE", "--size", "1000000x1000000"},
                 "16384x16384 of that shape is the largest"},
        BadFlags{"SizeBeyondOpenGL",
                 {"render", "SCENE", "--size", "20000x10000"},
                 "16384x8192 of that shape is the largest"},
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
        BadFlags{"StillWithoutFile", {"still", "SCENE"}, "--output"},
        BadFlags{"ChangeWithoutSet",
                 {"render", "SCENE", "--set", "world.drag=1", "world.duration=2"},
                 "every change takes a --set of its own: --set world.duration=2"},
        BadFlags{"ChangeTakenForTheScene",
                 {"render", "--set", "world.drag=1", "world.duration=2", "SCENE"},
                 "every change takes a --set of its own: --set world.duration=2"},
        BadFlags{"ChangeInPlaceOfTheScene",
                 {"check", "--set", "world.drag=1", "world.duration=2"},
                 "every change takes a --set of its own: --set world.duration=2"},
        BadFlags{"FlagOfAnotherVerb",
                 {"render", "SCENE", "--at", "2"},
                 "taut render has no flag \"--at\"; taut still has it"},
        BadFlags{
            "FlagOfOtherVerbs", {"list", "scenes", "--film", "a.mp4"}, "taut merge, taut render have it"},
        BadFlags{"ListBySpaces", {"compare", "SCENE", "--methods", "xpbd", "rattle"}, "one word too many"},
        BadFlags{"StillBeyondTheEnd", {"still", "SCENE", "--at", "1.5s", "-o", "still.png"}, "from 0 to 1 s"},
        BadFlags{"StillAtNoTime", {"still", "SCENE", "--at", "noon", "-o", "still.png"}, "2.5s"},
        BadFlags{"EmptyStrip", {"strip", "SCENE", "--count", "0", "-o", "strip.png"}, "from 1 to 100"},
        BadFlags{"StripTooWide",
                 {"strip", "SCENE", "--count", "50", "--size", "640x480", "-o", "strip.png"},
                 "32000x480"},
        BadFlags{"UnknownList", {"list", "method"}, "did you mean \"methods\"?"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    HostileValues, BadFlagsTest,
    ::testing::Values(
        BadFlags{"SizeEmpty", {"render", "SCENE", "--size="}, "--size"},
        BadFlags{"SizeNegative", {"render", "SCENE", "--size=-64x-64"}, "from 16 to 16384"},
        BadFlags{"SizeBeyondOpenGl", {"render", "SCENE", "--size", "20000x20000"}, "20000x20000 is not"},
        BadFlags{"SizeOfThreeSides", {"render", "SCENE", "--size", "64x64x64"}, "such as 1280x720"},
        BadFlags{"SizeInUnits", {"render", "SCENE", "--size", "64pxx64px"}, "such as 1280x720"},
        BadFlags{"SizeHex", {"render", "SCENE", "--size", "0x40x0x40"}, "such as 1280x720"},
        BadFlags{"SizeInExponents", {"render", "SCENE", "--size", "1e3x1e3"}, "such as 1280x720"},
        BadFlags{"SizeOfHalves", {"render", "SCENE", "--size", "64.5x64"}, "such as 1280x720"},
        BadFlags{"StillBeyondOpenGl",
                 {"still", "SCENE", "--at", "0", "-o", "a.png", "--size", "16x16385"},
                 "16x16385 is not"},
        BadFlags{"SheetBeyondOpenGl",
                 {"compare", "SCENE", "--methods", "xpbd,verlet,rattle", "--size", "8000x64"},
                 "24000x64"},
        BadFlags{"FilmBeyondWebp",
                 {"render", "SCENE", "--no-frames", "--film", "a.webp", "--size", "16384x64"},
                 "16383"},
        BadFlags{"RateEmpty", {"render", "SCENE", "--fps="}, "--fps"},
        BadFlags{"RateNegative", {"render", "SCENE", "--fps=-30"}, "24000/1001"},
        BadFlags{"RateNan", {"render", "SCENE", "--fps", "nan"}, "24000/1001"},
        BadFlags{"RateInf", {"render", "SCENE", "--fps", "inf"}, "24000/1001"},
        BadFlags{"RateHuge", {"render", "SCENE", "--fps", "99999999999999999999"}, "24000/1001"},
        BadFlags{"RateOfThreeParts", {"render", "SCENE", "--fps", "1/2/3"}, "24000/1001"},
        BadFlags{"TimeEmpty", {"still", "SCENE", "--at=", "-o", "a.png"}, "--at needs a value"},
        BadFlags{"FilmEmpty", {"render", "SCENE", "--film", ""}, "--film needs a value"},
        BadFlags{"FilmEmptyAndJoined", {"render", "SCENE", "--film="}, "--film needs a value"},
        BadFlags{"MethodEmptyAndApart", {"render", "SCENE", "--method", ""}, "--method needs a value"},
        BadFlags{"TimesEmpty", {"export", "SCENE", "--times", ""}, "--times needs a value"},
        BadFlags{"TimesWithAnEmptyOne", {"export", "SCENE", "--times", "0,,1"}, "--times needs a time"},
        BadFlags{"OutputEmpty", {"render", "SCENE", "-o", ""}, "--output needs a value"},
        BadFlags{"TimeNan", {"still", "SCENE", "--at", "nan", "-o", "a.png"}, "such as 2.5"},
        BadFlags{"TimeInf", {"still", "SCENE", "--at", "infs", "-o", "a.png"}, "such as 2.5"},
        BadFlags{"TimeNegative", {"still", "SCENE", "--at=-1s", "-o", "a.png"}, "from 0 to 1 s"},
        BadFlags{"TimeHuge", {"still", "SCENE", "--at", "1e300", "-o", "a.png"}, "from 0 to 1 s"},
        BadFlags{"TimeInMinutes", {"still", "SCENE", "--at", "1min", "-o", "a.png"}, "60 s is outside"},
        BadFlags{"TimeInUnknownUnits", {"still", "SCENE", "--at", "1ns", "-o", "a.png"}, "500ms or 2min"},
        BadFlags{"TimeOfAUnit", {"still", "SCENE", "--at", "ms", "-o", "a.png"}, "500ms or 2min"},
        BadFlags{"FramesEmpty", {"render", "SCENE", "--frames="}, "--frames"},
        BadFlags{"FramesHuge", {"render", "SCENE", "--frames", "1-99999999999"}, "chooses no frames"},
        BadFlags{"FramesNegative", {"render", "SCENE", "--frames=-3"}, "chooses no frames"},
        BadFlags{"FramesByNothing", {"render", "SCENE", "--frames", "1-9:0"}, "chooses no frames"},
        BadFlags{"FramesOfCommas", {"render", "SCENE", "--frames", ",,,"}, "chooses no frames"},
        BadFlags{"ThreadsZero", {"render", "SCENE", "--threads", "0"}, "from 1 to 256"},
        BadFlags{"ThreadsHuge", {"render", "SCENE", "--threads", "1e9"}, "from 1 to 256"},
        BadFlags{"ThreadsHalf", {"render", "SCENE", "--threads", "1.5"}, "a whole number"},
        BadFlags{"ThreadsNan", {"render", "SCENE", "--threads", "nan"}, "--threads needs a number"},
        BadFlags{"CountHuge", {"strip", "SCENE", "--count", "1e300", "-o", "a.png"}, "from 1 to 100"},
        BadFlags{"CountNegative", {"strip", "SCENE", "--count=-6", "-o", "a.png"}, "from 1 to 100"},
        BadFlags{"AccuracyOfNothing", {"render", "SCENE", "--accuracy", "0%"}, "--accuracy is such as"},
        BadFlags{"AccuracyNan", {"render", "SCENE", "--accuracy", "nan%"}, "--accuracy is such as"},
        BadFlags{
            "AccuracyOfUnknownKind", {"render", "SCENE", "--accuracy", "mood=1%"}, "--accuracy is such as"},
        BadFlags{"SetWithoutValue", {"render", "SCENE", "--set", "world.drag"}, "--set"},
        BadFlags{"SetEmpty", {"render", "SCENE", "--set="}, "--set"},
        BadFlags{"SetOfNothing", {"render", "SCENE", "--set", "=1"}, "--set"},
        BadFlags{"SetOfEmptyParts", {"render", "SCENE", "--set", "world..drag=1"}, "--set"},
        BadFlags{"SetNan", {"render", "SCENE", "--set", "world.drag=nan"}, "must be finite"},
        BadFlags{"SetTiny", {"render", "SCENE", "--set", "mass.bob.mass=1e-320"}, "so near 0"},
        BadFlags{"SetOfAStranger", {"render", "SCENE", "--set", "mass.bbo.mass=1"}, "bob"},
        BadFlags{"SetOfAnEntryBeyond", {"render", "SCENE", "--set", "mass.99.mass=1"}, "99"},
        BadFlags{"SetASectionToANumber",
                 {"render", "SCENE", "--set", "world=1"},
                 "unknown key \"world\" in [solve]"},
        BadFlags{
            "SetEntriesToANumber", {"render", "SCENE", "--set", "link=1"}, "unknown key \"link\" in [solve]"},
        BadFlags{"ShardOfNothing", {"stability", "SCENE", "--shard", "0/0"}, "i from 1 to n"},
        BadFlags{"ShardBeyond", {"stability", "SCENE", "--shard", "9/8"}, "i from 1 to n"},
        BadFlags{"ShardHuge", {"stability", "SCENE", "--shard", "1/99999999999999999999"}, "i from 1 to n"},
        BadFlags{"GridHuge", {"stability", "SCENE", "--grid", "999999x999999"}, "400x400"},
        BadFlags{"MethodEmpty", {"render", "SCENE", "--method="}, "--method"},
        BadFlags{"MethodTwice", {"compare", "SCENE", "--methods", "xpbd,xpbd"}, "twice"},
        BadFlags{"SceneEmpty", {"render", ""}, "SCENE needs a value"}),
    [](const auto& test) { return test.param.name; });

// A process that may have 4 GB.
Ran limited(const std::vector<std::string>& words) {
  std::string script = "ulimit -v 4000000 && exec '" TAUT_PROGRAM "'";
  for (const std::string& word : words) script += " '" + word + "'";
  return run_program("/bin/sh", {"-c", script});
}

TEST(LimitedMemory, PicturesThatItCannotHoldAreBadRequests) {
  if (limited({"list", "methods"}).status != 0) GTEST_SKIP() << "this build needs more than that to start";
  const TemporaryFolder folder;
  const std::string scene = folder.write("good.toml", small_scene());
  const Ran ran = limited({"still", scene, "--at", "0", "-o", folder / "a.png", "--size", "16384x16384"});
  EXPECT_EQ(ran.status, 2) << ran.err;
  EXPECT_NE(
      ran.err.find("pictures of 16384x16384 with 4 samples a pixel need about 15 GB, and there are 4.1 GB"),
      std::string::npos)
      << ran.err;
  EXPECT_EQ(folder.entries(), 1U) << "nothing but the scene itself";
}

TEST(LimitedMemory, ScenesThatItCannotHoldAreBadRequests) {
  if (limited({"list", "methods"}).status != 0) GTEST_SKIP() << "this build needs more than that to start";
  const TemporaryFolder folder;
  const std::string scene = folder.write(
      "large.toml", "[[chain]]\nname = \"rope\"\nfrom = [0, 0, 0]\nto = [1, 0, 0]\nlinks = 9000000\n");
  const Ran ran = limited({"check", scene});
  EXPECT_EQ(ran.status, 2) << ran.err;
  EXPECT_NE(ran.err.find("note: 9e+06 masses and 9e+06 links: about 12.6 GB, and 13 s to build\n"),
            std::string::npos)
      << ran.err;
  EXPECT_NE(ran.err.find("this machine has 4.1 GB"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace taut::testing
