#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

#include "base/failure.h"
#include "exit_status.h"
#include "host/build_info.h"
#include "usage.h"
#include "verbs.h"

namespace taut {
namespace {

int fail(const char* what, ExitStatus status) {
  fmt::print(stderr, "taut: {}\n", what);
  return status;
}

// Runs what the command line asks for and turns what it throws into a message and an exit status.
int carry_out(const Action& action) {
  try {
    return action();
  } catch (const BadRequest& problem) {
    return fail(problem.what(), exit_bad_request);
  } catch (const OutputConflict& problem) {
    return fail(problem.what(), exit_conflict);
  } catch (const std::bad_alloc&) {
    return fail("this machine has not enough memory for that", exit_failed);
  } catch (const std::exception& problem) {
    return fail(problem.what(), exit_failed);
  }
}

int run(int argument_count, char** arguments) {
  CLI::App program("taut: masses joined by links, simulated and shown without a display", "taut");
  program.set_version_flag("--version", build_info());
  program.footer("`taut VERB --help` says more.\n\nExample:\n  taut render hanging-chain --film chain.mp4");
  Action action;
  add_render(program, action);
  add_compare(program, action);
  add_still(program, action);
  add_strip(program, action);
  add_check(program, action);
  add_chart(program, action);
  add_export(program, action);
  add_sag(program, action);
  add_stability(program, action);
  add_list(program, action);
  try {
    program.parse(argument_count, arguments);
  } catch (const CLI::Success& help) {
    return program.exit(help);
  } catch (const CLI::ParseError& error) {
    return fail(fmt::format("{}\nSee {}.", usage_problem(program, error), help_hint(program)).c_str(),
                exit_bad_request);
  }
  if (!action) return fail("say what to do: taut VERB …\nSee taut --help.", exit_bad_request);
  return carry_out(action);
}

}  // namespace
}  // namespace taut

int main(int argument_count, char** arguments) {
  try {
    return taut::run(argument_count, arguments);
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "taut: %s\n", problem.what());
    return taut::exit_failed;
  }
}
