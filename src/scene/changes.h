#pragma once

#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "document.h"
#include "scene/scene.h"

namespace taut {

/// What the changes of the command line are called in errors, in the order of Origin::change: each
/// `--set key=value`, then `--method name` when given.
std::vector<std::string> change_names(const SceneOverrides& overrides);

/// Changes a document as the command line asks: `--set` first, in order, then `--method`, which takes the
/// place of solve.method. Where the method was changed, the file's keys of [solve] that only other methods
/// have are dropped. Returns what is wrong with the changes themselves.
std::vector<Diagnostic> apply_changes(const SceneOverrides& overrides, Node& document);

}  // namespace taut
