// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/seal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <functional>
#include <optional>
#include <string_view>

#include "io/formats/hdf5/checksum.hpp"
#include "io/formats/hdf5/locked_file.hpp"
#include "io/formats/hdf5/text_heaps.hpp"

namespace netloft::formats {
namespace {

constexpr std::string_view kTitle = "netloft checksums 1\n", kLastWord = "sealed ", kBetween = "*";
constexpr std::size_t kLastLine = 33;  // "sealed ", 16 digits, a blank, 8 digits, a line feed
constexpr std::size_t kSumAndEnd = 9;  // the 8 digits and the line feed
constexpr std::size_t kReadBlock = 1 << 20;

struct SealedFile {
  std::uint64_t length = 0;  // length of the sealed content [bytes]
  std::vector<SealedRange> ranges;
  std::vector<std::uint32_t> sums;  // checksums of the ranges
  std::uint32_t between = 0;        // checksum of all other bytes
};

/// The checksum of `length` bytes of a file from `place` on; `sum` is the checksum of the preceding bytes.
std::uint32_t checksum_of(int fd, std::uint64_t place, std::uint64_t length, std::uint32_t sum) {
  std::string block(std::min<std::uint64_t>(length, kReadBlock), '\0');
  while (length > 0) {
    const auto size = static_cast<std::size_t>(std::min<std::uint64_t>(length, kReadBlock));
    read_at(fd, place, block.data(), size);
    sum = checksum(std::string_view(block).substr(0, size), sum);
    place += size;
    length -= size;
  }
  return sum;
}

/// The checksums of the ranges, and of all bytes outside the ranges up to `length`.
SealedFile sum_up(int fd, const std::vector<SealedRange>& ranges, std::uint64_t length) {
  SealedFile file{length, ranges, {}, 0};
  std::uint64_t place = 0;
  for (const auto& range : ranges) {
    file.between = checksum_of(fd, place, range.place - place, file.between);
    file.sums.push_back(checksum_of(fd, range.place, range.length, 0));
    place = range.place + range.length;
  }
  file.between = checksum_of(fd, place, length - place, file.between);
  return file;
}

std::string hexadecimal(std::uint64_t value, int digits) {
  char text[24];
  std::snprintf(text, sizeof text, "%0*llx", digits, static_cast<unsigned long long>(value));
  return text;
}

/// Replaces line ends in a path, which may contain any character: the table has one line per path.
std::string in_one_line(std::string path) {
  for (char& c : path)
    if (static_cast<unsigned char>(c) < ' ') c = '?';
  return path;
}

std::string last_line(std::uint64_t length, std::uint32_t sum) {
  return std::string(kLastWord) + hexadecimal(length, 16) + " " + hexadecimal(sum, 8) + "\n";
}

std::string table_of(const SealedFile& file) {
  std::string table(kTitle);
  for (std::size_t i = 0; i < file.ranges.size(); ++i)
    table += hexadecimal(file.sums[i], 8) + " " + std::to_string(file.ranges[i].place) + " " +
             std::to_string(file.ranges[i].length) + " " + in_one_line(file.ranges[i].path) + "\n";
  table +=
      hexadecimal(file.between, 8) + " 0 " + std::to_string(file.length) + " " + std::string(kBetween) + "\n";
  const std::string summed = table + last_line(file.length, 0).substr(0, kLastLine - kSumAndEnd);
  return table + last_line(file.length, checksum(summed));
}

/// Removes a number, and the blank after it, from the beginning of a text, and returns the number. Throws
/// FileError if the text does not begin with a number.
std::uint64_t take_number(std::string_view& text, int base) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  const auto used = static_cast<std::size_t>(end - text.data());
  if (error != std::errc() || used >= text.size())
    throw FileError("it is damaged: its checksums cannot be read");
  text.remove_prefix(used + 1);
  return value;
}

/// Reads the lines of the table between the title and the last line. The caller must have compared the
/// checksum of these lines.
SealedFile parse(std::string_view lines, std::uint64_t length) {
  SealedFile file;
  file.length = length;
  std::uint64_t place = 0;
  while (!lines.empty()) {
    std::string_view line = lines.substr(0, lines.find('\n'));
    lines.remove_prefix(std::min(line.size() + 1, lines.size()));
    const auto sum = static_cast<std::uint32_t>(take_number(line, 16));
    SealedRange range{"", take_number(line, 10), take_number(line, 10)};
    range.path = line;
    if (range.path == kBetween) {
      file.between = sum;
      return file;
    }
    if (range.place < place || range.place > length || range.length > length - range.place)
      throw FileError("it is damaged: its table of checksums names bytes out of order or beyond its end");
    place = range.place + range.length;
    file.ranges.push_back(std::move(range));
    file.sums.push_back(sum);
  }
  throw FileError("it is damaged: its checksums are not complete");
}

/// The table at the end of a file; nullopt if the file has none.
std::optional<SealedFile> read_seal(int fd) {
  const std::uint64_t size = size_of(fd);
  if (size < kLastLine) return {};
  std::string last(kLastLine, '\0');
  read_at(fd, size - kLastLine, last.data(), kLastLine);
  if (!last.starts_with(kLastWord) || last.back() != '\n') return {};
  std::string_view numbers = std::string_view(last).substr(kLastWord.size());
  const std::uint64_t length = take_number(numbers, 16), sum = take_number(numbers, 16);
  if (last !=
      last_line(length, static_cast<std::uint32_t>(sum)))  // the checksum is not written in the form of
                                                           // append_seal(), for example "A" instead of "a"
    throw FileError("it is damaged: its checksums cannot be read");
  if (length > size - kLastLine) throw FileError("it is damaged: its checksums would begin beyond its end");
  std::string table(size - length, '\0');
  read_at(fd, length, table.data(), table.size());
  const std::string_view summed = std::string_view(table).substr(0, table.size() - kSumAndEnd);
  if (!summed.starts_with(kTitle) || checksum(summed) != sum)
    throw FileError("it is damaged: the checksums at its end do not match their own");
  return parse(summed.substr(kTitle.size(), table.size() - kLastLine - kTitle.size()), length);
}

struct Search {
  std::string path;  // path of the group
  std::vector<SealedRange> ranges;
};

/// Adds the byte ranges of the object `name`: of a dataset, or of all datasets in a group. H5Ovisit() is not
/// used, because it would follow the whole path of every object.
herr_t add_ranges(hid_t group, const char* name, const H5L_info_t* link, void* data) {
  if (link->type != H5L_TYPE_HARD) return 0;
  Search& search = *static_cast<Search*>(data);
  const hid_t object = H5Oopen(group, name, H5P_DEFAULT);
  if (object < 0) return -1;
  herr_t done = 0;
  if (H5Iget_type(object) == H5I_DATASET) {
    const haddr_t place = H5Dget_offset(object);
    const hsize_t length = H5Dget_storage_size(object);
    if (place != HADDR_UNDEF && length > 0) search.ranges.push_back({search.path + name, place, length});
  } else if (H5Iget_type(object) == H5I_GROUP) {
    const std::size_t above = search.path.size();
    search.path += std::string(name) + "/";
    done = H5Literate(object, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, add_ranges, &search);
    search.path.resize(above);
  }
  return H5Oclose(object) < 0 ? -1 : done;
}

}  // namespace

std::vector<SealedRange> find_ranges(hid_t file) {
  Search search{"/", {}};
  check(H5Literate(file, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, add_ranges, &search));
  H5Eclear2(H5E_DEFAULT);  // HDF5 records an error for chunked datasets, which have no offset
  std::sort(search.ranges.begin(), search.ranges.end(),
            [](const SealedRange& a, const SealedRange& b) { return a.place < b.place; });
  return std::move(search.ranges);
}

void append_seal(int fd, const std::vector<SealedRange>& ranges) {
  const std::uint64_t length = size_of(fd);
  const std::string table = table_of(sum_up(fd, ranges, length));
  std::string_view rest = table;
  while (!rest.empty()) {
    const ssize_t written =
        pwrite(fd, rest.data(), rest.size(), static_cast<off_t>(length + table.size() - rest.size()));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) throw FileError(written < 0 ? system_reason() : "nothing was written");
    rest.remove_prefix(static_cast<std::size_t>(written));
  }
}

void check_seal(const std::filesystem::path& path) {
  const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0) return;  // HDF5 reports the reason
  with_context("cannot read " + path.string(), [&] {
    const auto sealed = read_seal(file.get());
    if (!sealed) return check_text_heaps(file.get());
    const SealedFile now = sum_up(file.get(), sealed->ranges, sealed->length);
    for (std::size_t i = 0; i < now.sums.size(); ++i)
      if (now.sums[i] != sealed->sums[i])
        throw FileError("it is damaged: " + now.ranges[i].path + " does not match its checksum");
    if (now.between != sealed->between)
      throw FileError("it is damaged: its names, texts or attributes do not match their checksum");
  });
}

}  // namespace netloft::formats
