#pragma once

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "base/failure.h"
#include "base/json_text.h"
#include "output/atomic_file.h"

namespace taut {

/// What a file of a cache says, read by `from_json`; where there is none or it is damaged, what `make` gives,
/// kept there as `to_json` writes it. A cache that can't be written is no reason to withhold what was worked
/// out.
template <class Make, class ToJson, class FromJson>
auto cached(const std::filesystem::path& file, const Make& make, const ToJson& to_json,
            const FromJson& from_json) {
  try {
    if (std::ifstream stream(file); stream) return from_json(nlohmann::ordered_json::parse(stream));
  } catch (const nlohmann::json::exception&) {
    // Damaged: made anew.
  }
  const auto made = make();
  try {
    make_folder(file.parent_path());
    write_file(file, json_text(to_json(made)));
  } catch (const RunFailure&) {
    // No cache, then.
  }
  return made;
}

}  // namespace taut
