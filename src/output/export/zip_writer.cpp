#include "export/zip_writer.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <exception>
#include <string>
#include <utility>

#include "base/failure.h"

namespace taut {

struct ZipWriter::Archive {
  explicit Archive(std::function<void(std::string_view)> to)
      : write(std::move(to)), handle(::archive_write_new()) {}
  ~Archive() { ::archive_write_free(handle); }
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  std::function<void(std::string_view)> write;
  struct archive* handle;
  std::exception_ptr failure;  // what `write` threw, which must not go through the library
  bool given_up = false;       // nothing more reaches anybody
};

namespace {

// What the library calls with bytes of the archive. It never hears of a failure, which check() finds: of an
// archive that it knows to have failed it keeps the buffers for ever.
template <class Archive>
la_ssize_t take_bytes(struct archive* /*handle*/, void* data, const void* bytes, size_t size) {
  auto* archive = static_cast<Archive*>(data);
  try {
    if (!archive->failure && !archive->given_up)
      archive->write(std::string_view(static_cast<const char*>(bytes), size));
  } catch (...) {
    archive->failure = std::current_exception();
  }
  return static_cast<la_ssize_t>(size);
}

}  // namespace

ZipWriter::ZipWriter(std::function<void(std::string_view)> write)
    : archive_(std::make_unique<Archive>(std::move(write))) {
  struct archive* handle = archive_->handle;
  if (handle == nullptr) throw RunFailure("there is no memory for an archive");
  check(::archive_write_set_format_zip(handle));
  check(::archive_write_zip_set_compression_store(handle));
  check(::archive_write_set_bytes_in_last_block(handle, 1));  // nothing is filled up
  check(::archive_write_open(handle, archive_.get(), nullptr, take_bytes<Archive>, nullptr));
}

// An archive that was left half written is closed here: its last bytes must not reach anybody.
ZipWriter::~ZipWriter() {
  archive_->given_up = true;
}

void ZipWriter::check(long result) {
  if (archive_->failure) std::rethrow_exception(archive_->failure);
  if (result < ARCHIVE_WARN)
    throw RunFailure(fmt::format("can't write the archive: {}", ::archive_error_string(archive_->handle)));
}

void ZipWriter::begin(std::string_view name, std::uint64_t size) {
  constexpr unsigned int everyone_may_read = 0644;
  const std::unique_ptr<struct archive_entry, decltype(&::archive_entry_free)> entry(::archive_entry_new(),
                                                                                     &::archive_entry_free);
  ::archive_entry_set_pathname(entry.get(), std::string(name).c_str());
  ::archive_entry_set_filetype(entry.get(), AE_IFREG);
  ::archive_entry_set_perm(entry.get(), everyone_may_read);
  ::archive_entry_set_size(entry.get(), static_cast<la_int64_t>(size));
  check(::archive_write_header(archive_->handle, entry.get()));
}

void ZipWriter::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const la_ssize_t written = ::archive_write_data(archive_->handle, bytes.data(), bytes.size());
    check(written);
    if (written <= 0) throw RunFailure("can't write the archive: it takes no more");
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void ZipWriter::finish() {
  check(::archive_write_close(archive_->handle));
}

}  // namespace taut
