// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/toml/number_words.hpp"
#include "io/runs/prepared_scene.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace netloft::python {

/// The plugins of this process, including solvers that are written in Python.
Registry& registry();

/// A lock that a thread holds while it reads scenes, because only one thread at a time may use the registry
/// and the data that changed scenes share. A thread that has the lock of the interpreter releases the
/// interpreter while it waits for this lock, because the reading thread may need the interpreter.
///
/// A thread that holds the lock may lock it again, and so may a thread for whose end it waits (LentReading).
/// This is necessary because a search holds the lock while it calls a solver in Python, which may open
/// scenes.
class ReadingLock {
 public:
  ReadingLock();
  ~ReadingLock();
  ReadingLock(const ReadingLock&) = delete;
  ReadingLock& operator=(const ReadingLock&) = delete;

  /// Whether this thread holds the lock or may use it as if it did.
  static bool is_held_here();

 private:
  bool is_first_;
};

/// While this object exists, its thread may use the lock of the thread that started it, if that thread holds
/// the lock and waits.
class LentReading {
 public:
  explicit LentReading(bool is_held_there);
  ~LentReading();
  LentReading(const LentReading&) = delete;
  LentReading& operator=(const LentReading&) = delete;
};

/// A scene that cannot be solved as it is, with the messages about it.
struct WrongScene : std::runtime_error {
  WrongScene(const formats::Diagnostics& all, bool is_refused);
  formats::Diagnostics diagnostics;
  bool refused;  // whether a plugin is missing or was rejected
};

/// A scene file with changes. Changed scenes share what was read from the file (scenes::SceneSource).
class OpenedScene {
 public:
  explicit OpenedScene(const std::filesystem::path& file) : source_(file) {}

  /// The same scene with other values, written like arguments of `--set`. A new value replaces an older value
  /// of the same key.
  OpenedScene with(const std::vector<std::string>& changes) const;
  /// The same scene, solved by another method: `key` and `specification` are arguments of
  /// runs::choose_method().
  OpenedScene by(const std::string& key, const std::string& specification) const;

  std::string file() const { return source_.scene.file().string(); }
  /// The changes so far, as arguments of `--set`.
  std::vector<std::string> changes() const;
  /// The words of the command line that solves the same scene.
  std::vector<std::string> command() const;
  /// The tables of the scene with its changes. Throws WrongScene.
  formats::Value tables() const;
  /// Facts about the numbers of the scene, by their paths, which are recorded while the scene is read. The
  /// scene is read again, which takes as long as the first time. Throws WrongScene.
  std::map<std::string, formats::NumberWords> words() const;
  /// All messages about the scene: errors and warnings.
  formats::Diagnostics check() const;
  /// The scene, ready to be solved, on its own mesh or on a mesh with the topology of `like`. Throws
  /// WrongScene.
  std::shared_ptr<runs::PreparedScene> prepare(const runs::PreparedScene* like = nullptr) const;

 private:
  void add(const formats::Change& change);

  runs::CaseSource source_;
};

}  // namespace netloft::python
