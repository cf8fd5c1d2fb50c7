// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "io/formats/toml/diagnostics.hpp"
#include "io/formats/toml/value.hpp"

namespace netloft::formats {

/// A file that was read, for the record of a run.
struct SourceFile {
  std::string path;  // the path of the root as given, or that of an include relative to the including file
  std::string text;
  std::string hash;  // "fnv1a64:" and 16 hexadecimal digits: distinguishes versions, is not a signature
};

/// Texts that are used instead of files, by their normalised names (as in Document::files()).
using StoredTexts = std::map<std::string, std::string>;

/// A scene file with its includes and the overrides of the command line, as one table.
///
/// `include = ["a.toml", …]` names files relative to the including file. Files are merged in this order, and
/// the keys of the including file last: tables merge, `[[hold]]` appends, everything else replaces. A file
/// that is named several times is read once, at its first mention. `without = ["floats.headline", …]` leaves
/// tables and keys of the included files out, before the keys of the including file are merged. Overrides
/// ("path=value") come last.
class Document {
 public:
  /// Errors go to `diagnostics`; after an error the document contains whatever could be read.
  static Document load(const std::filesystem::path& path, const std::vector<std::string>& overrides,
                       Diagnostics& diagnostics);
  /// Loads a file without overrides. If a name is in `edited`, its text is used, and the file is not opened.
  static Document load_edited(const std::filesystem::path& path, const StoredTexts& edited,
                              Diagnostics& diagnostics);
  /// Parses a text in memory; includes are relative to the working directory.
  static Document parse(std::string text, const std::string& name, const std::vector<std::string>& overrides,
                        Diagnostics& diagnostics);

  /// Merges files that were read earlier, in the order of files(), without opening any file. An included file
  /// that is not among them is an error.
  static Document recall(std::vector<SourceFile> files, Diagnostics& diagnostics);

  /// The complete table, without `include` and `without`.
  const Value& root() const { return root_; }
  /// The root file, then the includes in the order in which they were read.
  const std::vector<SourceFile>& files() const { return files_; }

 private:
  Value root_;
  std::vector<SourceFile> files_;
};

/// FNV-1a, 64 bits: h ← (h ⊕ byte)·1099511628211 from 14695981039346656037 (Fowler, Noll, Vo; IETF
/// draft-eastlake-fnv).
std::string fnv1a64(std::string_view text);

}  // namespace netloft::formats
