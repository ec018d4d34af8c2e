#include "stability/hard_cases.h"

#include <cmath>

#include "physics/fixtures.h"

namespace taut::test {
namespace {

std::string with_number(const std::string& name, double number) {
  return name + " " + std::to_string(static_cast<long>(std::lround(std::log10(number))));
}

// Pin, then n free masses in a row, each joined to the one before by a rigid link of the given length.
Description row_of_masses(int count, double distance, double length) {
  Description description;
  for (int i = 0; i <= count; ++i) {
    MassSpec mass;
    mass.name = "m" + std::to_string(i);
    mass.position = {distance * i, 0.0, 0.0};
    mass.pinned = i == 0;
    description.masses.push_back(mass);
    if (i > 0) description.links.push_back({"m" + std::to_string(i - 1), mass.name, length, {}});
  }
  return description;
}

void add_heavy_tips(std::vector<HardCase>& cases) {
  for (const double ratio : {1.0, 1e2, 1e5}) {
    HardCase hard{with_number("heavy tip, ten to the", ratio), level_chain(20, 0.1)};
    hard.description.chains[0].last_mass = ratio;
    cases.push_back(hard);
  }
}

void add_two_pins(std::vector<HardCase>& cases) {
  HardCase taut_chain{"both ends pinned, straight and taut", level_chain(20, 0.1)};
  taut_chain.description.chains[0].pinned = {"first", "last"};
  cases.push_back(taut_chain);

  HardCase apart{"pins farther apart than the chain", level_chain(20, 0.1)};
  apart.description.chains[0].pinned = {"first", "last"};
  apart.description.chains[0].length = 1.0;
  cases.push_back(apart);
}

void add_sheets(std::vector<HardCase>& cases) {
  HardCase hard;
  hard.name = "rigid diagonals everywhere";
  SheetSpec sheet;
  sheet.name = "sheet";
  sheet.rows = sheet.columns = 6;
  sheet.to = {1.0, 0.0, 0.0};
  sheet.down = {0.0, 0.0, 1.0};
  sheet.pinned = {"top"};
  sheet.diagonals = LinkProperties{};
  hard.description.sheets = {sheet};
  cases.push_back(hard);
}

void add_short_link(std::vector<HardCase>& cases) {
  HardCase short_link{"one link of a nanometre", row_of_masses(4, 0.1, 0.1)};
  short_link.description.masses[3].position = short_link.description.masses[2].position + Vec3(1e-9, 0, 0);
  short_link.description.masses[4].position = short_link.description.masses[3].position + Vec3(0.1, 0, 0);
  short_link.description.links[2].length = 1e-9;
  cases.push_back(short_link);
}

// Masses that come to lie on each other: the far end of two links thrown through the pin, and a pin driven
// through another pin and through a mass that hangs from it.
void add_meetings(std::vector<HardCase>& cases) {
  HardCase through{"a mass thrown through its pin", row_of_masses(2, 0.5, 0.5)};
  through.description.masses[1].position = {0.0, -0.5, 0.0};
  through.description.masses[2].position = {0.5, -0.5, 0.0};
  through.description.masses[2].velocity = {0.0, 4.0, 0.0};
  cases.push_back(through);

  HardCase pins{"a pin driven through another", level_chain(10, 0.1)};
  pins.description.chains[0].pinned = {"first", "last"};
  pins.description.chains[0].last_motion.path = {
      {0.0, {1.0, 0.0, 0.0}}, {0.25, {0.0, 0.0, 0.0}}, {0.5, {-1.0, 0.0, 0.0}}};
  cases.push_back(pins);
}

void add_compression(std::vector<HardCase>& cases) {
  HardCase upright{"straight chain standing on its pin", level_chain(10, 0.1)};
  upright.description.chains[0].to = {0.0, 1.0, 0.0};
  cases.push_back(upright);

  HardCase pressed{"straight chain pressed between pins", row_of_masses(10, 0.05, 0.1)};
  pressed.description.masses.back().pinned = true;
  cases.push_back(pressed);
}

void add_cascade(std::vector<HardCase>& cases) {
  for (const bool by_tension : {false, true}) {
    HardCase hard{by_tension ? "cascade of breaks by tension" : "cascade of breaks by stretch",
                  level_chain(20, 0.1)};
    ChainSpec& chain = hard.description.chains[0];
    chain.last_mass = 1000.0;
    (by_tension ? chain.properties.break_tension : chain.properties.break_stretch) =
        by_tension ? 100.0 : 1.01;
    cases.push_back(hard);
  }
}

void add_steps(std::vector<HardCase>& cases) {
  for (const double h : {1e-6, 1e-4, 1e-2, 1e-1}) {
    HardCase hard{with_number("step, s, ten to the", h), level_chain(10, 0.1)};
    hard.duration = std::min(200.0 * h, 5.0);
    hard.rates = {1.0 / h};
    cases.push_back(hard);
  }
}

void add_scales(std::vector<HardCase>& cases) {
  for (const double mass : {1e-9, 1e9}) {
    HardCase hard{with_number("masses, kg, ten to the", mass), level_chain(10, 0.1)};
    hard.description.chains[0].mass = 11.0 * mass;
    cases.push_back(hard);
  }
  HardCase mixed{"masses from 1e-9 to 1e9 kg in one chain", row_of_masses(18, 0.1, 0.1)};
  mixed.lightest_may_fly = true;  // a billionth of what the heaviest gain in a step is enough for it
  for (int i = 0; i <= 18; ++i)
    mixed.description.masses[static_cast<std::size_t>(i)].mass = std::pow(10.0, (7 * i) % 19 - 9);
  cases.push_back(mixed);

  for (const double length : {1e-6, 1e6})
    cases.push_back({with_number("lengths, m, ten to the", length), level_chain(10, length)});
  HardCase lengths{"lengths from 1e-6 to 1e6 m in one chain", row_of_masses(12, 0.0, 0.1)};
  double reach = 0.0;
  for (std::size_t i = 1; i <= 12; ++i) {
    const double length = std::pow(10.0, static_cast<double>((5 * i) % 13) - 6.0);
    lengths.description.masses[i].position.x() = reach += length;
    lengths.description.links[i - 1].length = length;
  }
  cases.push_back(lengths);
}

void add_fast_pin(std::vector<HardCase>& cases) {
  HardCase hard{"a pin driven faster than the links can follow", level_chain(10, 0.1)};
  hard.description.chains[0].first_motion.sinusoid = SinusoidSpec{{0.0, 0.5, 0.0}, 1000.0, 0.0};
  cases.push_back(hard);
}

}  // namespace

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> cases;
  add_heavy_tips(cases);
  add_two_pins(cases);
  add_sheets(cases);
  add_short_link(cases);
  add_meetings(cases);
  add_compression(cases);
  add_cascade(cases);
  add_steps(cases);
  add_scales(cases);
  add_fast_pin(cases);
  return cases;
}

Description with_springs(Description description, double stiffness) {
  for (ChainSpec& chain : description.chains) chain.properties.stiffness = stiffness;
  for (LinkSpec& link : description.links) link.properties.stiffness = stiffness;
  for (SheetSpec& sheet : description.sheets) {
    sheet.properties.stiffness = stiffness;
    if (sheet.diagonals) sheet.diagonals->stiffness = stiffness;
  }
  return description;
}

}  // namespace taut::test
