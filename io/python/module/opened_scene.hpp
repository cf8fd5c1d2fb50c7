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

/// The plugins of this process. Solvers that are written in Python are among them.
Registry& registry();

/// Held while scenes are read: the registry, and the data that changed scenes share, serve one thread only. A
/// thread that has the lock of the interpreter gives it back while it waits, because the reader may want it.
///
/// A thread that holds the lock may ask for it again, and so may one for which it waits (LentReading): a
/// search holds it while a solver in Python, which it calls, opens scenes.
class ReadingLock {
 public:
  ReadingLock();
  ~ReadingLock();
  ReadingLock(const ReadingLock&) = delete;
  ReadingLock& operator=(const ReadingLock&) = delete;

  /// Whether this thread may read without waiting.
  static bool is_held_here();

 private:
  bool is_first_;
};

/// While this object lives, this thread has what the thread that started it, and waits for it, had of the
/// lock.
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

  /// The same scene with other values, each as the argument of `--set`. A new value replaces an older one of
  /// the same key.
  OpenedScene with(const std::vector<std::string>& changes) const;
  /// The same scene, solved by another method: `key` and `specification` are those of runs::choose_method().
  OpenedScene by(const std::string& key, const std::string& specification) const;

  std::string file() const { return source_.scene.file().string(); }
  /// The changes so far, as arguments of `--set`.
  std::vector<std::string> changes() const;
  /// The words of the command line that solves the same scene.
  std::vector<std::string> command() const;
  /// The tables of the scene with its changes. Throws WrongScene.
  formats::Value tables() const;
  /// Facts that readers know of the numbers of the scene, by their paths: a new reading, which takes as long
  /// as the first. Throws WrongScene.
  std::map<std::string, formats::NumberWords> words() const;
  /// All messages about the scene: those that make it wrong, and warnings.
  formats::Diagnostics check() const;
  /// The scene, ready to be solved, on its own mesh, or on one with the topology of `like`. Throws
  /// WrongScene.
  std::shared_ptr<runs::PreparedScene> prepare(const runs::PreparedScene* like = nullptr) const;

 private:
  void add(const formats::Change& change);

  runs::CaseSource source_;
};

}  // namespace netloft::python
