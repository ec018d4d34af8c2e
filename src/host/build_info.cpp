#include "host/build_info.h"

#include <elf.h>
#include <fmt/format.h>
#include <link.h>

#include <cstdint>
#include <cstring>
#include <span>

namespace taut {
namespace {

// The notes of one segment are records of two lengths, a type, a name and the content, each padded to four
// bytes.
std::string identifier_in(const std::uint8_t* notes, std::size_t size) {
  const auto padded = [](std::size_t length) { return (length + 3) / 4 * 4; };
  std::size_t at = 0;
  while (at + sizeof(ElfW(Nhdr)) <= size) {
    ElfW(Nhdr) note;
    std::memcpy(&note, notes + at, sizeof note);
    const std::size_t content = at + sizeof note + padded(note.n_namesz);
    if (note.n_type == NT_GNU_BUILD_ID && content + note.n_descsz <= size) {
      std::string text;
      for (const std::uint8_t byte : std::span(notes + content, note.n_descsz))
        text += fmt::format("{:02x}", byte);
      return text;
    }
    at = content + padded(note.n_descsz);
  }
  return {};
}

// The linker's identifier, a hash of the whole program. The first object that is listed is the program
// itself.
std::string linker_identifier() {
  std::string identifier;
  const auto look = [](dl_phdr_info* object, std::size_t, void* found) {
    for (const auto& header : std::span(object->dlpi_phdr, object->dlpi_phnum)) {
      if (header.p_type != PT_NOTE) continue;
      // NOLINTNEXTLINE(performance-no-int-to-ptr): an address as the loader gives it
      const auto* notes = reinterpret_cast<const std::uint8_t*>(object->dlpi_addr + header.p_vaddr);
      auto& text = *static_cast<std::string*>(found);
      if (text.empty()) text = identifier_in(notes, header.p_memsz);
    }
    return 1;
  };
  ::dl_iterate_phdr(look, &identifier);
  return identifier.empty() ? "unknown" : identifier;
}

}  // namespace

std::string build_info() {
#if defined(__clang__)
  const std::string compiler = "clang " __clang_version__;
#else
  const std::string compiler = "g++ " __VERSION__;
#endif
  return fmt::format("taut {}, {}, {}, {}", version(), compiler, TAUT_BUILD_TYPE, linker_identifier());
}

std::string version() {
  return TAUT_VERSION;
}

}  // namespace taut
