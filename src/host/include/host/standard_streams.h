#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string_view>
#include <utility>

namespace taut {

/// Opens whichever of standard input, output and error this process was started without, in such a way that
/// nothing can be written into it. To be called before anything else opens a file, which would otherwise take
/// the place of one of them, and get what is meant for it.
void fill_standard_streams();

/// Writes text to standard output. Throws RunFailure with the system's reason where it takes no more.
void write_result(std::string_view text);

/// Writes to standard output what a command line asked for. Throws RunFailure as write_result() does.
template <class... Parts>
void print_result(fmt::format_string<Parts...> format, Parts&&... parts) {
  write_result(fmt::format(format, std::forward<Parts>(parts)...));
}

/// Sees to it that all results have arrived where standard output goes. Throws RunFailure with the system's
/// reason where they have not.
void finish_results();

/// Shows text to whoever looks at that stream. Where it can't be written nobody looks, and that is no fault.
void show_text(std::FILE* stream, std::string_view text);

/// Tells whoever looks at standard error. Where that can't be written nobody looks, and that is no fault.
template <class... Parts>
void tell(fmt::format_string<Parts...> format, Parts&&... parts) {
  show_text(stderr, fmt::format(format, std::forward<Parts>(parts)...));
}

}  // namespace taut
