#include "command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>
#include <string_view>

#include "base/failure.h"
#include "host/standard_streams.h"
#include "usage.h"

namespace taut {
namespace {

std::vector<std::string> flags_of(const CLI::App& verb) {
  std::vector<std::string> flags;
  for (const CLI::Option* option : verb.get_options())
    for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
  return flags;
}

// What no flag names, as it was given.
std::vector<std::string> arguments_of(const CLI::App& verb) {
  std::vector<std::string> words;
  for (const CLI::Option* option : verb.get_options())
    if (option->get_positional())
      words.insert(words.end(), option->results().begin(), option->results().end());
  return words;
}

// What was wrong, told by the program or by the verb that was in use.
Misuse misuse(const CLI::App& program, const CLI::ParseError& error) {
  const std::vector<CLI::App*> used = program.get_subcommands();
  const CLI::App& verb = used.empty() ? program : *used.front();
  Misuse misuse{used.empty() ? "" : verb.get_name(), {}, verb.remaining(), arguments_of(verb), error.what()};
  for (const CLI::App* each : program.get_subcommands({})) misuse.flags[each->get_name()] = flags_of(*each);
  return misuse;
}

[[noreturn]] void refuse_empty(const std::string& name, const std::string& verb) {
  throw BadRequest(with_help(fmt::format("{} needs a value, and was given an empty one", name), verb));
}

// "--film=": the parser would take the next word for its value.
void require_values(int argument_count, char** arguments) {
  for (int i = 1; i < argument_count; ++i) {
    const std::string_view word = arguments[i];
    if (word == "--") return;
    if (word.starts_with("--") && word.find('=') == word.size() - 1)
      refuse_empty(std::string(word.substr(0, word.size() - 1)), i > 1 ? arguments[1] : "");
  }
}

// No option means anything by nothing.
void require_values(const CLI::App& verb) {
  for (const CLI::Option* option : verb.get_options())
    if (std::ranges::find(option->results(), "") != option->results().end())
      refuse_empty(option->get_name(), verb.get_name());
}

}  // namespace

Flag* Flag::required() {
  option_->required();
  return this;
}

Flag* Flag::capture_default_str() {
  option_->capture_default_str();
  return this;
}

Flag* Flag::one_each(const std::string& value) {
  option_->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)->type_name(value);
  option_->allow_extra_args(false);
  return this;
}

Flag* Flag::list(const std::string& values) {
  one_each(values);
  option_->delimiter(',');
  return this;
}

Flag* Flag::excludes(const Flag* other) {
  option_->excludes(other->option_);
  return this;
}

Flag* Verb::add_option(const std::string& names, std::string& value, const std::string& help) {
  return &flags_.emplace_back(*parser_->add_option(names, value, help));
}

Flag* Verb::add_option(const std::string& names, std::vector<std::string>& values, const std::string& help) {
  return &flags_.emplace_back(*parser_->add_option(names, values, help));
}

Flag* Verb::add_flag(const std::string& names, bool& value, const std::string& help) {
  return &flags_.emplace_back(*parser_->add_flag(names, value, help));
}

void Verb::footer(const std::string& text) {
  parser_->footer(text);
}

CommandLine::CommandLine(const std::string& name, const std::string& description, const std::string& version)
    : program_(std::make_unique<CLI::App>(description, name)) {
  program_->set_version_flag("--version", version);
}

CommandLine::~CommandLine() = default;

Verb* CommandLine::add_subcommand(const std::string& name, const std::string& help) {
  return &verbs_.emplace_back(*program_->add_subcommand(name, help));
}

void CommandLine::footer(const std::string& text) {
  program_->footer(text);
}

void CommandLine::add_everywhere(const std::string& names, const std::string& variable, std::string& value,
                                 const std::string& help) {
  for (CLI::App* verb : program_->get_subcommands({}))
    verb->add_option(names, value, help)->envname(variable);
}

Asked CommandLine::parse(int argument_count, char** arguments) {
  require_values(argument_count, arguments);
  try {
    program_->parse(argument_count, arguments);
  } catch (const CLI::Success& help) {
    std::ostringstream text;
    const int status = program_->exit(help, text, text);
    return {[status, shown = text.str()] {
      write_result(shown);
      return status;
    }};
  } catch (const CLI::ParseError& error) {
    throw BadRequest(usage_problem(misuse(*program_, error)));
  }
  // Of several verbs the last one given counts.
  Asked asked;
  for (const CLI::App* used : program_->get_subcommands()) {
    require_values(*used);
    const CLI::Option* json = used->get_option_no_throw("--json");
    for (const Verb& verb : verbs_)
      if (&verb.parser() == used) asked = {verb.action(), json != nullptr && json->count() > 0};
  }
  if (!asked.action) throw BadRequest("say what to do: taut VERB …\nSee taut --help.");
  return asked;
}

}  // namespace taut
