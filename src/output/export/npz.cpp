// NumPy's format of arrays, version 1.0 (numpy.lib.format): a magic number, a header that is a dictionary of
// Python's, padded so that what follows is aligned, and the array as it lies in memory. An NPZ file is a ZIP
// archive of them.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/bytes.h"
#include "base/utf8.h"
#include "export/binary.h"
#include "export/formats.h"
#include "export/scratch_file.h"
#include "export/zip_writer.h"
#include "model/orientation.h"
#include "output/export.h"

namespace taut {
namespace {

// One array: of its rows some may lie in the scratch file, where it grows with time, the rest in `bytes`.
struct NpyArray {
  std::string name, type, row_shape;  // the shape of a row as numpy writes it: "" or " 3"
  std::size_t rows = 0;
  std::string bytes;
  struct Piece {
    std::uint64_t offset, size;
  };
  std::vector<Piece> pieces;

  std::uint64_t size() const {
    std::uint64_t sum = bytes.size();
    for (const Piece& piece : pieces) sum += piece.size;
    return sum;
  }
};

std::string npy_header(const NpyArray& array) {
  constexpr std::size_t alignment = 64, before_dictionary = 10;
  std::string dictionary = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({},{}), }}",
                                       array.type, array.rows, array.row_shape);
  const std::size_t size = before_dictionary + dictionary.size() + 1;
  dictionary.append((alignment - size % alignment) % alignment, ' ');
  dictionary += '\n';
  std::string header = std::string("\x93NUMPY\x01\0", 8);
  append_bytes(static_cast<std::uint16_t>(dictionary.size()), header);
  return header + dictionary;
}

// The code points of a text in UTF-8.
std::u32string code_points(std::string_view text) {
  std::u32string points;
  while (!text.empty()) {
    const std::size_t length = std::max<std::size_t>(utf8_length(text), 1);
    const auto first = static_cast<unsigned char>(text.front());
    char32_t point = length == 1 ? first : first & (0xffU >> (length + 1));
    for (const char next : text.substr(1, length - 1))
      point = point << 6U | (static_cast<unsigned char>(next) & 0x3fU);
    points += point;
    text.remove_prefix(length);
  }
  return points;
}

NpyArray array_of_texts(std::string name, const std::vector<std::string>& texts) {
  std::vector<std::u32string> points;
  points.reserve(texts.size());
  std::size_t longest = 1;
  for (const std::string& text : texts)
    longest = std::max(longest, points.emplace_back(code_points(text)).size());
  NpyArray array{std::move(name), fmt::format("<U{}", longest), "", texts.size(), "", {}};
  for (std::u32string& text : points) {
    text.resize(longest, U'\0');
    for (const char32_t point : text) append_bytes(static_cast<std::uint32_t>(point), array.bytes);
  }
  return array;
}

NpyArray array_of_numbers(std::string name, const std::vector<double>& numbers) {
  NpyArray array{std::move(name), "<f8", "", numbers.size(), "", {}};
  for (const double number : numbers) append_bytes(number, array.bytes);
  return array;
}

NpyArray masses_pinned(const Masses& masses) {
  NpyArray array{"pinned", "|b1", "", masses.size(), "", {}};
  for (std::size_t i = 0; i < masses.size(); ++i) array.bytes += masses.pinned(i) ? '\1' : '\0';
  return array;
}

NpyArray link_ends(const Links& links) {
  NpyArray array{"link_ends", "<i8", " 2", links.size(), "", {}};
  for (std::size_t i = 0; i < links.size(); ++i)
    for (const Index end : {links.a[i], links.b[i]}) append_bytes(std::int64_t{end}, array.bytes);
  return array;
}

NpyArray link_families(const Links& links) {
  std::vector<std::string> names;
  names.reserve(links.size());
  for (const LinkFamily family : links.family)
    names.emplace_back(family == LinkFamily::structural  ? "structural"
                       : family == LinkFamily::diagonals ? "diagonals"
                                                         : "skip_one");
  return array_of_texts("link_family", names);
}

NpyArray triangle_corners(const Model& model) {
  NpyArray array{"triangles", "<i8", " 3", model.triangles.size(), "", {}};
  for (const Triangle& triangle : model.triangles)
    for (const Index corner : triangle.masses) append_bytes(std::int64_t{corner}, array.bytes);
  return array;
}

class NpzExport : public MotionExport {
 public:
  NpzExport(const ExportSubject& subject, const ExportTarget& target)
      : subject_(subject), write_(target.write), scratch_(target.folder) {
    frame_ = grows("frame", "<i8", "");
    time_ = grows("time", "<f8", "");
    const std::size_t masses = subject.model.masses.size(), links = subject.model.links.size();
    if (holds(ExportTable::masses)) add_masses(masses);
    if (holds(ExportTable::links)) add_links(links);
    if (subject.table == ExportTable::orientations) {
      arrays_.push_back(array_of_texts("name", subject.model.masses.name));
      orientation_ = grows("orientation", "<f8", fmt::format(" {}, 4", masses));
    }
    if (subject.table == ExportTable::energy)
      for (const char* name : {"kinetic", "potential", "elastic", "total", "pin_work", "load_work",
                               "contact_work", "broken_energy"})
        energies_.push_back(grows(name, "<f8", ""));
  }

  void add(const ExportMoment& moment) override {
    put(frame_, [&](std::string& bytes) { append_bytes(std::int64_t{moment.frame}, bytes); });
    put(time_, [&](std::string& bytes) { append_bytes(moment.state.time, bytes); });
    if (position_ != nullptr) put_masses(moment.state);
    if (tension_ != nullptr) put_links(moment);
    if (orientation_ != nullptr) put_orientations(moment.state);
    if (!energies_.empty()) put_energies(*moment.measures);
  }

  void finish() override {
    if (tension_ != nullptr) arrays_.push_back(array_of_numbers("broken_at", broken_at_));
    ZipWriter zip(write_);
    for (const NpyArray& array : arrays_) {
      const std::string header = npy_header(array);
      zip.begin(array.name + ".npy", header.size() + array.size());
      zip.write(header);
      zip.write(array.bytes);
      for (const NpyArray::Piece& piece : array.pieces)
        scratch_.copy(piece.offset, piece.size, [&](std::string_view bytes) { zip.write(bytes); });
    }
    zip.finish();
  }

 private:
  bool holds(ExportTable table) const {
    return subject_.table == table || subject_.table == ExportTable::usual;
  }

  void add_masses(std::size_t count) {
    const Masses& masses = subject_.model.masses;
    arrays_.push_back(array_of_texts("name", masses.name));
    arrays_.push_back(array_of_numbers("mass", masses.mass));
    arrays_.push_back(array_of_numbers("radius", masses.radius));
    arrays_.push_back(masses_pinned(masses));
    arrays_.push_back(triangle_corners(subject_.model));
    position_ = grows("position", "<f8", fmt::format(" {}, 3", count));
    velocity_ = grows("velocity", "<f8", fmt::format(" {}, 3", count));
  }

  void add_links(std::size_t count) {
    arrays_.push_back(link_ends(subject_.model.links));
    arrays_.push_back(link_families(subject_.model.links));
    arrays_.push_back(array_of_numbers("rest_length", subject_.model.links.length));
    tension_ = grows("tension", "<f8", fmt::format(" {}", count));
    broken_ = grows("broken", "|b1", fmt::format(" {}", count));
  }

  // An array with a row for each instant.
  NpyArray* grows(std::string name, std::string type, std::string row_shape) {
    return &arrays_.emplace_back(NpyArray{std::move(name), std::move(type), std::move(row_shape), 0, "", {}});
  }

  void put(NpyArray* array, const std::function<void(std::string&)>& append) {
    std::string bytes;
    append(bytes);
    array->pieces.push_back({scratch_.size(), bytes.size()});
    scratch_.append(bytes);
    ++array->rows;
  }

  void put_masses(const State& state) {
    for (const auto& [array, vectors] :
         {std::pair(position_, &state.position), std::pair(velocity_, &state.velocity)}) {
      const Vectors& these = *vectors;
      put(array, [&these](std::string& bytes) {
        for (std::size_t i = 0; i < these.size(); ++i) append_bytes(these.at(i), bytes);
      });
    }
  }

  void put_links(const ExportMoment& moment) {
    const State& state = moment.state;
    broken_at_ = state.broken_at;
    put(tension_, [&](std::string& bytes) {
      for (std::size_t i = 0; i < state.tension.size(); ++i) {
        const bool known = moment.tension_known && !state.broken(i);
        append_bytes(known ? state.tension[i] : std::numeric_limits<double>::quiet_NaN(), bytes);
      }
    });
    put(broken_, [&](std::string& bytes) {
      for (std::size_t i = 0; i < state.broken_at.size(); ++i) bytes += state.broken(i) ? '\1' : '\0';
    });
  }

  void put_orientations(const State& state) {
    put(orientation_, [&](std::string& bytes) {
      for (const Eigen::Quaterniond& turn : orientations(subject_.model, subject_.start, state))
        for (const double part : {turn.w(), turn.x(), turn.y(), turn.z()}) append_bytes(part, bytes);
    });
  }

  void put_energies(const RunMeasures& now) {
    const std::array values{now.energy.kinetic, now.energy.potential, now.energy.elastic, now.energy.total(),
                            now.pin_work,       now.load_work,        now.contact_work,   now.broken_energy};
    for (std::size_t i = 0; i < values.size(); ++i)
      put(energies_[i], [&](std::string& bytes) { append_bytes(values.at(i), bytes); });
  }

  ExportSubject subject_;
  std::function<void(std::string_view)> write_;
  ScratchFile scratch_;
  std::deque<NpyArray> arrays_;  // which stay where they are
  NpyArray *frame_ = nullptr, *time_ = nullptr, *position_ = nullptr, *velocity_ = nullptr,
           *tension_ = nullptr, *broken_ = nullptr, *orientation_ = nullptr;
  std::vector<NpyArray*> energies_;
  std::vector<double> broken_at_;  // s
};

std::unique_ptr<MotionExport> make_npz(const ExportSubject& subject, const ExportTarget& target) {
  return std::make_unique<NpzExport>(subject, target);
}

}  // namespace

const ExportFormat npz_format{
    .name = "npz",
    .ending = ".npz",
    .carries = "masses and links over time as arrays, or orientations or energies, exactly",
    .summary = "for NumPy",
    .tables = true,
    .make = make_npz};

}  // namespace taut
