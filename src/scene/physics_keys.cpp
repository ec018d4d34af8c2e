#include "object_section.h"
#include "physics_facts.h"
#include "section.h"

namespace taut {
namespace {

constexpr std::array<std::string_view, 2> chain_ends{"first", "last"};
constexpr std::array<std::string_view, 8> sheet_edges{"top",      "bottom",    "left",        "right",
                                                      "top-left", "top-right", "bottom-left", "bottom-right"};

constexpr std::array<std::string_view, 2> chain_parts{"links", "masses"};
constexpr std::array<std::string_view, 3> sheet_parts{"links", "masses", "surface"};
constexpr std::string_view hidden_wholly =
    "whether it is drawn; what is hidden moves as ever, but throws no shadow, and neither the camera nor the "
    "colour scale minds it";
constexpr LookFacts chain_look{.visible = hidden_wholly,
                               .colour = "of its links and free masses, where look.colour_by is plain",
                               .parts = chain_parts};
constexpr LookFacts sheet_look{
    .visible = hidden_wholly,
    .colour = "of its links and free masses, and of the cloth's front, where look.colour_by is plain",
    .parts = sheet_parts,
    .two_sides = true};
constexpr LookFacts mass_look{.visible = "whether it is drawn; its links are drawn all the same",
                              .colour = "of the mass, a pinned one too"};
constexpr LookFacts link_look{
    .visible = "whether it is drawn; never where a chain, sheet or ragdoll at its end is hidden",
    .colour = "of the link, where look.colour_by is plain"};

// An end of a straight chain; others have none.
Key<ChainSpec> end_key(std::string_view name, Vec3 ChainSpec::*member, std::string_view help) {
  Key<ChainSpec> made = key<ChainSpec>(
      name, member,
      {.unit = "m", .range = between(-far, far), .fallback = "as `points` or `wound` has it", .help = help});
  made.write = [member](const ChainSpec& chain) {
    return chain.straight() ? Codec<Vec3>::write(chain.*member) : std::string();
  };
  return made;
}

// Left out where there are none: an empty list would say where no chain lies.
Key<ChainSpec> points_key() {
  Key<ChainSpec> made = key<ChainSpec>(
      "points", &ChainSpec::points,
      {.unit = "m",
       .range = between(-far, far),
       .fallback = "straight from `from` to `to`",
       .help =
           "in place of `from` and `to`: it is laid along these, from the first to the last, with links of "
           "one length, so that corners between masses are cut"});
  made.write = [](const ChainSpec& chain) {
    return chain.points.empty() ? std::string() : Codec<std::vector<Vec3>>::write(chain.points);
  };
  return made;
}

// A chain lies where its ends say, or its points, or what it is wound around.
void check_chain_ends(const Node& chain, Reader& reader) {
  const Entry* points = find_entry(chain, "points");
  const Entry* way = points ? points : find_entry(chain, "wound");
  for (const std::string_view end : {"from", "to"}) {
    const Entry* given = find_entry(chain, end);
    reader.begin_key(end);
    if (!way && !given)
      reader.unreadable(
          chain.origin,
          fmt::format("[[chain]] needs the key \"{}\", or \"points\" or \"wound\" in its place", end));
    if (way && given)
      reader.unreadable(given->origin,
                        fmt::format("\"{}\" says where this chain lies: it has no \"{}\"", way->key, end));
  }
}

constexpr Facts release_facts() {
  return {.unit = "s",
          .range = above_to(0, far),
          .fallback = "never",
          .help = "when what is pinned is let go of"};
}

Keys<ChainSpec> chain_keys() {
  return Keys<ChainSpec>{
             key<ChainSpec>("name", &ChainSpec::name, named("its masses are named name.0, name.1, …")),
             end_key("from", &ChainSpec::from, "where the first mass is"),
             end_key("to", &ChainSpec::to, "where the last mass is"),
             points_key(),
             key<ChainSpec>("smooth", &ChainSpec::smooth,
                            {.help = "along a smooth curve through the points, in place of straight lines"}),
             key<ChainSpec>("wound", &ChainSpec::wound,
                            {.fallback = "not wound",
                             .help = "in place of `from` and `to`: around a solid, touching it"}),
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

// Of the edges in whole; corners move with the edge that they are part of.
Keys<SheetSpec> edge_motion_keys() {
  const auto moved = [](std::string_view name, MotionSpec SheetSpec::*member, std::string_view help) {
    return key<SheetSpec>(name, member, {.fallback = "stays", .help = help});
  };
  return {
      moved(
          "top_motion", &SheetSpec::top_motion,
          "how all of the top edge is moved, where it is pinned; a path is that of its first mass, name.0.0, "
          "and the others keep their places beside it"),
      moved("bottom_motion", &SheetSpec::bottom_motion,
            "the same of the bottom edge, by its mass in column 0"),
      moved("left_motion", &SheetSpec::left_motion, "the same of the left edge, by its mass in row 0"),
      moved("right_motion", &SheetSpec::right_motion, "the same of the right edge, by its mass in row 0"),
  };
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
         edge_motion_keys() + contact_keys<SheetSpec>() +
         link_property_keys<SheetSpec>(&SheetSpec::properties) +
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

Keys<TieSpec> tie_keys() {
  return Keys<TieSpec>{
             key<TieSpec>(
                 "a", &TieSpec::a,
                 named("masses, each of which is linked to one of b: an edge of a sheet is cloth.0.*")),
             key<TieSpec>(
                 "b", &TieSpec::b,
                 named("masses of which each of a takes the one that is nearest at the start; the link "
                       "is as long as they are apart then")),
             key<TieSpec>(
                 "every", &TieSpec::every,
                 {.range = between(1, 1e8), .help = "only every n-th of a; divides their number − 1"}),
         } +
         link_property_keys<TieSpec>(&TieSpec::properties);
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
      object_section<ChainSpec>(
          "chain", "A row of equal masses, each linked to the next: straight, along points, or wound.",
          chain_keys(), chain_look, &Description::chains, &ObjectLooks::chains, check_chain_ends),
      object_section<SheetSpec>("sheet", "A rectangular net of equal masses, linked along rows and columns.",
                                sheet_keys(), sheet_look, &Description::sheets, &ObjectLooks::sheets),
      object_section<MassSpec>("mass", "One mass.", mass_keys(), mass_look, &Description::masses,
                               &ObjectLooks::masses),
      object_section<LinkSpec>("link", "One link between two masses.", link_keys(), link_look,
                               &Description::links, &ObjectLooks::links),
      repeated_section<TieSpec>("tie", "Links that tie masses to the nearest ones of another object.",
                                tie_keys(), description_of(&Description::ties)),
      repeated_section<LoadSpec>("load", "A force that grows linearly.", load_keys(),
                                 description_of(&Description::loads)),
      repeated_section<SeamSpec>("seam", "Where a net gives way: links that bear less, or break at a time.",
                                 seam_keys(), description_of(&Description::seams)),
  };
}

}  // namespace taut
