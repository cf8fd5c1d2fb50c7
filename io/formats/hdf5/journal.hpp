// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "io/formats/hdf5/locked_file.hpp"

namespace netloft::formats {

/// A file to which records are only ever appended. All numbers are little-endian:
///
///   file    magic (8 bytes) | format (u32) | CRC-32 of these 12 bytes (u32) | records
///   record  length of the content (u64) | kind (u32) | CRC-32 of these 12 bytes (u32) | content |
///           CRC-32 of the content (u32)
///
/// Each record is written by one write(), so that a kill or a full disk destroys at most the last record. A
/// reader ignores an incomplete record at the end of the file, and zeros, which a power cut may leave. If any
/// other checksum does not match, the file is damaged.
class Journal {
 public:
  struct Record {
    std::uint32_t kind = 0;
    std::uint64_t place = 0, length = 0;  // position and length of the content in the file [bytes]
  };

  /// Creates an empty journal; replaces one that a killed writer left. Throws FileError while another process
  /// writes to it.
  static Journal create(const std::filesystem::path& path);
  using Visit = std::function<void(const Record&, std::string_view content)>;
  /// Opens an existing journal and visits all its records. Another process may still write to it: only the
  /// records that are complete now are read.
  static Journal read(const std::filesystem::path& path, const Visit& visit);
  /// Opens an existing journal to continue after its last complete record, or after the last record before
  /// damage(). The file does not change before the first append(). Throws FileError while another process
  /// writes to it, and if its head is damaged.
  static Journal go_on(const std::filesystem::path& path, const Visit& visit);

  const std::filesystem::path& path() const { return path_; }
  /// A sentence about the damage at which go_on() stopped reading; an empty text if the file is not damaged.
  const std::string& damage() const { return damage_; }
  /// If the file is damaged, the first append() keeps a copy of the old file under this name.
  std::filesystem::path path_of_damaged() const { return path_.string() + "~"; }
  /// Reads the content of a record and compares it with its checksum.
  std::string content(const Record& record) const;

  /// Appends a record. If the system fails to write it, throws FileError and removes the incomplete record.
  Record append(std::uint32_t kind, std::string_view content);
  void remove();

 private:
  Journal(std::filesystem::path path, Descriptor file) : path_(std::move(path)), file_(std::move(file)) {}
  void write_head();
  void read_head() const;
  void visit_records(const Visit& visit);
  bool visit_record_at(std::uint64_t place, std::uint64_t size, const Visit& visit);
  bool is_blank(std::uint64_t place, std::uint64_t size) const;
  void read_at(std::uint64_t place, void* data, std::size_t size) const;
  void write_at_end(std::string_view bytes);
  void cut_remainder_off();
  void keep_damaged() const;
  [[noreturn]] void reject(const std::string& reason) const;

  std::filesystem::path path_;
  Descriptor file_;
  std::uint64_t end_ = 0;       // end of the last complete record
  bool has_remainder_ = false;  // whether bytes after `end_` must be cut off before the next append
  std::string damage_;
  std::string buffer_;
};

bool is_journal(const std::filesystem::path& path);

}  // namespace netloft::formats
