// Which links of the breaking cloth go first, and when: by two kinds of method that locate breaks in their
// own ways.

#include <algorithm>
#include <vector>

#include "fixtures.h"
#include "model/measures.h"
#include "motion/run.h"
#include "scenes_of_the_program.h"

namespace taut::test {
namespace {

constexpr std::size_t first_ones = 10;

struct Break {
  double time;  // s
  std::size_t link;

  auto operator<=>(const Break&) const = default;
};

std::vector<Break> first_breaks(const Model& model, const State& start, const Settings& settings) {
  taut::Run run(model, start, settings);
  while (run.state().time < 4.0 && broken_links(run.state()) < first_ones && run.step()) {
  }
  EXPECT_EQ(run.failure(), "");
  std::vector<Break> breaks;
  for (std::size_t link = 0; link < model.links.size(); ++link)
    if (run.state().broken(link)) breaks.push_back({run.state().broken_at[link], link});
  std::ranges::sort(breaks);
  breaks.resize(std::min(breaks.size(), first_ones));
  return breaks;
}

// Its pieces come to the ground later, so the ground, which dop853 does not know, makes no difference. From
// one break to the next what is left of a method's error grows: rattle is of second order, and at four times
// the rate it is within 1.1e-6 s.
TEST(Tear, TwoKindsOfMethodAgreeOnTheFirstTenBreaks) {
  const Scene scene = scene_called("breaking-cloth");
  Model model = scene.model;
  model.colliders.clear();
  model.contacts.clear();
  const auto by_order_8 =
      first_breaks(model, scene.start, complete_settings({"dop853", {{"tolerance", 1e-7}}}));
  const auto by_order_2 = first_breaks(model, scene.start, settings("rattle", 3600.0));
  ASSERT_EQ(by_order_8.size(), first_ones);
  ASSERT_EQ(by_order_2.size(), first_ones);
  for (std::size_t i = 0; i < first_ones; ++i) {
    EXPECT_EQ(by_order_8[i].link, by_order_2[i].link) << i;
    EXPECT_NEAR(by_order_8[i].time, by_order_2[i].time, 3e-5) << i;
  }
}

}  // namespace
}  // namespace taut::test
