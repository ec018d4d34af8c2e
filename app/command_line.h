#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace taut {

/// What a verb does; gives the exit status.
using Action = std::function<int()>;

/// What a value is a name of, where it is one; shells complete it by that.
enum class ValueKind { text, file, folder, scene, method, change };

/// A verb's option, flag or argument as the help has it, for man pages and completions.
struct FlagFacts {
  std::vector<std::string> names;  ///< with their dashes; of an argument its one name
  std::string help;
  std::string usually;    ///< its value when it is not given, where the help shows one
  std::string value;      ///< what the help calls its value; empty: nothing in particular
  std::string variable;   ///< of the environment, that gives its value otherwise; empty: none
  bool argument = false;  ///< has no dashes, goes by its place
  bool required = false;
  bool takes_value = false;
  bool takes_list = false;     ///< several in one, with commas between them
  bool takes_several = false;  ///< of an argument: any number of them
  ValueKind kind = ValueKind::text;
  std::vector<std::string> words;  ///< that the value is one of; empty: any other
};

/// A verb as the help has it.
struct VerbFacts {
  std::string name, help, footer;
  std::vector<FlagFacts> flags;
};

/// The whole command line as the help has it, but for what is hidden.
struct ProgramFacts {
  std::string name, description, footer;
  std::vector<FlagFacts> flags;
  std::vector<VerbFacts> verbs;
};

/// What a command line asks for.
struct Asked {
  Action action;
  bool json = false;  ///< with --json
};

/// One of a verb's options, flags or arguments. Each call changes it and gives it back.
class Flag {
 public:
  explicit Flag(CLI::Option& option) : option_(&option) {}

  Flag* required();
  /// The help shows the value that its variable has now.
  Flag* capture_default_str();
  /// Of a list: each mention takes one value, which the help calls so.
  Flag* one_each(const std::string& value);
  /// Of a list: each mention takes one word, values with commas between them, which the help calls so.
  Flag* list(const std::string& values);
  /// Both together are an error.
  Flag* excludes(const Flag* other);
  /// What its value is a name of.
  Flag* names_a(ValueKind kind);
  /// Its value is a list with commas, taken apart by the verb itself.
  Flag* with_commas();
  /// The words that its value is one of. They are not checked here.
  Flag* one_of(std::vector<std::string> words);

  const CLI::Option& option() const { return *option_; }
  FlagFacts facts() const;

 private:
  CLI::Option* option_;
  ValueKind kind_ = ValueKind::text;
  bool with_commas_ = false;
  std::vector<std::string> words_;
};

/// A verb with its flags and its help. The variables behind the flags must live until the verb's action ran;
/// names read "-o,--output" for an option and "SCENE" for an argument.
class Verb {
 public:
  explicit Verb(CLI::App& parser) : parser_(&parser) {}

  Flag* add_option(const std::string& names, std::string& value, const std::string& help);
  Flag* add_option(const std::string& names, std::vector<std::string>& values, const std::string& help);
  Flag* add_flag(const std::string& names, bool& value, const std::string& help);
  /// Text below the flags in the help.
  void footer(const std::string& text);
  /// Leaves it out of the help: it is for other programs.
  void hide();
  /// What the verb does.
  void action(Action does) { action_ = std::move(does); }

  const CLI::App& parser() const { return *parser_; }
  const Action& action() const { return action_; }
  VerbFacts facts() const;

 private:
  CLI::App* parser_;
  std::deque<Flag> flags_;
  Action action_;
};

/// The verbs, and the parser that chooses among them; the parser itself is known to command_line.cpp alone.
class CommandLine {
 public:
  /// The version is asked for when --version is.
  CommandLine(const std::string& name, const std::string& description,
              const std::function<std::string()>& version);
  ~CommandLine();
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  Verb* add_subcommand(const std::string& name, const std::string& help);
  void footer(const std::string& text);
  /// An option that every verb has that was added before; without it, an environment variable gives its
  /// value.
  void add_everywhere(const std::string& names, const std::string& variable, std::string& value,
                      const std::string& help);
  /// What the arguments ask for; help and version are actions, too. Throws BadRequest where they make no
  /// sense.
  Asked parse(int argument_count, char** arguments);
  /// What there is to know of all that has been added, verbs in that order.
  ProgramFacts facts() const;

 private:
  std::unique_ptr<CLI::App> program_;
  std::deque<Verb> verbs_;
};

}  // namespace taut
