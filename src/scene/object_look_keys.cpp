#include "object_section.h"

namespace taut {

Keys<ObjectLook> object_look_keys(const LookFacts& facts) {
  Keys<ObjectLook> keys{
      key<ObjectLook>("visible", &ObjectLook::visible, {.help = facts.visible}),
      key<ObjectLook>("colour", &ObjectLook::colour,
                      {.range = between(0, 1), .fallback = "as `[look]` has it", .help = facts.colour}),
  };
  if (facts.two_sides)
    keys.push_back(key<ObjectLook>("back_colour", &ObjectLook::back_colour,
                                   {.range = between(0, 1),
                                    .fallback = "a darker `colour`, or as `[look]` has it",
                                    .help = "of the cloth's back"}));
  if (!facts.parts.empty())
    keys.push_back(key<ObjectLook>(
        "draw", &ObjectLook::draw,
        {.choices = facts.parts,
         .fallback = "as `[look]` has it",
         .help = "what it is drawn as, whatever `[look]` says of others; [] hides it as `visible` does"}));
  return keys;
}

}  // namespace taut
