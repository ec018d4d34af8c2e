#include "man_pages.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <string_view>
#include <utility>

namespace taut {
namespace {

using Entry = std::pair<std::string_view, std::string_view>;

constexpr std::array<Entry, 8> exit_statuses{{
    {"0", "Done."},
    {"1", "Something failed while running. What was written before stays."},
    {"2", "Bad usage or a bad scene. Nothing was written."},
    {"3", "Part of what was asked for is missing."},
    {"4", "The output holds something else; --overwrite replaces it."},
    {"5", "verify found what is not as it was made."},
    {"130", "Interrupted. Frames made so far are kept."},
    {"129, 143, 152", "The same, by HUP (but under nohup), TERM or XCPU."},
}};

constexpr std::array<Entry, 4> variables{{
    {"TAUT_SCENES",
     "A folder of scenes that are found by their names before those that came with the program."},
    {"TAUT_CACHE", "Where references and chosen plans are kept [$XDG_CACHE_HOME/taut or ~/.cache/taut]."},
    {"SLURM_ARRAY_TASK_ID, SLURM_ARRAY_TASK_COUNT",
     "The part of the work that is done where --shard says nothing."},
    {"NO_COLOR", "Where it is set, progress has no colours."},
}};

constexpr std::array<Entry, 2> files{{
    {"PREFIX/share/taut/scenes", "The scenes that came with the program, PREFIX/bin being where it lies."},
    {"./scenes", "Scenes that are found by their names after those."},
}};

// Text as roff reads it: no letter of it is an instruction.
std::string roff(std::string_view text) {
  std::string escaped;
  for (const char letter : text) {
    const bool first = escaped.empty() || escaped.back() == '\n';
    if (first && (letter == '.' || letter == '\'')) escaped += "\\&";
    if (letter == '\\')
      escaped += "\\e";
    else if (letter == '-')
      escaped += "\\-";
    else if (letter == '`' || letter == '\'' || letter == '^' || letter == '~')
      escaped += letter == '`' ? "\\(ga" : letter == '\'' ? "\\(aq" : letter == '^' ? "\\(ha" : "\\(ti";
    else
      escaped += letter;
  }
  return escaped;
}

std::string heading(const std::string& name, const std::string& title, const std::string& version) {
  std::string upper = name;
  for (char& letter : upper)
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
  return fmt::format(".TH {} 1 \"\" \"taut {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n", roff(upper),
                     version, roff(name), roff(title));
}

std::string value_of(const FlagFacts& flag) {
  if (!flag.value.empty()) return flag.value;
  switch (flag.kind) {
    case ValueKind::file:
      return "FILE";
    case ValueKind::folder:
      return "FOLDER";
    case ValueKind::scene:
      return "SCENE";
    case ValueKind::method:
      return flag.takes_list ? "METHODS" : "METHOD";
    case ValueKind::change:
      return "KEY=VALUE";
    case ValueKind::text:
      break;
  }
  return "VALUE";
}

std::string named_entry(std::string_view name, std::string_view text) {
  return fmt::format(".TP\n.B {}\n{}\n", roff(name), roff(text));
}

std::string flag_entry(const FlagFacts& flag) {
  std::vector<std::string> names;
  for (const std::string& name : flag.names) names.push_back(fmt::format("\\fB{}\\fR", roff(name)));
  std::string text = fmt::format(".TP\n{}", fmt::join(names, ", "));
  if (flag.takes_value && !flag.argument) text += fmt::format(" \\fI{}\\fR", roff(value_of(flag)));
  text += "\n" + roff(flag.help);
  if (!flag.usually.empty()) text += fmt::format(" [{}]", roff(flag.usually));
  if (!flag.variable.empty()) text += fmt::format(" (Environment: {}.)", roff(flag.variable));
  return text + "\n";
}

// What a verb is called with: what it must have, and that it takes flags.
std::string synopsis(const std::string& program, const VerbFacts& verb) {
  std::string text = fmt::format(".SH SYNOPSIS\n\\fB{} {}\\fR", roff(program), roff(verb.name));
  for (const FlagFacts& flag : verb.flags) {
    const std::string_view more = flag.takes_several && flag.argument ? "…" : "";
    if (flag.argument && flag.required)
      text += fmt::format(" \\fI{}\\fR{}", roff(flag.names.front()), more);
    else if (flag.argument)
      text += fmt::format(" [\\fI{}\\fR{}]", roff(flag.names.front()), more);
    else if (flag.required)
      text += fmt::format(" \\fB{}\\fR \\fI{}\\fR", roff(flag.names.front()), roff(value_of(flag)));
  }
  return text + " [\\fIflags\\fR]\n";
}

// The help's text below the flags: remarks, and from a line "Example:" on what to type.
std::string remarks_and_example(const std::string& footer) {
  const std::size_t example = footer.find("Example:\n");
  std::string remarks = footer.substr(0, example);
  while (!remarks.empty() && remarks.back() == '\n') remarks.pop_back();
  std::string text;
  if (!remarks.empty()) text += fmt::format(".SH NOTES\n{}\n", roff(remarks));
  if (example == std::string::npos) return text;
  return text +
         fmt::format(".SH EXAMPLE\n.nf\n{}\n.fi\n", roff(footer.substr(footer.find('\n', example) + 1)));
}

std::string exit_status() {
  std::string text = ".SH EXIT STATUS\n";
  for (const auto& [status, meaning] : exit_statuses) text += named_entry(status, meaning);
  return text;
}

std::string verb_page(const ProgramFacts& program, const VerbFacts& verb, const std::string& version) {
  std::string text = heading(fmt::format("{}-{}", program.name, verb.name), verb.help, version);
  text += synopsis(program.name, verb);
  std::string arguments, flags;
  for (const FlagFacts& flag : verb.flags) (flag.argument ? arguments : flags) += flag_entry(flag);
  if (!arguments.empty()) text += ".SH ARGUMENTS\n" + arguments;
  text += ".SH OPTIONS\n" + flags;
  return text + remarks_and_example(verb.footer) + exit_status() +
         fmt::format(".SH SEE ALSO\n.BR {} (1)\n", roff(program.name));
}

std::string program_page(const ProgramFacts& program, const std::string& version) {
  // The description begins with the name, as a page does.
  const std::size_t colon = program.description.find(": ");
  const std::string title =
      colon == std::string::npos ? program.description : program.description.substr(colon + 2);
  std::string text = heading(program.name, title, version);
  text +=
      fmt::format(".SH SYNOPSIS\n\\fB{}\\fR \\fIverb\\fR [\\fIflags\\fR]\n.SH VERBS\n", roff(program.name));
  for (const VerbFacts& verb : program.verbs)
    text += fmt::format(".TP\n.BR {} (1)\n{}\n", roff(fmt::format("{}-{}", program.name, verb.name)),
                        roff(verb.help));
  text += ".SH OPTIONS\n";
  for (const FlagFacts& flag : program.flags) text += flag_entry(flag);
  text += remarks_and_example(program.footer) + exit_status() + ".SH ENVIRONMENT\n";
  for (const auto& [name, meaning] : variables) text += named_entry(name, meaning);
  text += ".SH FILES\n";
  for (const auto& [name, meaning] : files) text += named_entry(name, meaning);
  return text;
}

}  // namespace

std::vector<ManPage> man_pages(const ProgramFacts& program, const std::string& version) {
  std::vector<ManPage> pages{{fmt::format("{}.1", program.name), program_page(program, version)}};
  pages.reserve(program.verbs.size() + 1);
  for (const VerbFacts& verb : program.verbs)
    pages.push_back({fmt::format("{}-{}.1", program.name, verb.name), verb_page(program, verb, version)});
  return pages;
}

}  // namespace taut
