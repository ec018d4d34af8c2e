#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "base/failure.h"
#include "methods/method.h"
#include "model/description.h"
#include "model/size.h"
#include "view/expectation.h"
#include "view/view.h"

namespace taut {

/// A scene that can't be meant. The text holds every error with file, line, column, the line, a caret and the
/// nearest right name.
class BadScene : public BadRequest {
 public:
  BadScene(const std::string& text, std::vector<Diagnostic> errors)
      : BadRequest(text), errors_(std::move(errors)) {}
  /// Those with a line first, in the order of lines and columns.
  const std::vector<Diagnostic>& errors() const { return errors_; }

 private:
  std::vector<Diagnostic> errors_;
};

/// A scene file, read, checked and built.
struct Scene {
  std::string name;  ///< the file's name without folder and ending
  std::string title;
  std::string folder;            ///< absolute, of the files that the scene names; empty where it names none
  double duration = 6.0;         ///< s
  std::string accuracy = "10%";  ///< used where solve_given is false
  bool solve_given = false;  ///< the file has a [solve] with a method, or one was given on the command line
  Settings settings;         ///< complete for its method
  Description description;   ///< as read, defaults filled in
  Model model;
  State start;
  Camera camera;
  Look look;
  Expectation expectation;
  std::vector<std::string> notes;  ///< what is allowed but seldom meant, a line each: "file:3:1: note: …"
};

/// What the command line changes in a scene.
struct SceneOverrides {
  std::vector<std::string> sets;  ///< "key=value", key a dotted path; a bare name means solve.
  std::optional<std::string>
      method;  ///< takes the place of solve.method; the scene's keys of other methods are then left out
};

/// Told what a scene asks for, once that is known and before it is built.
using BeforeBuilding = std::function<void(const Counts&)>;

/// What a scene file holds; somewhat more than a scene may, of one that is too long. Throws BadRequest where
/// there is none, or none to read.
std::string scene_text(const std::filesystem::path& file);

/// Reads and builds a scene. Throws BadScene, and BadRequest where there is no file to read.
Scene load_scene(const std::filesystem::path& file, const SceneOverrides& overrides = {},
                 const BeforeBuilding& before_building = {});

/// The same from text; `file` is named in errors, and its folder is that of files which the text names.
Scene parse_scene(const std::string& text, const std::string& file, const SceneOverrides& overrides = {},
                  const BeforeBuilding& before_building = {});

/// The scene as TOML with every default filled in; parse_scene() of it gives the same model and start, bit
/// for bit, where the files that it names are found and have not changed: it has their hashes.
std::string resolved_toml(const Scene& scene);

/// The dotted paths of all keys that `--set` takes for a scene's text: entries of lists by their names,
/// numbers or `*`. Of no text, or one that is no TOML, those of any scene.
std::vector<std::string> settable_keys(const std::string& text);

/// The reference of every key of a scene file as Markdown, made from the parser's own table.
std::string key_reference();

/// The same as JSON: an array of sections, each with its keys, their types, units, defaults and ranges.
std::string key_reference_json();

}  // namespace taut
