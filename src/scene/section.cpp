#include "section.h"

namespace taut {

std::vector<Section> all_sections() {
  std::vector<Section> sections{title_section(), world_section(), solve_section()};
  for (Section& section : physics_sections()) sections.push_back(std::move(section));
  for (Section& section : view_sections()) sections.push_back(std::move(section));
  return sections;
}

}  // namespace taut
