#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "view/view.h"

namespace taut {

/// The colour of a name; nothing where there is none of that name.
std::optional<Colour> colour_named(std::string_view name);

/// All names, in the order in which they are listed.
std::span<const std::string_view> colour_names();

}  // namespace taut
