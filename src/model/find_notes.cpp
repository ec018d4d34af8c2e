#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "builder.h"
#include "model/ways_from_pins.h"

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
        {std::string(entry.section), entry.index,
         entry.section == "sheet" || entry.section == "mesh" ? "" : "length",
         fmt::format(
             "{} not as long at the start as a rigid link must be: from {} it is {:.6g} m in place of "
             "{:.6g} m ({} too {}); some methods snap it to its length in the first step, others fail",
             many, which, link_distance(model_, start_.position, worst), model_.links.length[worst],
             percent(std::abs(strain(worst))), strain(worst) > 0.0 ? "long" : "short"),
         ""});
  }

 private:
  bool solved(Index link) const {
    return model_.links.rigid(link) && !model_.links.one_sided(link) &&
           !(model_.masses.pinned(model_.links.a[link]) && model_.masses.pinned(model_.links.b[link]));
  }
  double strain(Index link) const {
    return link_distance(model_, start_.position, link) / model_.links.length[link] - 1.0;
  }

  const Model& model_;
  const State& start_;
};

// A note on the tautest way from pin to pin that has no slack, if there is one.
void find_taut_way(const Builder& builder, std::vector<Problem>& notes) {
  const Model& model = builder.model;
  if (std::ranges::count(model.masses.inverse_mass, 0.0) < 2) return;
  double least = 1.0 + 1e-9;  // length over distance; beyond it there is slack
  WaysFromPins::Way tautest;
  WaysFromPins(model, [&](Index link) {
    return model.links.rigid(link) && !model.links.one_sided(link);
  }).visit_closed([&](const WaysFromPins::Way& way) {
    const double apart = (builder.start.position.at(way.from) - builder.start.position.at(way.to)).norm();
    if (!(apart > 0.0) || !(way.length / apart < least)) return;
    least = way.length / apart;
    tautest = way;
  });
  if (tautest.length == 0.0) return;
  const Builder::Entry& entry = builder.entry_of(tautest.link);
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
  for (std::size_t i = 0; i < description.meshes.size(); ++i) {
    const MeshSpec& mesh = description.meshes[i];
    note_break_stretch(mesh.properties, "mesh", i, "", notes);
    if (mesh.diagonals) note_break_stretch(*mesh.diagonals, "mesh", i, "diagonals.", notes);
    if (mesh.skip_one) note_break_stretch(*mesh.skip_one, "mesh", i, "skip_one.", notes);
  }
  for (std::size_t i = 0; i < description.points.size(); ++i)
    note_break_stretch(description.points[i].properties, "points", i, "", notes);
  for (std::size_t i = 0; i < description.links.size(); ++i)
    note_break_stretch(description.links[i].properties, "link", i, "", notes);
  for (std::size_t i = 0; i < description.ties.size(); ++i)
    note_break_stretch(description.ties[i].properties, "tie", i, "", notes);
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
