// How masses have turned, from the directions of their links.

#include "model/orientation.h"

#include "physics/fixtures.h"

namespace taut::test {
namespace {

// A hub with three spokes that are not in one plane, and one mass without links.
Built hub() {
  Description description;
  const std::vector<Vec3> places{
      {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, {0.3, 0.2, 0.5}, {5.0, 0.0, 0.0}};
  for (std::size_t i = 0; i < places.size(); ++i) {
    MassSpec mass;
    mass.name = "m" + std::to_string(i);
    mass.position = places[i];
    description.masses.push_back(mass);
  }
  for (const char* end : {"m1", "m2", "m3"})
    description.links.push_back(LinkSpec{"m0", end, std::nullopt, {}});
  return build_valid(description);
}

State turned_by(const Built& built, const Eigen::Quaterniond& turn) {
  State state = built.start;
  for (std::size_t i = 0; i < state.position.size(); ++i)
    state.position.set(i, turn * state.position.at(i) + Vec3(1.0, -2.0, 0.5));
  return state;
}

double angle_between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  return a.angularDistance(b);
}

TEST(Orientation, NothingHasTurnedAtTheStart) {
  const Built built = hub();
  for (const Eigen::Quaterniond& turn : orientations(built.model, built.start, built.start))
    EXPECT_LT(angle_between(turn, Eigen::Quaterniond::Identity()), 1e-12);
}

TEST(Orientation, OfAMassWithThreeLinksIsTheBodysOwnTurn) {
  const Built built = hub();
  for (const double angle : {0.1, 1.0, 2.5, 3.1}) {
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(angle, Vec3(0.3, -1.0, 0.5).normalized()));
    const auto turns = orientations(built.model, built.start, turned_by(built, turn));
    EXPECT_LT(angle_between(turns[0], turn), 1e-7) << angle << " rad";
    for (const Eigen::Quaterniond& each : turns) EXPECT_NEAR(each.norm(), 1.0, 1e-12);
  }
}

TEST(Orientation, OfAMassWithOneLinkIsTheShortestTurnOfThatLink) {
  const Built built = hub();
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(1.2, Vec3::UnitZ()));
  const auto turns = orientations(built.model, built.start, turned_by(built, turn));
  EXPECT_LT(angle_between(turns[1], turn), 1e-7) << "the link along x turns about z";
  const Eigen::Quaterniond twist(Eigen::AngleAxisd(1.2, Vec3::UnitX()));
  EXPECT_LT(angle_between(orientations(built.model, built.start, turned_by(built, twist))[1],
                          Eigen::Quaterniond::Identity()),
            1e-7)
      << "a twist about itself shows in no direction";
}

TEST(Orientation, BrokenLinksAndMassesWithoutLinksSayNothing) {
  const Built built = hub();
  State state = turned_by(built, Eigen::Quaterniond(Eigen::AngleAxisd(1.2, Vec3::UnitZ())));
  state.broken_at[0] = 0.5;
  const auto turns = orientations(built.model, built.start, state);
  EXPECT_LT(angle_between(turns[1], Eigen::Quaterniond::Identity()), 1e-12);
  EXPECT_LT(angle_between(turns[4], Eigen::Quaterniond::Identity()), 1e-12);
}

// Of two links that turn by unlike angles about one axis, a mass has the mean.
TEST(Orientation, IsTheMeanOfLinksThatDisagree) {
  Description description = level_chain(2, 1.0);
  const Built built = build_valid(description);
  State state = built.start;
  state.position.set(0, state.position.at(1) - Vec3(std::cos(0.2), std::sin(0.2), 0.0));
  state.position.set(2, state.position.at(1) + Vec3(std::cos(0.8), std::sin(0.8), 0.0));
  const auto turns = orientations(built.model, built.start, state);
  EXPECT_LT(angle_between(turns[1], Eigen::Quaterniond(Eigen::AngleAxisd(0.5, Vec3::UnitZ()))), 1e-7);
}

}  // namespace
}  // namespace taut::test
