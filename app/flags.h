#pragma once

#include <optional>
#include <string>
#include <vector>

#include "command_line.h"
#include "frames/painter.h"
#include "host/shard.h"
#include "methods/method.h"
#include "scene/scene.h"

namespace taut {

/// Adds --set, which changes keys of what it is said to be of.
void add_sets(Verb& verb, std::vector<std::string>& sets, std::string_view of = "the scene");

/// Which scene, and what is changed in it.
struct SceneFlags {
  std::string scene;
  std::vector<std::string> sets;
  std::string method;
  std::string threads;

  /// Adds the argument SCENE and the flags; `optional`: when it may be left out.
  void add_to(Verb& verb, const std::string& optional = "");
  /// Adds only the flags.
  void add_changes_to(Verb& verb);
  /// Adds what thread_count() reads.
  void add_threads_to(Verb& verb);
  SceneOverrides overrides() const;
  /// How many threads a run is to be stepped on: as many as asked for, or else as there are cores beside so
  /// many that are busy with something else. Throws BadRequest.
  int thread_count(int busy) const;
};

/// So many threads for one run.
Execution on_threads(int count);

/// Reads the scene that an argument means. Of a large one it says on stderr how large before it is built,
/// unless it is to be quiet. Throws BadRequest with all of its errors.
Scene load(const std::string& argument, const SceneOverrides& overrides, bool quiet);

/// Says on stderr what is allowed in a scene but seldom meant, unless it is to be quiet.
void print_notes(const Scene& scene, bool quiet);

/// Adds the flag --shard; `afterwards` says what is done when all shards are there.
void add_shard(Verb& verb, std::string& shard, const std::string& afterwards);

/// The part that the flag's text means, or else what a Slurm array says. Throws BadRequest.
Shard chosen_shard(const std::string& text);

/// Adds the flag --metrics.
void add_metrics(Verb& verb, std::string& file);

/// Adds the flag --slow.
void add_slow(Verb& verb, std::string& slow);

/// Slows a scene's film down as the flag's text says; empty: not at all. Throws BadRequest.
void apply_slow(const std::string& slow, Scene& scene);

/// How pictures are made.
struct PictureFlags {
  std::string size, quality, colour, gl = "auto", shader_folder;
  bool transparent = false;
  bool captions = false;  ///< before the command line is read: the verb's usual

  void add_to(Verb& verb);
  /// Throws BadRequest. `usual` is the size where neither size nor quality is given.
  PictureSettings settings(std::optional<Size> usual = {}) const;
  /// Puts what the flags say about colours into a scene. Throws BadRequest.
  void apply_to(Scene& scene) const;
};

}  // namespace taut
