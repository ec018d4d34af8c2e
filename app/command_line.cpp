#include "command_line.h"

#include <CLI/CLI.hpp>
#include <sstream>

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

// What was wrong, told by the program or by the verb that was in use.
Misuse misuse(const CLI::App& program, const CLI::ParseError& error) {
  const std::vector<CLI::App*> used = program.get_subcommands();
  const CLI::App& verb = used.empty() ? program : *used.front();
  Misuse misuse{used.empty() ? "" : verb.get_name(), {}, verb.remaining(), flags_of(verb), error.what()};
  for (const CLI::App* each : program.get_subcommands({})) misuse.verbs.push_back(each->get_name());
  return misuse;
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

Flag* Flag::allow_extra_args(bool allowed) {
  option_->allow_extra_args(allowed);
  return this;
}

Flag* Flag::delimiter(char separator) {
  option_->delimiter(separator);
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

Action CommandLine::parse(int argument_count, char** arguments) {
  try {
    program_->parse(argument_count, arguments);
  } catch (const CLI::Success& help) {
    std::ostringstream text;
    const int status = program_->exit(help, text, text);
    return [status, shown = text.str()] {
      write_result(shown);
      return status;
    };
  } catch (const CLI::ParseError& error) {
    throw BadRequest(usage_problem(misuse(*program_, error)));
  }
  // Of several verbs the last one given counts.
  const Action* action = nullptr;
  for (const CLI::App* used : program_->get_subcommands())
    for (const Verb& verb : verbs_)
      if (&verb.parser() == used) action = &verb.action();
  if (action == nullptr) throw BadRequest("say what to do: taut VERB …\nSee taut --help.");
  return *action;
}

}  // namespace taut
