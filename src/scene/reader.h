#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "document.h"
#include "model/description.h"

namespace taut {

/// Collects what is wrong while a document is read, and remembers which entries it concerns, so that checks
/// made later on what was read do not complain about the same thing again.
class Reader {
 public:
  /// In which sections a key exists, as `[world]`, for each key there is.
  using Homes = std::multimap<std::string, std::string, std::less<>>;

  /// `file` and `changes` are what origins are called in diagnostics.
  Reader(std::string file, std::vector<std::string> changes, Homes homes)
      : file_(std::move(file)), changes_(std::move(changes)), homes_(std::move(homes)) {}

  /// A hint for a key that is in the wrong place: where it belongs; empty for a key there is nowhere.
  std::string home_hint(std::string_view key) const;

  /// From now on errors concern this entry of this section.
  void begin_entry(std::string_view section, std::size_t index);
  /// From now on errors concern this key of the entry.
  void begin_key(std::string_view key) { key_ = key; }

  /// A value was read as meant, but may not be so (out of range).
  void bad_value(const Origin& origin, std::string message, std::string hint = {});
  /// The entry could not be read as meant, so what it became says nothing about the scene.
  void unreadable(const Origin& origin, std::string message, std::string hint = {});
  /// Something that no entry is to blame for.
  void plain(const Origin& origin, std::string message, std::string hint = {});

  /// A diagnostic of that place, not collected.
  Diagnostic located(const Origin& origin, std::string message, std::string hint = {}) const;

  /// True when a problem found in what was read is already reported, or follows from something reported.
  bool follows_from_reported(const Problem& problem) const;

  /// Whether the masses that were read are all that were meant, under the names they were meant to have.
  bool names_complete() const { return !names_incomplete_; }
  /// Whether they are also where they were meant to be, and linked as they were meant to be.
  bool masses_readable() const;
  /// Whether every entry that makes a part of the model could be read as meant.
  bool model_readable() const;

  /// How many errors there are, those beyond the most that are kept included.
  std::size_t count() const { return diagnostics_.size() + left_out_; }
  /// Whether there are so many errors that no more are worth looking for.
  bool full() const;
  /// How many are beyond the most that are kept.
  std::size_t left_out() const { return left_out_; }
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }

 private:
  using EntryId = std::pair<std::string, std::size_t>;

  std::string file_;
  std::vector<std::string> changes_;
  Homes homes_;
  std::vector<Diagnostic> diagnostics_;
  std::size_t left_out_ = 0;
  EntryId entry_;
  std::string key_;
  std::set<EntryId> unreadable_;
  std::map<EntryId, std::set<std::string>> reported_keys_;
  bool names_incomplete_ = false;  // some masses may be missing from what was read
};

}  // namespace taut
