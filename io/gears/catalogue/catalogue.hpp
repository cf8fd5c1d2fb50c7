// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/diagnostics.hpp"
#include "io/formats/toml/document.hpp"
#include "io/gears/catalogue/part_kinds.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace netloft::gears {

/// One part as a catalogue describes it.
///
/// Fibres, wires and links fill only a fraction of the cross-section of a line; water fills the rest. An
/// element that treats a line as a homogeneous cylinder has the correct weight in water with the density
///   ρ = ρ_w + m/A (1 − ρ_w/ρ_m),   A = π d²/4      (1)
/// m [kg/m] mass per metre, ρ_m [kg/m³] density of the material, d [m] diameter, ρ_w = 1025 kg/m³. A part
/// that states ρ itself keeps this ρ instead of (1). The volume of a piece, such as a float, follows from its
/// mass:
///   V = m/ρ_m                                      (2)
struct CataloguePart {
  std::string name;
  const PartKind* kind = nullptr;
  std::map<std::string, double> numbers;         // numbers by key, in the units of the part's kind
  std::map<std::string, std::string> texts;      // source, uncertainty, …
  std::map<std::string, formats::Value> tables;  // tables, unchanged from the file
  std::string file;
};

/// All parts of some folders.
///
/// A folder holds any number of .toml files with tables `[KIND.NAME]`. `source` and `uncertainty` may be
/// given once at the head of a file, for all of its parts. If two folders have a part of the same kind and
/// name, the first folder has priority. A file may also have `synonyms`, groups of words that mean one
/// material, for proposals of names.
class Catalogue {
 public:
  /// Folders that do not exist are skipped. Errors are put into the diagnostics with their places.
  static Catalogue load(const std::vector<std::filesystem::path>& folders, formats::Diagnostics& diagnostics);

  static Catalogue load_file(const std::filesystem::path& file, formats::Diagnostics& diagnostics);

  /// Makes a catalogue from files that were read earlier, in the order of `files`, without opening any file.
  /// Files of one folder must be consecutive; files that are not TOML are skipped.
  static Catalogue recall(const std::vector<formats::SourceFile>& files, formats::Diagnostics& diagnostics);

  /// Adds `by` to the file index of every place in the catalogue. This is needed after the files of the
  /// catalogue were appended to the files of other diagnostics.
  void shift_files(int by);

  /// The part with this name and one of these kinds; nullptr if there is none.
  const CataloguePart* find(const std::string& name, const std::vector<std::string>& kinds) const;
  /// The parts in the order in which they were read.
  const std::vector<CataloguePart>& parts() const { return parts_; }
  /// Groups of words in part names that mean the same material, in lower case.
  const std::vector<std::vector<std::string>>& synonyms() const { return synonyms_; }
  const std::vector<formats::SourceFile>& files() const { return files_; }
  const std::vector<std::filesystem::path>& folders() const { return folders_; }

 private:
  void read_folder(const std::filesystem::path& folder, formats::Diagnostics& diagnostics);
  void read(const formats::Document& document, const std::filesystem::path& file, std::size_t first_of_folder,
            formats::Diagnostics& diagnostics);
  void add(CataloguePart part, const formats::Place& place, std::size_t first_of_folder,
           formats::Diagnostics& diagnostics);

  std::vector<CataloguePart> parts_;
  std::vector<std::vector<std::string>> synonyms_;
  std::vector<formats::SourceFile> files_;
  std::vector<std::filesystem::path> folders_;
};

/// Stores the last catalogue that was loaded, and its messages, so that folders are searched and files are
/// read only once.
class KeptCatalogue {
 public:
  /// The catalogue in the folders catalogue_folders(own). Its sources and messages are added to
  /// `diagnostics`.
  std::shared_ptr<const Catalogue> of(const std::vector<std::filesystem::path>& own,
                                      formats::Diagnostics& diagnostics);

 private:
  std::vector<std::filesystem::path> own_;
  formats::Diagnostics said_;  // messages from loading the catalogue
  int first_file_ = 0;         // index of the catalogue's first file in the `diagnostics` of the last call
  std::shared_ptr<const Catalogue> catalogue_;
};

}  // namespace netloft::gears
