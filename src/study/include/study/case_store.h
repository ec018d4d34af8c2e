#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace taut {

/// How many of the cases that were planned are done.
struct CaseCount {
  std::size_t completed = 0, planned = 0;
};

/// Results of cases in a file, each saved as it comes: a line that names the inputs, then a line a case with
/// the build that ran it, all JSON. Whatever moment the program ends at, every case saved before is there
/// afterwards; a last line that was being written is dropped. The file is locked while the object lives, so
/// that no two programs run the same case.
class CaseStore {
 public:
  /// Reads what the file holds, or begins it, with its folder. `inputs` is a hash of all that decides the
  /// results (physics of the scene, versions.h, options). Throws OutputConflict where the file was made from
  /// other inputs or is no such file, unless told to overwrite; RunFailure where it can't be written or
  /// another program holds it.
  CaseStore(std::filesystem::path file, std::string_view inputs, bool overwrite);
  ~CaseStore();
  CaseStore(const CaseStore&) = delete;
  CaseStore& operator=(const CaseStore&) = delete;

  bool has(std::string_view key) const { return results_.contains(key); }
  /// The result of a case, as compact JSON text. To be asked only where has() holds.
  const std::string& result(std::string_view key) const { return results_.find(key)->second; }
  /// Every case with its result, in the order of the keys.
  const std::map<std::string, std::string, std::less<>>& results() const { return results_; }

  /// Saves a result, which must be JSON text; it is on the disk when this returns. Throws RunFailure with the
  /// system's reason, and std::logic_error for a case that is there already.
  void add(const std::string& key, std::string_view json);

  /// How many of these cases are done.
  CaseCount count(const std::vector<std::string>& planned) const;

 private:
  void read(const std::string& header, bool overwrite);
  void append(std::string_view line);

  std::filesystem::path file_;
  int descriptor_ = -1;
  std::map<std::string, std::string, std::less<>> results_;
};

/// Whether a file begins as that of a CaseStore does.
bool is_case_file(const std::filesystem::path& file);

/// The inputs that a file of a CaseStore was made from. Throws OutputConflict where it is no such file.
std::string inputs_of_cases(const std::filesystem::path& file);

/// Every case that a file of a CaseStore holds, with its result, where the text of its inputs begins like
/// this; none where there is no such file. Changes nothing. Throws OutputConflict where it was made from
/// other inputs or is no such file.
std::map<std::string, std::string, std::less<>> read_cases(const std::filesystem::path& file,
                                                           std::string_view inputs_begin);

}  // namespace taut
