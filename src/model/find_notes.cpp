#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>

#include "builder.h"

namespace taut {
namespace {

constexpr double alike = 1e-6;  // of a length: what seven written digits tell apart

std::string percent(double share) {
  return fmt::format("{:.2g} %", 100.0 * share);
}

// Rigid links with a free end that don't start with their length, a note an entry.
class WrongLengths {
 public:
  explicit WrongLengths(const Builder& builder) : model_(builder.model), start_(builder.start) {}

  void look(const Builder::Entry& entry, Index end, std::vector<Problem>& notes) const {
    Index wrong = 0, worst = no_link;
    for (Index link = entry.first_link; link < end; ++link) {
      if (!solved(link) || !(std::abs(strain(link)) > alike)) continue;
      ++wrong;
      if (worst == no_link || std::abs(strain(link)) > std::abs(strain(worst))) worst = link;
    }
    if (wrong == 0) return;
    const Index all = end - entry.first_link;
    const std::string many =
        all == 1 ? std::string("the link is") : fmt::format("{} of {} links are", wrong, all);
    const std::string which = fmt::format("\"{}\" to \"{}\"", model_.masses.name[model_.links.a[worst]],
                                          model_.masses.name[model_.links.b[worst]]);
    notes.push_back(
        {std::string(entry.section), entry.index, entry.section == "sheet" ? "" : "length",
         fmt::format(
             "{} not as long at the start as a rigid link must be: from {} it is {:.6g} m in place of "
             "{:.6g} m ({} too {}); some methods snap it to its length in the first step, others fail",
             many, which, link_distance(model_, start_.position, worst), model_.links.length[worst],
             percent(std::abs(strain(worst))), strain(worst) > 0.0 ? "long" : "short"),
         ""});
  }

 private:
  bool solved(Index link) const {
    return model_.links.rigid(link) &&
           !(model_.masses.pinned(model_.links.a[link]) && model_.masses.pinned(model_.links.b[link]));
  }
  double strain(Index link) const {
    return link_distance(model_, start_.position, link) / model_.links.length[link] - 1.0;
  }

  const Model& model_;
  const State& start_;
};

// The ways along rigid links through free masses from each mass to the pin that is nearest that way (Dijkstra
// from all pins at once), and so the shortest ways from pin to pin that a link closes.
class WaysFromPins {
 public:
  explicit WaysFromPins(const Model& model)
      : model_(model),
        first_(model.masses.size() + 1, 0),
        way_(model.masses.size(), infinity),
        pin_(model.masses.size(), no_mass) {
    list_neighbours();
    walk();
  }

  struct Way {
    Index from = 0, to = 0;  // pins
    Index link = 0;          // one of those that it takes
    double length = 0.0;     // m
  };

  // Calls visit(way) with every way that a link closes.
  template <class Visit>
  void visit_closed(const Visit& visit) const {
    for (Index link = 0; link < model_.links.size(); ++link) {
      const Index a = model_.links.a[link], b = model_.links.b[link];
      if (!model_.links.rigid(link) || (model_.masses.pinned(a) && model_.masses.pinned(b))) continue;
      if (pin_[a] == no_mass || pin_[b] == no_mass || pin_[a] == pin_[b]) continue;
      visit(Way{std::min(pin_[a], pin_[b]), std::max(pin_[a], pin_[b]), link,
                way_[a] + model_.links.length[link] + way_[b]});
    }
  }

 private:
  static constexpr Index no_mass = std::numeric_limits<Index>::max();

  // Rigid links mass by mass, as stretches of one list.
  void list_neighbours() {
    const Links& links = model_.links;
    for (Index link = 0; link < links.size(); ++link)
      if (links.rigid(link)) {
        ++first_[links.a[link] + 1];
        ++first_[links.b[link] + 1];
      }
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    links_at_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (Index link = 0; link < links.size(); ++link)
      if (links.rigid(link)) {
        links_at_[next[links.a[link]]++] = link;
        links_at_[next[links.b[link]]++] = link;
      }
  }

  void walk() {
    using Reached = std::pair<double, Index>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> open;
    for (Index mass = 0; mass < model_.masses.size(); ++mass)
      if (model_.masses.pinned(mass)) {
        way_[mass] = 0.0;
        pin_[mass] = mass;
        open.emplace(0.0, mass);
      }
    while (!open.empty()) {
      const auto [way, mass] = open.top();
      open.pop();
      if (way > way_[mass]) continue;
      for (std::size_t k = first_[mass]; k < first_[mass + 1]; ++k) {
        const Index link = links_at_[k];
        const Index other = model_.links.a[link] == mass ? model_.links.b[link] : model_.links.a[link];
        const double longer = way + model_.links.length[link];
        if (!(longer < way_[other])) continue;
        way_[other] = longer;
        pin_[other] = pin_[mass];
        open.emplace(longer, other);
      }
    }
  }

  const Model& model_;
  std::vector<std::size_t> first_;  // where each mass's stretch of links_at_ begins
  std::vector<Index> links_at_;
  std::vector<double> way_;  // m, from the nearest pin; infinity where no rigid links lead to one
  std::vector<Index> pin_;   // which pin that is
};

// The entry that a link comes from.
const Builder::Entry& entry_of(const Builder& builder, Index link) {
  const auto after =
      std::upper_bound(builder.entries.begin(), builder.entries.end(), link,
                       [](Index at, const Builder::Entry& entry) { return at < entry.first_link; });
  return *std::prev(after);
}

// A note on the tautest way from pin to pin that has no slack, if there is one.
void find_taut_way(const Builder& builder, std::vector<Problem>& notes) {
  const Model& model = builder.model;
  if (std::ranges::count(model.masses.inverse_mass, 0.0) < 2) return;
  double least = 1.0 + 1e-9;  // length over distance; beyond it there is slack
  WaysFromPins::Way tautest;
  WaysFromPins(model).visit_closed([&](const WaysFromPins::Way& way) {
    const double apart = (builder.start.position.at(way.from) - builder.start.position.at(way.to)).norm();
    if (!(apart > 0.0) || !(way.length / apart < least)) return;
    least = way.length / apart;
    tautest = way;
  });
  if (tautest.length == 0.0) return;
  const Builder::Entry& entry = entry_of(builder, tautest.link);
  const std::string which = fmt::format("the rigid links from pin \"{}\" to pin \"{}\"",
                                        model.masses.name[tautest.from], model.masses.name[tautest.to]);
  const double apart = tautest.length / least;
  notes.push_back(
      {std::string(entry.section), entry.index, "",
       least < 1.0 - alike
           ? fmt::format("{} are {:.6g} m long together, and the pins are {:.6g} m apart: no shape has these "
                         "lengths, so some methods fail and others leave the links stretched",
                         which, tautest.length, apart)
           : fmt::format(
                 "{} are exactly as long together as the pins are apart, {:.6g} m: they can't give way "
                 "sideways, and no finite tension carries a weight, so methods that solve all links "
                 "together fail and others leave them stretched; let them be longer, or give them "
                 "stiffness",
                 which, apart),
       ""});
}

// Rigid links stretch only by what a method leaves undone.
void note_break_stretch(const LinkProperties& properties, std::string_view section, std::size_t index,
                        const std::string& prefix, std::vector<Problem>& notes) {
  if (properties.stiffness || !properties.break_stretch) return;
  notes.push_back(
      {std::string(section), index, prefix + "break_stretch",
       "break_stretch without stiffness: a rigid link stretches only by what a method leaves undone, "
       "so it breaks by the method's error or not at all; break_tension is what breaks a rigid link, "
       "or give it stiffness",
       ""});
}

void find_break_stretch(const Description& description, std::vector<Problem>& notes) {
  for (std::size_t i = 0; i < description.chains.size(); ++i)
    note_break_stretch(description.chains[i].properties, "chain", i, "", notes);
  for (std::size_t i = 0; i < description.sheets.size(); ++i) {
    const SheetSpec& sheet = description.sheets[i];
    note_break_stretch(sheet.properties, "sheet", i, "", notes);
    if (sheet.diagonals) note_break_stretch(*sheet.diagonals, "sheet", i, "diagonals.", notes);
    if (sheet.skip_one) note_break_stretch(*sheet.skip_one, "sheet", i, "skip_one.", notes);
  }
  for (std::size_t i = 0; i < description.links.size(); ++i)
    note_break_stretch(description.links[i].properties, "link", i, "", notes);
}

}  // namespace

std::vector<Problem> find_notes(const Description& description, const Builder& builder) {
  constexpr std::size_t most = 20;  // entries told of links that start wrong
  std::vector<Problem> notes;
  const WrongLengths wrong(builder);
  for (std::size_t i = 0; i < builder.entries.size() && notes.size() < most; ++i) {
    const Index end = i + 1 < builder.entries.size() ? builder.entries[i + 1].first_link
                                                     : static_cast<Index>(builder.model.links.size());
    wrong.look(builder.entries[i], end, notes);
  }
  find_taut_way(builder, notes);
  find_break_stretch(description, notes);
  return notes;
}

}  // namespace taut
