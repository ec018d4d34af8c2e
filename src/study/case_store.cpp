#include "study/case_store.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/failure.h"
#include "base/json_text.h"
#include "host/build_info.h"
#include "output/atomic_file.h"
#include "output/file_lock.h"

namespace taut {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void fail(const std::filesystem::path& file, std::string_view verb, int error) {
  throw RunFailure(
      fmt::format("can't {} {}: {}", verb, file.string(), std::generic_category().message(error)));
}

[[noreturn]] void conflict(const std::filesystem::path& file, std::string_view what) {
  throw OutputConflict(
      fmt::format("{} {}; --overwrite replaces it, -o chooses another folder", file.string(), what));
}

std::string header_for(std::string_view inputs) {
  return json_text(Json{{"taut", "cases"}, {"inputs", inputs}}) + "\n";
}

std::string read_all(const std::filesystem::path& file, int descriptor) {
  std::string text;
  std::array<char, 65536> buffer;
  for (;;) {
    const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(file, "read", errno);
    if (count == 0) return text;
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

// The key and the result of one line; nothing where it is damaged.
std::optional<std::pair<std::string, std::string>> read_line(std::string_view line) {
  try {
    const Json json = Json::parse(line);
    return std::pair(json.at("case").get<std::string>(), json_text(json.at("result")));
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

bool is_header(std::string_view line) {
  const Json json = Json::parse(line, nullptr, false);
  return json.is_object() && json.value("taut", Json()) == "cases" && json.contains("inputs");
}

}  // namespace

CaseStore::CaseStore(std::filesystem::path file, std::string_view inputs, bool overwrite)
    : file_(std::move(file)) {
  if (file_.has_parent_path()) make_folder(file_.parent_path());
  constexpr mode_t everyone_as_umask_allows = 0666;
  descriptor_ = ::open(file_.c_str(), O_CREAT | O_RDWR | O_APPEND | O_CLOEXEC, everyone_as_umask_allows);
  if (descriptor_ < 0) fail(file_, "write", errno);
  try {
    if (!lock_file(descriptor_, LockWait::a_while)) {
      if (errno != EWOULDBLOCK) fail(file_, "lock", errno);
      throw RunFailure(fmt::format("another taut is working on {}", file_.string()));
    }
    read(header_for(inputs), overwrite);
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

CaseStore::~CaseStore() {
  ::close(descriptor_);
}

void CaseStore::read(const std::string& header, bool overwrite) {
  const std::string text = overwrite ? std::string() : read_all(file_, descriptor_);
  std::size_t kept = 0;  // bytes of whole lines
  if (!header.starts_with(text)) {
    if (!text.starts_with(header))
      conflict(file_, is_header(text.substr(0, text.find('\n')))
                          ? "holds cases of other inputs, or worked out by other rules"
                          : "is no file of cases");
    kept = header.size();
    for (std::size_t end = 0; (end = text.find('\n', kept)) != std::string::npos; kept = end + 1) {
      auto entry = read_line(std::string_view(text).substr(kept, end - kept));
      if (!entry)
        conflict(file_,
                 fmt::format(
                     "is damaged at line {}",
                     std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(kept), '\n') + 1));
      results_.insert(*std::move(entry));
    }
  } else if (text == header) {
    kept = header.size();
  }
  if (kept == text.size() && kept > 0) return;
  if (::ftruncate(descriptor_, static_cast<off_t>(kept)) != 0) fail(file_, "write", errno);
  if (kept == 0) append(header);
}

void CaseStore::append(std::string_view left) {
  while (!left.empty()) {
    const ssize_t written = ::write(descriptor_, left.data(), left.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(file_, "write", errno);
    left.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::fdatasync(descriptor_) != 0) fail(file_, "write", errno);
}

void CaseStore::add(const std::string& key, std::string_view json) {
  if (has(key)) throw std::logic_error(fmt::format("the case {} was run twice", key));
  const Json result = Json::parse(json);
  append(json_text(Json{{"case", key}, {"build", build_info()}, {"result", result}}) + "\n");
  results_.emplace(key, json_text(result));
}

CaseCount CaseStore::count(const std::vector<std::string>& planned) const {
  const auto completed = std::ranges::count_if(planned, [&](const std::string& key) { return has(key); });
  return {static_cast<std::size_t>(completed), planned.size()};
}

bool is_case_file(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  return std::getline(stream, line) && is_header(line);
}

std::string inputs_of_cases(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  std::getline(stream, line);
  if (!is_header(line)) conflict(file, "is no file of cases");
  return Json::parse(line).at("inputs").get<std::string>();
}

std::map<std::string, std::string, std::less<>> read_cases(const std::filesystem::path& file,
                                                           std::string_view inputs_begin) {
  std::map<std::string, std::string, std::less<>> results;
  std::ifstream stream(file, std::ios::binary);
  std::string line;
  if (!std::getline(stream, line) || stream.eof()) return results;
  if (!is_header(line)) conflict(file, "is no file of cases");
  if (!Json::parse(line).at("inputs").get<std::string>().starts_with(inputs_begin))
    conflict(file, "holds cases of other inputs");
  // A last line that was being written has no end.
  while (std::getline(stream, line) && !stream.eof()) {
    auto entry = read_line(line);
    if (!entry) conflict(file, "is damaged");
    results.insert(*std::move(entry));
  }
  return results;
}

}  // namespace taut
