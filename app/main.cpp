#include <cstdio>
#include <exception>
#include <functional>
#include <new>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>

#include "base/failure.h"
#include "base/json_text.h"
#include "command_line.h"
#include "errors_json.h"
#include "exit_status.h"
#include "host/signals.h"
#include "host/standard_streams.h"
#include "methods/simd.h"
#include "verbs.h"
#include "version_text.h"

namespace taut {
namespace {

int fail(const char* what, ExitStatus status) {
  tell("taut: {}\n", what);
  return status;
}

int refuse(const BadRequest& problem, bool json) {
  if (json) {
    print_result("{}\n", json_text(nlohmann::ordered_json{{"errors", bad_request_to_json(problem)}}, 2));
    finish_results();
  }
  return fail(problem.what(), exit_bad_request);
}

// Runs what the command line asks for and turns what it throws into a message and an exit status. What it
// printed counts as done only once it has arrived.
int carry_out(const std::function<Asked()>& parse) {
  Asked asked;
  try {
    asked = parse();
    const int status = asked.action();
    finish_results();
    return status;
  } catch (const BadRequest& problem) {
    return refuse(problem, asked.json);
  } catch (const OutputConflict& problem) {
    return fail(problem.what(), exit_conflict);
  } catch (const std::system_error& problem) {
    const bool threads = problem.code() == std::errc::resource_unavailable_try_again;
    return fail(threads ? "this machine gives no more threads" : problem.what(), exit_failed);
  } catch (const std::bad_alloc&) {
    return fail("this machine has not enough memory for that", exit_failed);
  } catch (const std::exception& problem) {
    return fail(problem.what(), exit_failed);
  }
}

int run(int argument_count, char** arguments) {
  CommandLine program("taut", "taut: masses joined by links, simulated and shown without a display",
                      version_text);
  program.footer("`taut VERB --help` says more.\n\nExample:\n  taut render hanging-chain --film chain.mp4");
  add_render(program);
  add_compare(program);
  add_simulate(program);
  add_still(program);
  add_strip(program);
  add_check(program);
  add_chart(program);
  add_export(program);
  add_plot(program);
  add_sag(program);
  add_stability(program);
  add_merge(program);
  add_verify(program);
  add_bench(program);
  add_list(program);
  add_new(program);
  add_generate(program);
  std::string simd;
  program.add_everywhere(
      "--simd", "TAUT_SIMD", simd,
      "Use these vector instructions instead of the best, which changes no result: one of those that "
      "`taut --version` names");
  return carry_out([&] {
    Asked asked = program.parse(argument_count, arguments);
    force_simd(simd);
    return asked;
  });
}

}  // namespace
}  // namespace taut

int main(int argument_count, char** arguments) {
  taut::fill_standard_streams();
  taut::ignore_write_signals();
  try {
    return taut::run(argument_count, arguments);
  } catch (const std::exception& problem) {
    taut::show_text(stderr, "taut: ");
    taut::show_text(stderr, problem.what());
    taut::show_text(stderr, "\n");
    return taut::exit_failed;
  }
}
