#include "program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

namespace taut::testing {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void become(const std::string& program, const std::vector<std::string>& arguments,
                         const Environment& environment, const fs::path& folder, const fs::path& out,
                         const fs::path& err) {
  for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
  if (!folder.empty() && ::chdir(folder.c_str()) != 0) std::_Exit(126);
  ::dup2(::open(out.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), STDOUT_FILENO);
  ::dup2(::open(err.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600), STDERR_FILENO);
  ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
  std::vector<std::string> words{program};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  ::execvp(program.c_str(), pointers.data());
  std::_Exit(127);
}

}  // namespace

Ran run_program(const std::string& program, const std::vector<std::string>& arguments,
                const Environment& environment, const fs::path& folder) {
  const TemporaryFolder said;
  const fs::path out = said.path() / "out", err = said.path() / "err";
  const pid_t process = ::fork();
  if (process < 0) throw std::runtime_error("fork failed");
  if (process == 0) become(program, arguments, environment, folder, out, err);
  int status = 0;
  ::waitpid(process, &status, 0);
  return {WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status), read_file(out), read_file(err)};
}

Ran taut(const std::vector<std::string>& arguments, const Environment& environment, const fs::path& folder) {
  return run_program(TAUT_PROGRAM, arguments, environment, folder);
}

std::string small_scene() {
  return R"(title = "A swinging mass"
[world]
duration = 1.0
[solve]
method = "xpbd"
steps_per_second = 240
passes = 1
[[mass]]
name = "nail"
position = [0, 2, 0]
pinned = true
[[mass]]
name = "bob"
position = [1, 2, 0]
mass = 1.0
[[link]]
a = "nail"
b = "bob"
)";
}

std::string scene_with_a_jumping_pin() {
  return small_scene() + R"(
[[mass]]
name = "hand"
position = [0, 1, 0]
pinned = true
motion = { path = [[0.5, 0, 1, 0], [0.5012, 9, 1, 0]] }
[[link]]
a = "hand"
b = "bob"
)";
}

}  // namespace taut::testing
