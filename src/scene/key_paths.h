#pragma once

#include <vector>

#include "base/diagnostic.h"
#include "document.h"

namespace taut {

/// Says of each diagnostic which key it is about, as the dotted path that `--set` takes: `world.drag`,
/// `chain.0.links`. Left empty where there is no such key.
void name_keys(const Node& document, std::vector<Diagnostic>& diagnostics);

}  // namespace taut
