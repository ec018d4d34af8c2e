#include <fmt/format.h>
#include <gtest/gtest.h>

#include <ostream>
#include <string>
#include <vector>

#include "scene_errors.h"

// Texts that no one means: each is refused by a message that says where and what is wrong, and by no more
// than a screen of it. (The program turns a refusal into exit status 2 before anything is written: see
// cli/bad_scene_test.cpp.)

namespace taut {
namespace {

struct Hostile {
  std::string name;
  std::string text;
  std::string said;                 ///< part of the message
  std::string (*make)() = nullptr;  ///< makes a text of megabytes when it is tried: the program starts often
};

void PrintTo(const Hostile& hostile, std::ostream* out) {
  *out << hostile.name;
}

class HostileSceneTest : public ::testing::TestWithParam<Hostile> {};

TEST_P(HostileSceneTest, IsRefusedInWords) {
  const std::string errors = errors_of(GetParam().make ? GetParam().make() : GetParam().text);
  EXPECT_NE(errors.find(GetParam().said), std::string::npos) << "said: " << errors.substr(0, 2000);
  EXPECT_TRUE(errors.starts_with("f.toml:")) << errors.substr(0, 200);
  EXPECT_LT(errors.size(), 12'000U) << "a screen";
  for (const char c : errors) ASSERT_TRUE(c == '\n' || c == '\t' || static_cast<unsigned char>(c) >= 0x20);
}

std::string repeated(const std::string& text, int times) {
  std::string out;
  out.reserve(text.size() * static_cast<std::size_t>(times));
  for (int i = 0; i < times; ++i) out += text;
  return out;
}

std::string sheet_with(const std::string& lines) {
  return "[[sheet]]\nname = \"cloth\"\nrows = 3\ncolumns = 4\nfrom = [0, 1, 0]\nto = [1, 1, 0]\n"
         "down = [0, -1, 0]\n" +
         lines;  // starts on line 8
}

std::string ragdoll_with(const std::string& lines) {
  return "[[ragdoll]]\nname = \"man\"\nposition = [0, 1, 0]\n" + lines;  // starts on line 4
}

std::string linked_with(const std::string& lines) {
  return masses_with("[[link]]\na = \"hand\"\nb = \"bob\"\n" + lines);  // starts on line 11
}

const std::vector<Hostile>& encodings() {
  static const std::vector<Hostile> rows{
      {"Utf16", std::string("[\0w\0]\0", 6), "not valid TOML"},
      {"Utf16WithMark", std::string("\xff\xfe[\0", 4), "byte 1 is 0xff"},
      {"Latin1", "title = \"caf\xe9\"\n", "byte 13 is 0xe9"},
      {"OverlongSlash", "title = \"\xc0\xaf\"\n", "byte 10 is 0xc0"},
      {"Surrogate", "title = \"\xed\xa0\x80\"\n", "byte 10 is 0xed"},
      {"BeyondUnicode", "title = \"\xf4\x90\x80\x80\"\n", "byte 10 is 0xf4"},
      {"HalfACharacter", "title = \"\xe2\x82", "byte 10 is 0xe2"},
      {"NulByte", std::string("title = \"a\0b\"\n", 14), "not valid TOML"},
      {"ControlCharacter", "title = \"\x1b[31m\"\n", "not valid TOML"},
      {"OnlyTheMark", "\xef\xbb\xbf", "the file is empty"},
      {"OnlySpaces", " \t\r\n \n", "the file is empty"},
      {"TheMarkTwice", "\xef\xbb\xbf\xef\xbb\xbf\xef\xbb\xbftitle = 1\n", "f.toml:1:"},
      {"Html", "<!DOCTYPE html><html></html>\n", "not valid TOML"},
      {"Json", "{\"world\": {\"duration\": 1}}\n", "not valid TOML"},
      {"Yaml", "world:\n  duration: 1\n", "not valid TOML"},
      {"Png", std::string("\x89PNG\r\n\x1a\n", 8), "byte 1 is 0x89"},
      {"BarePath", "/etc/passwd\n", "not valid TOML"},
  };
  return rows;
}

const std::vector<Hostile>& syntax() {
  static const std::vector<Hostile> rows{
      {"OpenString", "title = \"never ends\n", "f.toml:1:"},
      {"OpenLongString", "title = \"\"\"never ends\n", "not valid TOML"},
      {"OpenList", "title = [1, 2\n", "not valid TOML"},
      {"OpenTable", "world = { duration = 1\n", "not valid TOML"},
      {"KeyTwice", "[world]\nduration = 1\nduration = 2\n", "f.toml:3:"},
      {"SectionTwice", "[world]\nduration = 1\n[world]\ndrag = 1\n", "f.toml:3:"},
      {"DottedAndSection", "world.duration = 1\n[world]\ndrag = 1\n", "not valid TOML"},
      {"TableAndList", "[mass]\nname = \"a\"\n[[mass]]\nname = \"b\"\n", "not valid TOML"},
      {"KeyOfAValue", "title = \"a\"\ntitle.b = 1\n", "not valid TOML"},
      {"NoValue", "[world]\nduration =\n", "f.toml:2:"},
      {"NoKey", "[world]\n= 1\n", "f.toml:2:"},
      {"TwoValues", "[world]\nduration = 1 2\n", "f.toml:2:"},
      {"EmptyHeader", "[]\n", "not valid TOML"},
      {"BadEscape", "title = \"\\q\"\n", "not valid TOML"},
      {"BadUnicodeEscape", "title = \"\\uD800\"\n", "not valid TOML"},
      {"LeadingZero", "[world]\nduration = 01\n", "not valid TOML"},
      {"TwoPoints", "[world]\nduration = 1.2.3\n", "not valid TOML"},
      {"TwoSigns", "[world]\nduration = --1\n", "not valid TOML"},
      {"LooseUnderscore", "[world]\nduration = 1__0\n", "not valid TOML"},
      {"ImpossibleDate", "[world]\nduration = 2024-13-45\n", "not valid TOML"},
      {"DeepList", "title = " + repeated("[", 50'000), "nested more than 32 deep"},
      {"DeepTable", "title = " + repeated("{a=", 50'000), "nested more than 32 deep"},
      {"DeepKey", "a" + repeated(".a", 50'000) + " = 1\n", "a dotted key of more than 16 parts"},
      {"DeepHeader", "[a" + repeated(".a", 50'000) + "]\n", "a dotted key of more than 16 parts"},
      {"LongLine", "", "\"title\" must be text",
       [] { return "title = [" + repeated("1, ", 300'000) + "1]\n"; }},
      {"LongName", chain_with(repeated("x", 100'000) + " = 1\n"), "unknown key \"xxxx"},
      {"ManyUnknownKeys", "", "more errors",
       [] {
         std::string keys;
         for (int i = 0; i < 120'000; ++i) keys += fmt::format("k{} = 1\n", i);
         return chain_with(keys);
       }},
      {"TooLarge", "", "larger than 8 MiB", [] { return "#" + std::string(9 << 20, ' '); }},
  };
  return rows;
}

const std::vector<Hostile>& numbers() {
  static const std::vector<Hostile> rows{
      {"MassNan", chain_with("mass = nan\n"), "f.toml:5:8: \"mass\" must be finite, not nan"},
      {"MassInf", chain_with("mass = inf\n"), "must be finite, not inf"},
      {"MassZero", chain_with("mass = 0\n"), "\"mass\" must be above 0 and at most 1e12 kg, not 0"},
      {"MassMinusZero", chain_with("mass = -0.0\n"), "\"mass\" must be above 0"},
      {"MassSubnormal", chain_with("mass = 5e-324\n"), "must not be so near 0: 5e-324"},
      {"MassHuge", chain_with("mass = 1e308\n"), "\"mass\" must be above 0 and at most 1e12 kg"},
      {"MassBeyondDouble", chain_with("mass = 1e999\n"), "f.toml:5:"},
      {"IntegerBeyond64Bits", chain_with("mass = 9223372036854775808\n"), "f.toml:5:"},
      {"IntegerOf400Digits", chain_with("mass = " + repeated("9", 400) + "\n"), "f.toml:5:"},
      {"LinksNegative", chain_with("links = -1\n"), "\"links\" must be between 1 and 1e8, not -1"},
      {"LinksZero", chain_with("links = 0\n"), "\"links\" must be between 1 and 1e8, not 0"},
      {"LinksBeyondInt", chain_with("links = 4294967297\n"), "\"links\" must be between 1 and 1e8"},
      {"LinksBroken", chain_with("links = 2.5\n"), "\"links\" must be a whole number, not 2.5"},
      {"LinksNan", chain_with("links = nan\n"), "\"links\""},
      {"LinksMemory", chain_with("links = 100000000\n"), "this machine has"},
      {"RowsAndColumnsMemory",
       "[[sheet]]\nname = \"c\"\nrows = 100000000\ncolumns = 100000000\n"
       "from = [0, 1, 0]\nto = [1, 1, 0]\ndown = [0, -1, 0]\n",
       "this machine has"},
      {"TinyLength", chain_with("length = 1e-320\n"), "must not be so near 0"},
      {"TinyStiffness", chain_with("stiffness = 1e-320\n"), "must not be so near 0"},
      {"TinyLink", linked_with("length = 1e-320\n"), "f.toml:11:10: \"length\" must not be so near 0"},
      {"TinySphere", chain_with("[[sphere]]\ncentre = [0, 0, 0]\nradius = 1e-320\n"),
       "must not be so near 0"},
      {"TinyGustTime", sheet_with("[wind]\nvelocity = [1, 0, 0]\ngust_time = 1e-320\n"), "so near 0"},
      {"TinyHeight", ragdoll_with("height = 1e-320\n"), "must not be so near 0"},
      {"PositionFar", "[[mass]]\nname = \"a\"\nposition = [1e300, 0, 0]\n", "\"position\" must be between"},
      {"VelocityNan", masses_with("velocity = [0, nan, 0]\n"), "f.toml:8:16: \"velocity\" must be finite"},
      {"GravityInf", chain_with("[world]\ngravity = [0, -inf, 0]\n"), "\"gravity\" must be finite"},
      {"DurationNegative", chain_with("[world]\nduration = -1\n"), "\"duration\" must be above 0"},
      {"DurationOfAYear", chain_with("[world]\nduration = 31557600\n"),
       "\"duration\" must be above 0 and at most"},
      {"DurationTiny", chain_with("[world]\nduration = 1e-320\n"), "must not be so near 0"},
      {"DampingNegative", chain_with("stiffness = 1\ndamping = -1\n"), "\"damping\" must be"},
      {"DampingOfARigidLink", chain_with("damping = 1\n"), "damping needs a stiffness"},
      {"BreakStretchBelowOne", chain_with("break_stretch = 0.5\n"), "\"break_stretch\" must be above 1"},
      {"StepsHuge", chain_with("[solve]\nsteps_per_second = 1e300\n"), "\"steps_per_second\" must be"},
      {"StepsZero", chain_with("[solve]\nsteps_per_second = 0\n"), "\"steps_per_second\" must be"},
      {"PassesHuge", chain_with("[solve]\npasses = 99999999999\n"), "\"passes\" must be"},
      {"PassesBroken", chain_with("[solve]\npasses = 1.5\n"), "\"passes\" must be a whole number"},
      {"FieldOfView", chain_with("[camera]\nfield_of_view = 180\n"), "\"field_of_view\" must be"},
      {"ColourBeyondOne", chain_with("[look]\nmass_colour = [2, 0, 0]\n"), "\"mass_colour\" must be"},
      {"ColourOfLetters", chain_with("[look]\nmass_colour = \"#gggggg\"\n"),
       "\"mass_colour\" must have six digits"},
      {"FrictionHuge", chain_with("[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\nfriction = 1e9\n"),
       "\"friction\" must be"},
      {"ReboundBeyondOne",
       chain_with("[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\nrestitution = 1.1\n"),
       "\"restitution\" must be"},
  };
  return rows;
}

const std::vector<Hostile>& types() {
  static const std::vector<Hostile> rows{
      {"NumberAsText", chain_with("mass = \"1\"\n"), "\"mass\" must be a number in kg, not \"1\""},
      {"NumberAsList", chain_with("mass = [1]\n"), "\"mass\" must be a number in kg, not a list of 1"},
      {"NumberAsTable", chain_with("mass = { kg = 1 }\n"), "\"mass\" must be a number in kg, not a table"},
      {"NumberAsTruth", chain_with("mass = true\n"), "\"mass\" must be a number in kg, not true"},
      {"NumberAsDate", chain_with("mass = 2024-01-01\n"), "not a date or time"},
      {"NumberWithUnit", chain_with("mass = \"1 kg\"\n"), "must be a number in kg, not \"1 kg\""},
      {"TextAsNumber", "[[mass]]\nname = 1\nposition = [0, 0, 0]\n", "\"name\" must be text, not 1"},
      {"TruthAsText", masses_with("pinned = \"yes\"\n"), "\"pinned\" must be true or false"},
      {"TruthAsNumber", masses_with("pinned = 1\n"), "\"pinned\" must be true or false, not 1"},
      {"PlaceOfTwo", "[[mass]]\nname = \"a\"\nposition = [0, 0]\n",
       "must be a list of 3 numbers in m, not a list of 2"},
      {"PlaceOfNone", "[[mass]]\nname = \"a\"\nposition = []\n",
       "must be a list of 3 numbers in m, not an empty list"},
      {"PlaceOfTexts", "[[mass]]\nname = \"a\"\nposition = [\"0\", 0, 0]\n", "must be a list of 3 numbers"},
      {"PlaceOfLists", "[[mass]]\nname = \"a\"\nposition = [[0], 0, 0]\n", "must be a list of 3 numbers"},
      {"ListAsText", chain_with("pinned = \"first\"\n"), "\"pinned\" must be a list of texts"},
      {"ListOfNumbers", chain_with("pinned = [1]\n"), "\"pinned\" must be text, not 1"},
      {"WordOutOfNone", chain_with("pinned = [\"frist\"]\n"), "did you mean \"first\"?"},
      {"TableAsNumber", chain_with("pinned = [\"first\"]\nfirst_motion = 1\n"),
       "\"first_motion\" must be a table"},
      {"SectionAsNumber", "world = 1\n" + chain_with(""), "[world] must be a table, not 1"},
      {"SectionAsList", "world = []\n" + chain_with(""), "[world] must be a table, not an empty list"},
      {"EntriesAsTable", "[link]\na = \"x\"\nb = \"y\"\n", "write [[link]] in place of [link]"},
      {"EntriesAsNumbers", "mass = [1, 2, 3]\n", "[[mass]] must be a table, not 1"},
      {"EntriesAsText", "mass = \"heavy\"\n", "[[mass]]"},
      {"UnknownMethod", chain_with("[solve]\nmethod = \"netwon\"\n"), "did you mean \"newton\"?"},
      {"MethodAsNumber", chain_with("[solve]\nmethod = 3\n"), "\"method\" must be text, not 3"},
      {"KeyOfAnotherMethod", chain_with("[solve]\nmethod = \"newton\"\npasses = 3\n"), "not of \"newton\""},
      {"Theme", chain_with("[look]\ntheme = \"drak\"\n"), "did you mean \"dark\"?"},
      {"UnknownSection", chain_with("[[chian]]\n"), "did you mean [[chain]]?"},
      {"KeyInTheWrongPlace", chain_with("position = [0, 0, 0]\n"), "\"position\" is a key of"},
      {"EmptyKey", chain_with("\"\" = 1\n"), "unknown key \"\""},
      {"NoMasses", "[world]\nduration = 1\n", "the scene has no masses"},
  };
  return rows;
}

const std::vector<Hostile>& meanings() {
  static const std::vector<Hostile> rows{
      {"NameTwice", chain_with("") + chain_with(""), "the name \"rope\" is taken by [[chain]] number 1"},
      {"NameOfAnotherKind", chain_with("[[mass]]\nname = \"rope\"\nposition = [0, 0, 0]\n"),
       "is taken by [[chain]]"},
      {"NameEmpty", "[[mass]]\nname = \"\"\nposition = [0, 0, 0]\n", "name must not be empty"},
      {"NameWithDot", "[[mass]]\nname = \"a.b\"\nposition = [0, 0, 0]\n", "must not contain a dot"},
      {"NameWithStar", "[[mass]]\nname = \"*\"\nposition = [0, 0, 0]\n", "must not contain a dot, a star"},
      {"NameWithSpace", "[[mass]]\nname = \"a b\"\nposition = [0, 0, 0]\n", "a space"},
      {"LinkToNothing", masses_with("[[link]]\na = \"hand\"\nb = \"bib\"\n"), "did you mean \"bob\"?"},
      {"LinkToItself", masses_with("[[link]]\na = \"bob\"\nb = \"bob\"\n"), "can't join \"bob\" to itself"},
      {"LinkOfNoLength",
       "[[mass]]\nname = \"a\"\nposition = [0, 0, 0]\n[[mass]]\nname = \"b\"\nposition = [0, 0, 0]\n"
       "[[link]]\na = \"a\"\nb = \"b\"\n",
       "are at the same point"},
      {"LinkWithoutEnd", masses_with("[[link]]\na = \"bob\"\n"), "[[link]] needs the key \"b\""},
      {"ChainOnAPoint", "[[chain]]\nname = \"a\"\nfrom = [1, 1, 1]\nto = [1, 1, 1]\n", "the same point"},
      {"SheetOnALine",
       "[[sheet]]\nname = \"c\"\nrows = 3\ncolumns = 3\nfrom = [0, 0, 0]\nto = [1, 0, 0]\ndown = [2, 0, 0]\n",
       "not a line"},
      {"SheetOfOneRow",
       "[[sheet]]\nname = \"c\"\nrows = 1\ncolumns = 3\nfrom = [0, 0, 0]\nto = [1, 0, 0]\ndown = [0, -1, "
       "0]\n",
       "\"rows\" must be between 2"},
      {"HooksThatDontFit", sheet_with("hooks = { every = 2 }\n"), "does not divide columns"},
      {"HooksDrawnBackwards", sheet_with("hooks = { every = 3, draw = [[1, 1], [0, 0.5]] }\n"),
       "times must increase"},
      {"HooksDrawnByNothing", sheet_with("hooks = { every = 3, draw = [[0, 0]] }\n"), "share of the rail"},
      {"HooksOfUnknownKey", sheet_with("hooks = { evry = 3 }\n"), "did you mean \"every\" (columns)?"},
      {"PathThatJumps",
       chain_with("pinned = [\"first\"]\nfirst_motion = { path = [[0, 0, 2, 0], [0, 9, 9, 9]] }\n"),
       "times must increase"},
      {"PathBackInTime",
       chain_with("pinned = [\"first\"]\nfirst_motion = { path = [[1, 0, 2, 0], [0, 0, 2, 0]] }\n"),
       "times must increase"},
      {"PathOfNothing", chain_with("pinned = [\"first\"]\nfirst_motion = { path = [] }\n"),
       "a path of at least one place"},
      {"PathOfPlaces", chain_with("pinned = [\"first\"]\nfirst_motion = { path = [[0, 0, 0]] }\n"),
       "must be a list of [t, x, y, z]"},
      {"PathWithNan", chain_with("pinned = [\"first\"]\nfirst_motion = { path = [[0, nan, 0, 0]] }\n"),
       "must be finite"},
      {"PathAndSwing",
       chain_with("pinned = [\"first\"]\nfirst_motion = { amplitude = [1, 0, 0], angular_frequency = 1, path "
                  "= [[0, 0, 2, 0]] }\n"),
       "\"first_motion\""},
      {"MotionOfAFreeMass", masses_with("motion = { amplitude = [1, 0, 0], angular_frequency = 1 }\n"),
       "only for a pinned mass"},
      {"LoadOnNothing", chain_with("[[load]]\nmasses = [\"rop.*\"]\nforce = [0, 1, 0]\n"),
       "no mass is named \"rop.*\""},
      {"LoadBackwards", chain_with("[[load]]\nmasses = [\"rope.1\"]\nforce = [0, 1, 0]\nfrom = 2\nto = 1\n"),
       "is before from"},
      {"AngleOfTwo", masses_with("[[angle]]\nmasses = [\"hand\", \"bob\"]\n"), "must name 3 masses, not 2"},
      {"AngleOfTheSame", masses_with("[[angle]]\nmasses = [\"hand\", \"hand\", \"bob\"]\n"),
       "at the same point"},
      {"AngleOfStrangers", masses_with("[[angle]]\nmasses = [\"hand\", \"bbo\", \"bob\"]\n"),
       "did you mean \"bob\"?"},
      {"AngleInsideOut",
       chain_with(
           "links = 4\n[[angle]]\nmasses = [\"rope.0\", \"rope.1\", \"rope.2\"]\nmin = 170\nmax = 10\n"),
       "is above max"},
      {"AngleOutsideAtTheStart",
       chain_with("links = 4\n[[angle]]\nmasses = [\"rope.0\", \"rope.1\", \"rope.2\"]\nmax = 10\n"),
       "at the start the angle is"},
      {"ConeWithoutAxis",
       chain_with("links = 4\n[[cone]]\nframe = [\"rope.0\", \"rope.1\", \"rope.2\"]\nlimb = [\"rope.2\", "
                  "\"rope.3\"]\naxis = [0, 0, 0]\n"),
       "axis must not be zero"},
      {"PlaneWithoutNormal", chain_with("[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 0, 0]\n"),
       "normal must not be zero"},
      {"CapsuleThatIsABall", chain_with("[[capsule]]\nfrom = [0, 0, 0]\nto = [0, 0, 0]\nradius = 1\n"),
       "write a [[sphere]]"},
      {"BoxWithoutDepth", chain_with("[[box]]\ncentre = [0, 0, 0]\nsize = [1, 1, 0]\n"), "size"},
      {"RagdollHeldByNothing", ragdoll_with("pinned = [\"tail\"]\n"), "\"pinned\" must be"},
      {"RagdollBentBackwards", ragdoll_with("pose = { left_knee = 90 }\n"), "outside"},
      {"CameraInItsTarget", chain_with("[camera]\neye = [1, 1, 1]\ntarget = [1, 1, 1]\n"),
       "are the same point"},
      {"CameraWithoutUp", chain_with("[camera]\nup = [0, 0, 0]\n"), "\"up\" of [camera] must not be zero"},
      {"CameraAfterAStranger", chain_with("[camera]\nfollow = \"rope.99\"\n"), "\"follow\" names no mass"},
      {"TrailOfAStranger", chain_with("[look]\ntrails = [\"rpoe.1\"]\n"), "did you mean \"rope.1\"?"},
      {"FilmThatStandsStill", chain_with("[look]\nspeed = [[0, 0]]\n"), "from 0.001 to 1000"},
      {"FilmBackInTime", chain_with("[look]\nspeed = [[1, 1], [0, 1]]\n"), "must rise"},
      {"WindOfNoSeed", sheet_with("[wind]\nvelocity = [1, 0, 0]\nseed = -1\n"), "\"seed\" must be"},
  };
  return rows;
}

const auto by_name = [](const auto& test) { return test.param.name; };
INSTANTIATE_TEST_SUITE_P(Encodings, HostileSceneTest, ::testing::ValuesIn(encodings()), by_name);
INSTANTIATE_TEST_SUITE_P(Syntax, HostileSceneTest, ::testing::ValuesIn(syntax()), by_name);
INSTANTIATE_TEST_SUITE_P(Numbers, HostileSceneTest, ::testing::ValuesIn(numbers()), by_name);
INSTANTIATE_TEST_SUITE_P(Types, HostileSceneTest, ::testing::ValuesIn(types()), by_name);
INSTANTIATE_TEST_SUITE_P(Meanings, HostileSceneTest, ::testing::ValuesIn(meanings()), by_name);

}  // namespace
}  // namespace taut
