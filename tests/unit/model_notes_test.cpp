// What a description allows though it is seldom meant.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "model/description.h"
#include "scene/scene.h"

namespace taut {
namespace {

Description chain_of_ten(double length, std::vector<std::string> pinned) {
  ChainSpec chain;
  chain.name = "rope";
  chain.to = {2.0, 0.0, 0.0};
  chain.links = 10;
  chain.length = length;
  chain.pinned = std::move(pinned);
  Description description;
  description.chains = {chain};
  return description;
}

std::vector<Problem> notes_of(const Description& description) {
  const Built built = build(description);
  EXPECT_TRUE(built.problems.empty());
  return built.notes;
}

void expect_note(const Problem& note, const std::string& section, const std::string& key,
                 const std::vector<std::string>& parts) {
  EXPECT_EQ(note.section, section);
  EXPECT_EQ(note.key, key);
  for (const std::string& part : parts)
    EXPECT_NE(note.message.find(part), std::string::npos) << "\"" << part << "\" in: " << note.message;
}

TEST(Notes, AreNotMadeOfWhatIsMeant) {
  EXPECT_TRUE(notes_of(chain_of_ten(0.0, {"first"})).empty());
  EXPECT_TRUE(notes_of(chain_of_ten(2.1, {"first", "last"})).empty()) << "it hangs through";
}

TEST(Notes, NameARigidLinkThatStartsWithAnotherLength) {
  Description description;
  MassSpec hook, bob;
  hook.name = "hook";
  hook.pinned = true;
  bob.name = "bob";
  bob.position = {1.2, 0.0, 0.0};
  description.masses = {hook, bob};
  description.links = {LinkSpec{"hook", "bob", 1.0, {}}};
  std::vector<Problem> notes = notes_of(description);
  ASSERT_EQ(notes.size(), 1U);
  expect_note(notes[0], "link", "length", {"\"hook\" to \"bob\"", "1.2 m in place of 1 m", "20 % too long"});
  description.links[0].length = 1.5;
  notes = notes_of(description);
  ASSERT_EQ(notes.size(), 1U);
  expect_note(notes[0], "link", "length", {"20 % too short"});
  description.links[0].properties.stiffness = 100.0;
  EXPECT_TRUE(notes_of(description).empty()) << "a spring may start stretched";
}

TEST(Notes, TellOfAllLinksOfAChainAtOnce) {
  const std::vector<Problem> notes = notes_of(chain_of_ten(1.6, {"first"}));
  ASSERT_EQ(notes.size(), 1U);
  expect_note(notes[0], "chain", "length", {"10 of 10 links", "25 % too long"});
}

TEST(Notes, SayThatAChainBetweenPinsHasNoSlack) {
  const std::vector<Problem> notes = notes_of(chain_of_ten(0.0, {"first", "last"}));
  ASSERT_EQ(notes.size(), 1U);
  expect_note(notes[0], "chain", "",
              {"pin \"rope.0\" to pin \"rope.10\"", "exactly as long", "2 m", "no finite tension"});
}

TEST(Notes, SayThatAChainIsTooShortForItsPins) {
  const std::vector<Problem> notes = notes_of(chain_of_ten(1.6, {"first", "last"}));
  ASSERT_EQ(notes.size(), 2U) << "its links are also stretched at the start";
  expect_note(notes[1], "chain", "", {"1.6 m long together", "2 m apart", "no shape"});
}

// The way from pin to pin leads over three entries, and the sheet's upper edge is another one.
TEST(Notes, FollowRigidLinksFromPinToPin) {
  Description description = chain_of_ten(0.0, {"first"});
  MassSpec hook;
  hook.name = "hook";
  hook.position = {3.0, 0.0, 0.0};
  hook.pinned = true;
  description.masses = {hook};
  description.links = {LinkSpec{"rope.10", "hook", std::nullopt, {}}};
  std::vector<Problem> notes = notes_of(description);
  ASSERT_EQ(notes.size(), 1U);
  expect_note(notes[0], "chain", "", {"pin \"rope.0\" to pin \"hook\"", "3 m"});
  description.links[0].properties.stiffness = 100.0;
  EXPECT_TRUE(notes_of(description).empty()) << "a spring gives way";

  Description net;
  SheetSpec sheet;
  sheet.name = "net";
  sheet.rows = sheet.columns = 5;
  sheet.to = {1.0, 0.0, 0.0};
  sheet.down = {0.0, 0.0, 1.0};
  sheet.pinned = {"top-left", "top-right"};
  net.sheets = {sheet};
  notes = notes_of(net);
  ASSERT_EQ(notes.size(), 1U);
  expect_note(notes[0], "sheet", "", {"pin \"net.0.0\" to pin \"net.0.4\"", "1 m"});
  net.sheets[0].pinned = {"top"};
  EXPECT_TRUE(notes_of(net).empty()) << "links between two pins leave the solve";
}

TEST(Notes, SayThatARigidLinkBreaksByAMethodsErrorOnly) {
  Description description = chain_of_ten(0.0, {"first"});
  description.chains[0].properties.break_stretch = 1.1;
  const std::vector<Problem> notes = notes_of(description);
  ASSERT_EQ(notes.size(), 1U);
  expect_note(notes[0], "chain", "break_stretch", {"without stiffness", "break_tension"});
  description.chains[0].properties.stiffness = 100.0;
  EXPECT_TRUE(notes_of(description).empty());
  description.chains[0].properties = {};
  description.chains[0].properties.break_tension = 10.0;
  EXPECT_TRUE(notes_of(description).empty());
}

TEST(Notes, OfASceneNameTheirPlace) {
  const Scene scene = parse_scene(
      "[[chain]]\nname = \"rope\"\nfrom = [0, 0, 0]\nto = [2, 0, 0]\nlinks = 4\nlength = 1.9\nbreak_stretch "
      "= 1.2\n",
      "f.toml");
  ASSERT_EQ(scene.notes.size(), 2U);
  EXPECT_EQ(scene.notes[0].substr(0, 34), "f.toml:6:1: note: 4 of 4 links are") << scene.notes[0];
  EXPECT_EQ(scene.notes[1].substr(0, 32), "f.toml:7:1: note: break_stretch ") << scene.notes[1];
}

TEST(Air, IsThereWhereTheSceneHasASectionForIt) {
  const std::string rope = "[[chain]]\nname = \"rope\"\nfrom = [0, 0, 0]\nto = [2, 0, 0]\n";
  EXPECT_FALSE(parse_scene(rope, "f.toml").model.wind.has_value());
  EXPECT_FALSE(parse_scene(rope + "[wind]\ndensity = 0\n", "f.toml").model.wind.has_value());
  const Scene still = parse_scene(rope + "[wind]\nvelocity = [0, 0, 0]\n", "f.toml");
  EXPECT_TRUE(still.model.wind.has_value());
  EXPECT_TRUE(parse_scene(resolved_toml(still), "f.toml").model.wind.has_value());
  EXPECT_FALSE(parse_scene(resolved_toml(parse_scene(rope, "f.toml")), "f.toml").model.wind.has_value());
}

}  // namespace
}  // namespace taut
