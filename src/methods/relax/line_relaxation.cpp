#include "relax/line_relaxation.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <map>

#include "relax/visit_parts.h"

namespace taut {
namespace {

// By what share of itself the diagonal of a line between two pins is larger, divided by its links.
constexpr double pinned_share = 1e-3;

std::uint32_t offset_of(std::size_t place) {
  return static_cast<std::uint32_t>(place * bytes_between<double>(Layout::packed));
}

// What a line has, so that rigid ones pay for no more.
std::size_t softness_of(const Model& model, std::span<const Index> links) {
  std::size_t softness = 0;
  for (const Index link : links)
    if (!model.links.rigid(link))
      softness = std::max<std::size_t>(softness, model.links.damping[link] > 0.0 ? 2 : 1);
  return softness;
}

}  // namespace

LineRelaxation::LineRelaxation(const Model& model, const Execution& execution)
    : model_(model), workers_(execution.workers) {}

void LineRelaxation::links_changed(const State& state) {
  links_.clear();
  for (const Index link : solvable_links(model_))
    if (!state.broken(link)) links_.push_back(link);
  // Where masses lie matters to the caches alone: breaks need not change it.
  places_.give_places(model_,
                      places_.masses.empty() ? mass_order(model_, links_) : std::vector(places_.masses));
  parts_ = threads_for(workers_.get(), links_.size());
  scratch_.resize(parts_);
  groups_.clear();
  begin_.clear();
  mass_.clear();
  stiffening_.clear();
  visited_.clear();
  special_slot_.clear();
  place_offset_.clear();
  const LinkLines lines = lines_of(model_, links_);
  std::vector<std::vector<LinkLine>> by_colour(lines.colours);
  for (const LinkLine& line : lines.lines) by_colour[line.colour].push_back(line);
  for (const std::vector<LinkLine>& of_colour : by_colour) add_colour(lines, of_colour);
  slot_.assign(model_.links.size(), 0);
  length_.assign(visited_.size(), 0.0);
  for (std::size_t slot = 0; slot < visited_.size(); ++slot)
    if (visited_[slot] != no_link) {
      slot_[visited_[slot]] = slot;
      length_[slot] = model_.links.length[visited_[slot]];
    }
  multiplier_.assign(visited_.size(), 0.0);
  move_.assign(visited_.size(), 0.0);
  diagonal_.assign(visited_.size(), 1.0);
  for (auto* values : {&scaled_, &gamma_}) values->assign(special_slot_.size(), 0.0);
  damped_.assign(special_slot_.size(), 1.0);
  settled_h_ = settled_answer_ = 0.0;
}

// Lanes as long as the longest line are filled from the longest line to the shortest, each where it leaves
// the least room. Lines of equal lengths stay in their order: those side by side in a sheet lie side by side
// here.
void LineRelaxation::add_colour(const LinkLines& lines, const std::vector<LinkLine>& of_colour) {
  const std::size_t first_group = groups_.size();
  std::array<std::vector<LinkLine>, 3> kinds;
  for (const LinkLine& line : of_colour) kinds[softness_of(model_, lines.links_of(line))].push_back(line);
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    std::ranges::stable_sort(kinds[kind], std::ranges::greater(), &LinkLine::count);
    std::vector<Lane> lanes;
    std::multimap<std::size_t, std::size_t> by_room;
    for (const LinkLine& line : kinds[kind]) {
      const std::size_t rows = line.count + 1, most = kinds[kind].front().count + 1;
      const auto found = by_room.lower_bound(rows);
      const std::size_t lane = found == by_room.end() ? lanes.size() : found->second;
      if (found == by_room.end())
        lanes.emplace_back();
      else
        by_room.erase(found);
      lanes[lane].lines.push_back(line);
      lanes[lane].rows += rows;
      if (lanes[lane].rows < most) by_room.emplace(most - lanes[lane].rows, lane);
    }
    LineGroup group;
    group.soft = kind >= 1;
    group.damped = kind >= 2;
    for (std::size_t lane = 0; lane < lanes.size(); lane += lines_at_once)
      add_group(lines, std::span(lanes).subspan(lane, std::min(lines_at_once, lanes.size() - lane)), group);
  }
  share_out(first_group);
}

void LineRelaxation::add_group(const LinkLines& lines, std::span<const Lane> lanes, LineGroup group) {
  group.begin = mass_.size();
  group.rows = std::ranges::max(lanes, {}, &Lane::rows).rows;
  group.special = special_slot_.size();
  const std::size_t end = group.begin + lines_at_once * group.rows;
  mass_.resize(end, empty_place);
  stiffening_.resize(end, 1.0);
  visited_.resize(end, no_link);
  // Filled up with a mass of the group's own that has no links.
  place_offset_.resize(end, offset_of(places_.places++));
  for (std::size_t lane = 0; lane < lanes.size(); ++lane) add_lane(lines, lanes[lane], group.begin + lane);
  if (group.soft)
    for (std::size_t slot = group.begin; slot < end; ++slot) special_slot_.push_back(slot);
  groups_.push_back(group);
}

void LineRelaxation::add_lane(const LinkLines& lines, const Lane& lane, std::size_t slot) {
  for (const LinkLine& line : lane.lines) {
    const std::span<const Index> links = lines.links_of(line), masses = lines.masses_of(line);
    const bool between_pins = model_.masses.pinned(masses.front()) && model_.masses.pinned(masses.back());
    const double stiffening =
        between_pins && links.size() > 1 ? 1.0 + pinned_share / static_cast<double>(links.size()) : 1.0;
    for (std::size_t i = 0; i < masses.size(); ++i) {
      mass_[slot] = masses[i];
      place_offset_[slot] = offset_of(places_.place_of(model_, masses[i]));
      if (i < links.size()) visited_[slot] = links[i];
      stiffening_[slot] = stiffening;
      slot += lines_at_once;
    }
  }
}

// Shares the groups of a colour out among the parts, each about as many rows.
void LineRelaxation::share_out(std::size_t first_group) {
  std::size_t all = 0, so_far = 0;
  for (std::size_t i = first_group; i < groups_.size(); ++i) all += groups_[i].rows;
  std::vector<std::size_t> begin{first_group};
  for (std::size_t i = first_group; i < groups_.size(); ++i) {
    while (begin.size() < parts_ && 2 * so_far * parts_ + groups_[i].rows * parts_ > 2 * all * begin.size())
      begin.push_back(i);
    std::vector<double>& scratch = scratch_[begin.size() - 1];
    scratch.resize(std::max(scratch.size(), line_scratch(groups_[i].rows)));
    so_far += groups_[i].rows;
  }
  begin.resize(parts_ + 1, groups_.size());
  begin_.push_back(std::move(begin));
}

void LineRelaxation::begin_step(double h, double answer) {
  if (h == settled_h_ && answer == settled_answer_) return;
  settled_h_ = h;
  settled_answer_ = answer;
  for (std::size_t slot = 0; slot < mass_.size(); ++slot)
    if (mass_[slot] != empty_place) move_[slot] = answer * model_.masses.inverse_mass[mass_[slot]];
  for (std::size_t slot = 0; slot < visited_.size(); ++slot)
    if (visited_[slot] != no_link)
      diagonal_[slot] = (move_[slot] + move_[slot + lines_at_once]) * stiffening_[slot];
  settle_special(h);
}

void LineRelaxation::settle_special(double h) {
  for (std::size_t i = 0; i < special_slot_.size(); ++i) {
    const std::size_t slot = special_slot_[i];
    if (visited_[slot] == no_link) continue;
    const double compliance = model_.links.compliance(visited_[slot]);
    scaled_[i] = compliance / (h * h);
    gamma_[i] = compliance * model_.links.damping[visited_[slot]] / h;
    damped_[i] = 1.0 / (1.0 + gamma_[i]);
    diagonal_[slot] += scaled_[i] * damped_[i] * stiffening_[slot];
  }
}

std::span<const LineGroup> LineRelaxation::groups_of(std::size_t colour, std::size_t part) const {
  const std::vector<std::size_t>& begin = begin_[colour];
  return std::span(groups_).subspan(begin[part], begin[part + 1] - begin[part]);
}

template <class Task>
void LineRelaxation::for_each_part(const Task& task) {
  if (parts_ == 1) return task(std::size_t{0});
  workers_->run([&](int part) { task(static_cast<std::size_t>(part)); });
}

bool LineRelaxation::pass(const Masses& start, Masses& position, PassPlace place,
                          const FreeMotion<double>* motion) {
  if (motion != nullptr)
    for_each_part([&](std::size_t part) {
      const std::size_t begin = places_.masses.size() * part / parts_,
                        end = places_.masses.size() * (part + 1) / parts_;
      relax_along_present<double>(Layout::packed, {}, {}, start.read(), motion, {begin, end, 0, 0},
                                  {true, false}, position.view());
    });
  const LineArrays lines{place_offset_.data(), move_.data(),   length_.data(), diagonal_.data(),
                         multiplier_.data(),   scaled_.data(), gamma_.data(),  damped_.data()};
  for (std::size_t colour = 0; colour < begin_.size(); ++colour)
    for_each_part([&](std::size_t part) {
      relax_lines(lines, groups_of(colour, part), start.read(), place.first, scratch_[part].data(),
                  position.view());
    });
  return !place.last || are_all_finite(position);
}

bool LineRelaxation::are_all_finite(const Masses& position) {
  std::atomic<bool> finite{true};
  for_each_part([&](std::size_t part) {
    const std::size_t begin = places_.masses.size() * part / parts_,
                      end = places_.masses.size() * (part + 1) / parts_;
    if (!are_finite<double>(Layout::packed, position.read(), begin, end)) finite.store(false);
  });
  return finite.load();
}

void LineRelaxation::give_multipliers(double scale, std::vector<double>& values) const {
  for (std::size_t slot = 0; slot < visited_.size(); ++slot)
    if (visited_[slot] != no_link) values[visited_[slot]] = multiplier_[slot] * scale;
}

}  // namespace taut
