#include "export_choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/failure.h"
#include "choices.h"

namespace taut {
namespace {

const ExportFormat& format_asked_for(const ExportChoice& choice) {
  const ExportFormat* of_file = export_format_of_file(choice.output);
  if (choice.format.empty()) return of_file != nullptr ? *of_file : export_format("csv");
  const ExportFormat& format = export_format(choice.format);
  if (of_file != nullptr && of_file->name != format.name)
    throw BadRequest(fmt::format("{} has the ending of {}, and --format says {}", choice.output,
                                 of_file->name, format.name));
  return format;
}

void check_table(const ExportChoice& choice, const ExportFormat& format) {
  if (choice.table.empty() || format.tables) return;
  std::vector<std::string_view> with_tables;
  for (const ExportFormat& each : export_formats())
    if (each.tables) with_tables.push_back(each.name);
  throw BadRequest(fmt::format("--table goes with {}; {} has {}", fmt::join(with_tables, " and "),
                               format.name, format.carries));
}

void check_place(const ExportChoice& choice, const ExportFormat& format) {
  if (format.layout == ExportLayout::one_file) {
    std::error_code error;
    if (goes_to_stdout(choice)) {
      if (choice.output.empty() && !format.text)
        throw BadRequest(
            fmt::format("{} is no text: -o FILE says where it goes, -o - is standard output", format.name));
    } else if (std::filesystem::is_directory(choice.output, error)) {
      throw BadRequest(fmt::format("{} is a folder, and {} is one file: -o FILE{}", choice.output,
                                   format.name, format.ending));
    }
  } else if (goes_to_stdout(choice)) {
    throw BadRequest(fmt::format("{} is a folder of files: -o FOLDER says where they go", format.name));
  } else if (export_format_of_file(choice.output) != nullptr) {
    throw BadRequest(
        fmt::format("{} is a folder of files: -o names the folder, without {}", format.name, format.ending));
  }
}

}  // namespace

bool goes_to_stdout(const ExportChoice& choice) {
  return choice.output.empty() || choice.output == "-";
}

const ExportFormat& chosen_format(const ExportChoice& choice) {
  const ExportFormat& format = format_asked_for(choice);
  check_table(choice, format);
  check_place(choice, format);
  return format;
}

std::vector<std::string_view> export_format_names() {
  std::vector<std::string_view> names;
  for (const ExportFormat& format : export_formats()) names.push_back(format.name);
  return names;
}

ExportTable parse_export_table(const std::string& text) {
  if (text.empty()) return ExportTable::usual;
  constexpr std::array tables{ExportTable::masses, ExportTable::links, ExportTable::orientations,
                              ExportTable::energy};
  for (std::size_t i = 0; i < export_table_names.size(); ++i)
    if (text == export_table_names.at(i)) return tables.at(i);
  not_one_of("--table", text, export_table_names);
}

}  // namespace taut
