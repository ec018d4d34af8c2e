#pragma once

#include <string>

namespace taut {

/// A JSON value as text, in one line or indented. Names of files may hold bytes that are no UTF-8, which JSON
/// can't: each becomes U+FFFD there.
template <class Value>
std::string json_text(const Value& json, int indent = -1) {
  return json.dump(indent, ' ', false, Value::error_handler_t::replace);
}

}  // namespace taut
