#include "errors_json.h"

#include <cstddef>

#include "base/diagnostic.h"
#include "scene/scene.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

Json place_to_json(std::size_t number) {
  return number == 0 ? Json() : Json(number);
}

}  // namespace

Json bad_request_to_json(const BadRequest& problem) {
  const auto* scene = dynamic_cast<const BadScene*>(&problem);
  if (scene == nullptr) return Json::array({{{"message", problem.what()}}});
  Json list = Json::array();
  for (const Diagnostic& error : scene->errors())
    list.push_back({{"file", error.origin},
                    {"line", place_to_json(error.line)},
                    {"column", place_to_json(error.column)},
                    {"key", error.key},
                    {"message", error.message},
                    {"hint", error.hint}});
  return list;
}

}  // namespace taut
