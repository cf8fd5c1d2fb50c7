// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/change.hpp"
#include "io/formats/toml/document.hpp"

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace netloft::design {

/// Thrown if an edit or a file is refused; what() is a sentence for the user.
struct Refused : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// The first error, as a sentence with its place and cure; empty if there is none.
std::string first_error_of(const formats::Diagnostics& diagnostics);

/// A replacement of characters in a file.
struct Edit {
  std::string file;           // name as in formats::Document::files()
  std::size_t at = 0;         // first byte
  std::string before, after;  // the texts there
};

/// The texts of a scene during a design. There is no other copy of the design: changing a value replaces the
/// characters of this value in the text, so that comments, order, and the units of other values are kept.
///
/// Own files are the scene and those included files that are below its folder, are writable, and do not
/// belong to the library. Values of other files are overridden in the scene. A scene of the library is opened
/// as a variant: a file in the working folder that includes the scene of the library, and that does not exist
/// before save().
class SceneTexts {
 public:
  /// Throws formats::ReadError if the file cannot be read. `library`: the folder of the library; empty: none.
  SceneTexts(const std::filesystem::path& scene, const std::filesystem::path& library);

  const std::filesystem::path& file() const { return file_; }
  /// The texts of the own files, by their names.
  const formats::StoredTexts& own() const { return texts_; }
  /// The scene with its includes. Errors in the texts are added to the diagnostics, whose sources have the
  /// order of the document's files.
  formats::Document document(formats::Diagnostics& diagnostics) const;

  /// Sets a value. `goes_on`: the edit continues the last one, like the next step of a slider; both are
  /// undone together. Throws Refused if the texts have errors, or if the value cannot be set.
  Edit set(const formats::Change& change, bool goes_on = false);
  /// Replaces the whole text of an own file. Throws Refused if there is no such file.
  Edit replace(const std::string& file, std::string text, bool goes_on = false);
  /// Changes texts so that the document equals `wanted` (rewriting.hpp); all edits are undone together.
  /// Throws Refused.
  std::vector<Edit> become(const formats::Value& wanted);
  bool can_undo() const { return done_ > 0; }
  bool can_redo() const { return done_ < steps_.size(); }
  /// undo() takes the last edit back, redo() makes it again. Both return false if there is none.
  bool undo();
  bool redo();

  bool is_saved() const { return texts_ == saved_; }
  /// Writes the own files that have changed, and returns their names. Throws formats::WriteError, and Refused
  /// if another program has changed one of them since it was read.
  std::vector<std::string> save();
  /// Writes the scene under another name in its folder. The design continues with this file. Throws
  /// formats::WriteError, and Refused if a file of this name exists, or if the name is not a plain name of a
  /// .toml file.
  void save_as(const std::string& name);
  /// Reads files again that other programs have changed, and returns their names. Skips files with unsaved
  /// edits.
  std::vector<std::string> reread();

 private:
  void open_own(const std::filesystem::path& library);
  Edit edited(const formats::Document& document, const formats::Change& change,
              const formats::Value& wanted) const;
  Edit override_in_scene(const formats::Document& document, std::span<const formats::PathStep> path,
                         const formats::Value& value) const;
  void put(const Edit& edit);
  Edit keep(Edit edit, bool goes_on);

  using Step = std::vector<Edit>;  // edits of different files that are undone together

  std::filesystem::path file_;
  formats::StoredTexts texts_, saved_;
  std::vector<Step> steps_;
  std::size_t done_ = 0;  // number of steps that are in force; later ones have been undone
};

}  // namespace netloft::design
