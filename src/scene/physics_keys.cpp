#include "physics_facts.h"
#include "section.h"

namespace taut {
namespace {

constexpr std::array<std::string_view, 2> chain_ends{"first", "last"};
constexpr std::array<std::string_view, 8> sheet_edges{"top",      "bottom",    "left",        "right",
                                                      "top-left", "top-right", "bottom-left", "bottom-right"};

constexpr Facts release_facts() {
  return {.unit = "s",
          .range = above_to(0, far),
          .fallback = "never",
          .help = "when what is pinned is let go of"};
}

Keys<ChainSpec> chain_keys() {
  return Keys<ChainSpec>{
             key<ChainSpec>("name", &ChainSpec::name, named("its masses are named name.0, name.1, …")),
             key<ChainSpec>("from", &ChainSpec::from, where("where the first mass is")),
             key<ChainSpec>("to", &ChainSpec::to, where("where the last mass is")),
             key<ChainSpec>("links", &ChainSpec::links,
                            {.range = between(1, 1e8), .help = "how many; there is one mass more"}),
             key<ChainSpec>(
                 "length", &ChainSpec::length,
                 {.unit = "m",
                  .range = zero_or_up_to(far),
                  .help = "of the whole; 0: the distance of its ends. A longer chain starts as an arc "
                          "that sags along gravity, a shorter one starts stretched"}),
             key<ChainSpec>("mass", &ChainSpec::mass,
                            {.unit = "kg",
                             .range = above_to(0, 1e12),
                             .help = "of the whole, shared equally by its masses"}),
             key<ChainSpec>("last_mass", &ChainSpec::last_mass,
                            {.unit = "kg",
                             .range = zero_or_up_to(1e12),
                             .help = "of the last mass alone; 0: the same as the others"}),
             key<ChainSpec>("pinned", &ChainSpec::pinned,
                            {.choices = chain_ends, .help = "the ends that are held"}),
             key<ChainSpec>("first_motion", &ChainSpec::first_motion,
                            {.fallback = "stays", .help = "how the first mass is moved, where it is pinned"}),
             key<ChainSpec>("last_motion", &ChainSpec::last_motion,
                            {.fallback = "stays", .help = "how the last mass is moved, where it is pinned"}),
         } +
         Keys<ChainSpec>{
             key<ChainSpec>("first_release", &ChainSpec::first_release, release_facts()),
             key<ChainSpec>("last_release", &ChainSpec::last_release, release_facts()),
             key<ChainSpec>("bending", &ChainSpec::bending,
                            {.fallback = "none", .help = "how it resists being bent"}),
         } +
         contact_keys<ChainSpec>() + link_property_keys<ChainSpec>(&ChainSpec::properties);
}

Keys<SheetSpec> sheet_keys() {
  return Keys<SheetSpec>{
             key<SheetSpec>("name", &SheetSpec::name,
                            named("its masses are named name.row.column, row 0 on top")),
             key<SheetSpec>("rows", &SheetSpec::rows, {.range = between(2, 1e8), .help = "of masses"}),
             key<SheetSpec>("columns", &SheetSpec::columns, {.range = between(2, 1e8), .help = "of masses"}),
             key<SheetSpec>("from", &SheetSpec::from, where("where the top edge starts: mass name.0.0")),
             key<SheetSpec>("to", &SheetSpec::to, where("where the top edge ends")),
             key<SheetSpec>("down", &SheetSpec::down, where("from the top edge to the bottom one")),
             key<SheetSpec>("mass", &SheetSpec::mass,
                            {.unit = "kg",
                             .range = above_to(0, 1e12),
                             .help = "of the whole, shared equally by its masses"}),
             key<SheetSpec>("fullness", &SheetSpec::fullness,
                            {.range = between(1, 5),
                             .help = "width of the cloth ÷ length of the top edge; what is left over lies in "
                                     "pleats between the hooks"}),
             key<SheetSpec>("hooks", &SheetSpec::hooks,
                            {.help = "pins at every n-th mass of the top edge, as of a curtain on its rail"}),
             key<SheetSpec>("pinned", &SheetSpec::pinned,
                            {.choices = sheet_edges, .help = "the edges and corners that are held"}),
             key<SheetSpec>("release", &SheetSpec::release, release_facts()),
             key<SheetSpec>("bending", &SheetSpec::bending,
                            {.fallback = "none", .help = "how it resists being bent"}),
         } +
         contact_keys<SheetSpec>() + link_property_keys<SheetSpec>(&SheetSpec::properties) +
         Keys<SheetSpec>{
             key<SheetSpec>(
                 "weft", &SheetSpec::weft,
                 {.help = "links along rows with properties of their own, in place of those of the "
                          "sheet; true: rigid ones"}),
             key<SheetSpec>("diagonals", &SheetSpec::diagonals,
                            {.help = "links along both diagonals of every cell; true: rigid ones"}),
             key<SheetSpec>(
                 "skip_one", &SheetSpec::skip_one,
                 {.help = "links from every mass to the next but one along rows and columns; true: "
                          "rigid ones"}),
             key<SheetSpec>(
                 "faces", &SheetSpec::faces,
                 {.fallback = "only masses touch, as balls",
                  .help = "lets its triangles touch: solids, one another, and those of other sheets; a "
                          "scene whose faces start nearer than their thickness is refused"}),
         };
}

Keys<MassSpec> mass_keys() {
  return Keys<MassSpec>{
             key<MassSpec>("name", &MassSpec::name, named("for links, loads and the camera")),
             key<MassSpec>("position", &MassSpec::position, where("at the start")),
             key<MassSpec>("velocity", &MassSpec::velocity,
                           {.unit = "m/s",
                            .range = between(-far, far),
                            .help = "at the start; means nothing where it is pinned"}),
             key<MassSpec>(
                 "mass", &MassSpec::mass,
                 {.unit = "kg", .range = above_to(0, 1e12), .help = "means nothing where it is pinned"}),
             key<MassSpec>("pinned", &MassSpec::pinned, {.help = "whether it is held"}),
             key<MassSpec>("motion", &MassSpec::motion,
                           {.fallback = "stays", .help = "how it is moved, where it is pinned"}),
             key<MassSpec>("release", &MassSpec::release, release_facts()),
         } +
         contact_keys<MassSpec>();
}

Keys<LinkSpec> link_keys() {
  return Keys<LinkSpec>{
             key<LinkSpec>("a", &LinkSpec::a, named("the mass at one end")),
             key<LinkSpec>("b", &LinkSpec::b, named("the mass at the other end")),
             key<LinkSpec>("length", &LinkSpec::length,
                           {.unit = "m",
                            .range = above_to(0, far),
                            .fallback = "the distance at the start",
                            .help = "at which it neither pulls nor pushes"}),
         } +
         link_property_keys<LinkSpec>(&LinkSpec::properties);
}

Keys<LoadSpec> load_keys() {
  return {
      key<LoadSpec>("masses", &LoadSpec::masses,
                    {.required = true, .help = "names; a part between dots may be *, as in cloth.47.*"}),
      key<LoadSpec>(
          "force", &LoadSpec::force,
          {.unit = "N", .range = between(-1e12, 1e12), .required = true, .help = "on each of them"}),
      key<LoadSpec>("from", &LoadSpec::from,
                    {.unit = "s", .range = between(0, far), .help = "when it starts to grow, linearly"}),
      key<LoadSpec>("to", &LoadSpec::to,
                    {.unit = "s", .range = between(0, far), .help = "when it is there in full, to stay"}),
      key<LoadSpec>(
          "until", &LoadSpec::until,
          {.unit = "s", .range = between(0, far), .fallback = "for ever", .help = "until when it stays"}),
      key<LoadSpec>("gone", &LoadSpec::gone,
                    {.unit = "s",
                     .range = between(0, far),
                     .fallback = "until",
                     .help = "when it has fallen away, linearly"}),
  };
}

Keys<SeamSpec> seam_keys() {
  return {
      key<SeamSpec>("sheet", &SeamSpec::sheet, {.help = "the name of the sheet that it lies in"}),
      key<SeamSpec>("row", &SeamSpec::row,
                    {.range = between(0, 1e8),
                     .fallback = "none",
                     .help = "it lies between this row of the sheet and the next"}),
      key<SeamSpec>("column", &SeamSpec::column,
                    {.range = between(0, 1e8),
                     .fallback = "none",
                     .help = "it lies between this column of the sheet and the next"}),
      key<SeamSpec>("a", &SeamSpec::a,
                    {.help = "in place of a sheet: names, whose parts may be *, of masses on its one side"}),
      key<SeamSpec>("b", &SeamSpec::b,
                    {.help = "and on its other: every link between the two belongs to it"}),
      key<SeamSpec>(
          "strength", &SeamSpec::strength,
          {.range = above_to(0, 1e6), .fallback = "1", .help = "share of what its links bear otherwise"}),
      key<SeamSpec>("break_stretch", &SeamSpec::break_stretch,
                    {.unit = "× length",
                     .range = above_to(1, 1e6),
                     .fallback = "that of the links",
                     .help = "a longer link of it breaks"}),
      key<SeamSpec>("break_tension", &SeamSpec::break_tension,
                    {.unit = "N",
                     .range = above_to(0, 1e15),
                     .fallback = "that of the links",
                     .help = "a link of it that pulls harder breaks"}),
      key<SeamSpec>(
          "break_at", &SeamSpec::break_at,
          {.unit = "s", .range = above_to(0, far), .fallback = "never", .help = "when it opens as a whole"}),
  };
}

}  // namespace

std::vector<Section> physics_sections() {
  return {
      repeated_section<ChainSpec>("chain", "A straight row of equal masses, each linked to the next.",
                                  chain_keys(), description_of(&Description::chains)),
      repeated_section<SheetSpec>("sheet",
                                  "A rectangular net of equal masses, linked along rows and columns.",
                                  sheet_keys(), description_of(&Description::sheets)),
      repeated_section<MassSpec>("mass", "One mass.", mass_keys(), description_of(&Description::masses)),
      repeated_section<LinkSpec>("link", "One link between two masses.", link_keys(),
                                 description_of(&Description::links)),
      repeated_section<LoadSpec>("load", "A force that grows linearly.", load_keys(),
                                 description_of(&Description::loads)),
      repeated_section<SeamSpec>("seam", "Where a net gives way: links that bear less, or break at a time.",
                                 seam_keys(), description_of(&Description::seams)),
  };
}

}  // namespace taut
