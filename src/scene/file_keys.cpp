#include "object_section.h"
#include "physics_facts.h"
#include "section.h"
#include "solid_keys.h"

namespace taut {
namespace {

constexpr std::array<std::string_view, 3> mesh_parts{"links", "masses", "surface"};
constexpr std::array<std::string_view, 2> points_parts{"links", "masses"};
constexpr std::string_view hidden_with_all =
    "whether it is drawn; what is hidden moves as ever, but throws no shadow, and neither the camera nor the "
    "colour scale minds it";
constexpr LookFacts mesh_look{
    .visible = hidden_with_all,
    .colour = "of its links and free masses, and of the cloth's front, where look.colour_by is plain",
    .parts = mesh_parts,
    .two_sides = true};
constexpr LookFacts points_look{.visible = hidden_with_all,
                                .colour = "of its links and free masses, where look.colour_by is plain",
                                .parts = points_parts};

// Where what a file holds is put.
template <class T>
Keys<T> placing_keys() {
  return {
      key<T>("position", &T::position,
             {.unit = "m", .range = between(-far, far), .help = "where the origin of the file goes"}),
      key<T>("turn", &T::turn,
             {.unit = "degrees",
              .range = between(-360, 360),
              .help = "about x, then y, then z, through the origin of the file"}),
  };
}

// How large what a mesh's file holds is, and which way up.
template <class T>
Keys<T> size_keys() {
  return {
      key<T>("scale", &T::scale,
             {.unit = "m", .range = above_to(0, far), .help = "that 1 in the file stands for"}),
      key<T>("up", &T::up, {.help = "the axis of the file that points upwards"}),
  };
}

template <class T>
Key<T> weld_key() {
  return key<T>("weld", &T::weld,
                {.unit = "m",
                 .range = between(0, far),
                 .fallback = "a millionth of its size",
                 .help = "corners as near as this are one"});
}

template <class T>
Key<T> content_key() {
  Key<T> made = key<T>(
      "content", &T::content,
      {.fallback = "any",
       .help = "the hash that the file must have: written by the program, so that what was made from it is "
               "not gone on with from another"});
  made.write = [](const T& spec) {
    return spec.content.empty() ? std::string() : Codec<std::string>::write(spec.content);
  };
  return made;
}

Keys<MeshSpec> pin_keys() {
  return {
      key<MeshSpec>("pinned", &MeshSpec::pinned,
                    {.help = "names of groups, objects or materials in the file whose corners are held"}),
      key<MeshSpec>("pinned_box", &MeshSpec::pinned_box,
                    {.unit = "m",
                     .range = between(-far, far),
                     .fallback = "none",
                     .help = "what of it is in this box at the start is held"}),
      key<MeshSpec>("pinned_masses", &MeshSpec::pinned_masses,
                    {.range = between(0, 1e8), .help = "numbers of masses that are held"}),
      key<MeshSpec>("motion", &MeshSpec::motion,
                    {.fallback = "stays",
                     .help = "how all of its pins are moved; a path is that of the pin of the lowest number, "
                             "and the others keep their places beside it"}),
      key<MeshSpec>("release", &MeshSpec::release,
                    {.unit = "s",
                     .range = above_to(0, far),
                     .fallback = "never",
                     .help = "when what is pinned is let go of"}),
  };
}

Keys<MeshSpec> mesh_keys() {
  return Keys<MeshSpec>{
             key<MeshSpec>("name", &MeshSpec::name,
                           named("its masses are named name.0, name.1, … as their corners come in the file")),
             key<MeshSpec>("file", &MeshSpec::file,
                           named("an .obj, .ply or .stl file, from the folder of the scene on")),
             content_key<MeshSpec>(),
             key<MeshSpec>(
                 "mass", &MeshSpec::mass,
                 {.unit = "kg", .range = above_to(0, 1e12), .help = "of the whole, shared by its masses"}),
             key<MeshSpec>("shares", &MeshSpec::shares,
                           {.help = "area: each mass has a third of the triangles around it; equal: all have "
                                    "the same"}),
         } +
         size_keys<MeshSpec>() + placing_keys<MeshSpec>() + Keys<MeshSpec>{weld_key<MeshSpec>()} +
         pin_keys() + contact_keys<MeshSpec>() + link_property_keys<MeshSpec>(&MeshSpec::properties) +
         Keys<MeshSpec>{
             key<MeshSpec>("diagonals", &MeshSpec::diagonals,
                           {.help = "links along both diagonals of every face with four corners; true: rigid "
                                    "ones"}),
             key<MeshSpec>(
                 "skip_one", &MeshSpec::skip_one,
                 {.help = "links across every edge between two triangles, from corner to corner, and "
                          "over every mass among quads, from the one before it to the one behind; "
                          "true: rigid ones"}),
             key<MeshSpec>("bending", &MeshSpec::bending,
                           {.fallback = "none",
                            .help = "how it resists being bent where two edges go on from each other within "
                                    "45°"}),
             key<MeshSpec>(
                 "faces", &MeshSpec::faces,
                 {.fallback = "only masses touch, as balls",
                  .help = "lets its triangles touch: solids, one another, and those of other sheets and "
                          "meshes; a scene whose faces start nearer than their thickness is refused"}),
         };
}

Keys<MeshSolidSpec> mesh_solid_keys() {
  return Keys<MeshSolidSpec>{
             key<MeshSolidSpec>("file", &MeshSolidSpec::file,
                                named("an .obj, .ply or .stl file, from the folder of the scene on: a closed "
                                      "surface")),
             content_key<MeshSolidSpec>(),
         } +
         size_keys<MeshSolidSpec>() + placing_keys<MeshSolidSpec>() +
         Keys<MeshSolidSpec>{weld_key<MeshSolidSpec>()} + touch_keys<MeshSolidSpec>();
}

Keys<PointsSpec> points_keys() {
  return Keys<PointsSpec>{
             key<PointsSpec>(
                 "name", &PointsSpec::name,
                 named("its masses are named name.0, name.1, … by their rows, or name.x where the "
                       "table has a name x")),
             key<PointsSpec>("masses", &PointsSpec::masses,
                             named("a table (CSV), from the folder of the scene on, with the columns x, y, z "
                                   "and at will name, vx, vy, vz, mass, radius, pinned")),
             key<PointsSpec>("links", &PointsSpec::links,
                             {.help = "a table with the columns a, b and at will length, stiffness, damping, "
                                      "break_stretch, break_tension; empty: no links"}),
             content_key<PointsSpec>(),
         } +
         placing_keys<PointsSpec>() +
         Keys<PointsSpec>{
             key<PointsSpec>("mass", &PointsSpec::mass,
                             {.unit = "kg",
                              .range = above_to(0, 1e12),
                              .help = "of each mass for which the table has none"}),
             key<PointsSpec>("pinned", &PointsSpec::pinned,
                             {.help = "names in the table, or numbers of rows as texts, of masses that are "
                                      "held, beside those that it has pinned"}),
         } +
         contact_keys<PointsSpec>() + link_property_keys<PointsSpec>(&PointsSpec::properties);
}

}  // namespace

std::vector<Section> file_sections() {
  return {
      object_section<MeshSpec>("mesh",
                               "A surface out of a file as cloth: corners are masses, edges are links.",
                               mesh_keys(), mesh_look, &Description::meshes, &ObjectLooks::meshes),
      object_section<PointsSpec>("points", "Masses and links out of tables.", points_keys(), points_look,
                                 &Description::points, &ObjectLooks::points),
      object_section<MeshSolidSpec>(
          "solid", "A solid out of a mesh file, a closed surface that no mass can enter.", mesh_solid_keys(),
          solid_look, &Description::mesh_solids, &ObjectLooks::mesh_solids),
  };
}

}  // namespace taut
