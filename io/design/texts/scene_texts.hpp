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

/// An edit or a file that is refused; what() is a sentence for the user.
struct Refused : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Characters of a file that others took the place of.
struct Edit {
  std::string file;           // name as in formats::Document::files()
  std::size_t at = 0;         // first byte
  std::string before, after;  // the texts there
};

/// The texts of a scene while it is designed. They are its only truth: a change of a value replaces the
/// characters of that value where the parser found it, so that comments, order and units of all others stay.
///
/// Own files are the scene and those of its includes that are below its folder, may be written, and do not
/// belong to the library. Values of other files are overridden in the scene. A scene of the library is opened
/// as a variant: a file in the working folder that includes it, and does not exist before save().
class SceneTexts {
 public:
  /// Throws formats::ReadError if the file cannot be read. `library`: the folder of the library; empty: none.
  SceneTexts(const std::filesystem::path& scene, const std::filesystem::path& library);

  const std::filesystem::path& file() const { return file_; }
  /// The texts of the own files, by their names.
  const formats::StoredTexts& own() const { return texts_; }
  /// The scene with its includes. Errors of the texts go to the diagnostics, whose sources have the order of
  /// the document's files.
  formats::Document document(formats::Diagnostics& diagnostics) const;

  /// Sets a value. `goes_on`: this is the same gesture as the edit before, such as the next step of a slider;
  /// both are undone together. Throws Refused if the texts have errors, or if the value cannot be set.
  Edit set(const formats::Change& change, bool goes_on = false);
  /// Replaces the whole text of an own file. Throws Refused if there is no such file.
  Edit replace(const std::string& file, std::string text, bool goes_on = false);
  bool can_undo() const { return done_ > 0; }
  bool can_redo() const { return done_ < edits_.size(); }
  /// Takes the last edit back, or makes it again; false if there is none.
  bool undo();
  bool redo();

  bool is_saved() const { return texts_ == saved_; }
  /// Writes the own files that have changed, and returns their names. Throws formats::WriteError, and Refused
  /// if another program has changed one of them since it was read.
  std::vector<std::string> save();
  /// Writes the scene under another name in its folder, with which the design goes on. Throws
  /// formats::WriteError, and Refused if the name is that of a file that exists, or not a plain name of a
  /// .toml file.
  void save_as(const std::string& name);
  /// Takes over files that other programs have changed, and returns their names. A file with edits that are
  /// not saved is left alone.
  std::vector<std::string> reread();

 private:
  void open_own(const std::filesystem::path& library);
  Edit edited(const formats::Document& document, const formats::Change& change,
              const formats::Value& wanted) const;
  Edit override_in_scene(const formats::Document& document, std::span<const formats::PathStep> path,
                         const formats::Value& value) const;
  void put(const Edit& edit);
  Edit keep(Edit edit, bool goes_on);

  std::filesystem::path file_;
  formats::StoredTexts texts_, saved_;
  std::vector<Edit> edits_;
  std::size_t done_ = 0;  // edits_ before this one are made, the others were taken back
};

}  // namespace netloft::design
