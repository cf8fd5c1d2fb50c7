// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/journal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "io/formats/hdf5/bytes.hpp"
#include "io/formats/hdf5/checksum.hpp"

namespace netloft::formats {
namespace fs = std::filesystem;
namespace {

// The first byte is not a text character. The line ends reveal a file transfer that converts line ends.
constexpr std::string_view kMagic = "\x89NLJ\r\n\x1a\n";
constexpr std::uint32_t kFormat = 2;  // in format 1, every output has all fields
constexpr std::size_t kHead = 16, kTail = 4;

template <class Number>
void put(std::string& bytes, Number value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Appends the checksum of the first 12 bytes of a head.
void close_head(std::string& bytes) { put(bytes, checksum(std::string_view(bytes).substr(0, kHead - 4))); }

bool is_whole_head(std::string_view head) {
  return number_at<std::uint32_t>(head, kHead - 4) == checksum(head.substr(0, kHead - 4));
}

Descriptor open_to_read(const fs::path& path) {
  Descriptor fd(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (fd.get() < 0) throw FileError("cannot read " + path.string() + ": " + system_reason());
  return fd;
}

/// Reports a damaged record; all records before it are complete.
struct Damage : FileError {
  Damage(const fs::path& path, const std::string& what_is_wrong)
      : FileError("cannot read " + path.string() + ": " + what_is_wrong), found(what_is_wrong) {}
  std::string found;
};

void sync(const fs::path& path) {
  const Descriptor fd(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (fd.get() < 0 || fsync(fd.get()) != 0)
    throw FileError("cannot write " + path.string() + ": " + system_reason());
}

}  // namespace

Journal Journal::create(const fs::path& path) {
  Journal journal(path, take_file(path));
  if (ftruncate(journal.file_.get(), 0) != 0)
    throw FileError("cannot write " + path.string() + ": " + system_reason());
  journal.write_head();
  return journal;
}

Journal Journal::read(const fs::path& path, const Visit& visit) {
  Journal journal(path, open_to_read(path));
  journal.visit_records(visit);
  return journal;
}

Journal Journal::go_on(const fs::path& path, const Visit& visit) {
  Journal journal(path, take_existing_file(path));
  try {
    journal.visit_records(visit);
  } catch (const Damage& damage) {
    journal.damage_ = damage.found;
    journal.has_remainder_ = true;
  }
  return journal;
}

void Journal::write_head() {
  buffer_ = kMagic;
  put(buffer_, kFormat);
  close_head(buffer_);
  write_at_end(buffer_);
}

void Journal::read_head() const {
  if (size_of(file_.get()) < kHead) reject("it ends before its first record");
  std::array<char, kHead> bytes{};
  read_at(0, bytes.data(), kHead);
  const std::string_view head(bytes.data(), kHead);
  if (!head.starts_with(kMagic)) reject("it is not the journal of a motion");
  if (!is_whole_head(head)) reject("it is damaged: its first bytes do not match their checksum");
  const auto format = number_at<std::uint32_t>(head, kMagic.size());
  if (format > kFormat)
    reject("it was written by a newer netloft, in format " + std::to_string(format) +
           "; this program reads format " + std::to_string(kFormat));
}

void Journal::visit_records(const Visit& visit) {
  read_head();
  const std::uint64_t size = size_of(file_.get());
  end_ = kHead;
  while (visit_record_at(end_, size, visit)) {
  }
  has_remainder_ = end_ < size;
}

/// Visits the record at `place`. Returns false if the rest of the file is an incomplete record.
bool Journal::visit_record_at(std::uint64_t place, std::uint64_t size, const Visit& visit) {
  if (size - place < kHead) return false;
  std::array<char, kHead> bytes{};
  read_at(place, bytes.data(), kHead);
  const std::string_view head(bytes.data(), kHead);
  if (!is_whole_head(head)) {
    if (is_blank(place, size)) return false;
    throw Damage(path_, "it is damaged: the head of the record at byte " + std::to_string(place) +
                            " does not match its checksum");
  }
  const Record record{number_at<std::uint32_t>(head, 8), place + kHead, number_at<std::uint64_t>(head, 0)};
  const std::uint64_t rest = size - record.place;
  if (rest < kTail || record.length > rest - kTail) return false;
  visit(record, content(record));
  end_ = record.place + record.length + kTail;
  return true;
}

bool Journal::is_blank(std::uint64_t place, std::uint64_t size) const {
  std::array<char, 4096> block;
  for (; place < size; place += block.size()) {
    const auto length = static_cast<std::size_t>(std::min<std::uint64_t>(block.size(), size - place));
    read_at(place, block.data(), length);
    if (std::any_of(block.begin(), block.begin() + static_cast<std::ptrdiff_t>(length),
                    [](char byte) { return byte != 0; }))
      return false;
  }
  return true;
}

std::string Journal::content(const Record& record) const {
  std::string bytes(record.length + kTail, '\0');
  read_at(record.place, bytes.data(), bytes.size());
  const auto expected = number_at<std::uint32_t>(bytes, record.length);
  bytes.resize(record.length);
  if (checksum(bytes) != expected)
    throw Damage(path_, "it is damaged: the record at byte " + std::to_string(record.place) +
                            " does not match its checksum");
  return bytes;
}

void Journal::read_at(std::uint64_t place, void* data, std::size_t size) const {
  auto* to = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t got = pread(file_.get(), to, size, static_cast<off_t>(place));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) reject(system_reason());
    if (got == 0) reject("it became shorter while it was read");
    to += got;
    size -= static_cast<std::size_t>(got);
    place += static_cast<std::uint64_t>(got);
  }
}

Journal::Record Journal::append(std::uint32_t kind, std::string_view content) {
  if (has_remainder_) cut_remainder_off();
  buffer_.clear();
  put(buffer_, std::uint64_t{content.size()});
  put(buffer_, kind);
  close_head(buffer_);
  buffer_ += content;
  put(buffer_, checksum(content));
  const std::uint64_t place = end_ + kHead;
  write_at_end(buffer_);
  return {kind, place, content.size()};
}

void Journal::cut_remainder_off() {
  if (!damage_.empty()) keep_damaged();
  if (ftruncate(file_.get(), static_cast<off_t>(end_)) != 0)
    throw FileError("cannot write " + path_.string() + ": " + system_reason());
  has_remainder_ = false;
}

/// Keeps a copy of the damaged file, because another program may be able to read records after the damage.
void Journal::keep_damaged() const {
  const fs::path name = path_of_damaged(), beside = name.string() + ".new";
  std::error_code error;
  if (!fs::copy_file(path_, beside, fs::copy_options::overwrite_existing, error))
    throw FileError("cannot write " + beside.string() + ": " + error.message());
  sync(beside);
  fs::rename(beside, name);
}

void Journal::write_at_end(std::string_view bytes) {
  for (std::uint64_t place = end_; !bytes.empty();) {
    const ssize_t written = pwrite(file_.get(), bytes.data(), bytes.size(), static_cast<off_t>(place));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      const std::string reason = written < 0 ? system_reason() : "nothing was written";
      has_remainder_ = ftruncate(file_.get(), static_cast<off_t>(end_)) != 0;
      throw FileError("cannot write " + path_.string() + ": " + reason);
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
    place += static_cast<std::uint64_t>(written);
    if (bytes.empty()) end_ = place;
  }
}

void Journal::remove() { unlink(path_.c_str()); }

void Journal::reject(const std::string& reason) const {
  throw FileError("cannot read " + path_.string() + ": " + reason);
}

bool is_journal(const fs::path& path) {
  std::error_code none;
  if (!fs::is_regular_file(path, none)) return false;
  std::array<char, kMagic.size()> bytes{};
  std::ifstream(path, std::ios::binary).read(bytes.data(), bytes.size());
  return std::string_view(bytes.data(), bytes.size()) == kMagic;
}

}  // namespace netloft::formats
