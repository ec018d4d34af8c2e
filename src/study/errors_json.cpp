#include "errors_json.h"

#include <string>

namespace taut {

nlohmann::ordered_json errors_to_json(const Errors& errors) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const ErrorKind kind : all_error_kinds)
    if (errors[kind]) json[std::string(name_of(kind))] = *errors[kind];
  return json;
}

Errors errors_from_json(const nlohmann::ordered_json& json) {
  Errors errors;
  for (const ErrorKind kind : all_error_kinds)
    if (const auto found = json.find(std::string(name_of(kind))); found != json.end())
      errors[kind] = found->get<double>();
  return errors;
}

}  // namespace taut
