#include "section.h"

namespace taut {

std::vector<Section> all_sections() {
  std::vector<Section> sections{title_section(), world_section(), solve_section()};
  for (auto* part : {physics_sections, file_sections, body_sections, surroundings_sections, view_sections})
    for (Section& section : part()) sections.push_back(std::move(section));
  return sections;
}

}  // namespace taut
