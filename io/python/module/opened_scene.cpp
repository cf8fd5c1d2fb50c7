// SPDX-License-Identifier: BSD-3-Clause
#include "io/python/module/opened_scene.hpp"

#include <pybind11/pybind11.h>

#include <algorithm>
#include <mutex>

namespace netloft::python {

Registry& registry() {
  static Registry& all = *new Registry;  // never destroyed: scenes and plugins may outlive the interpreter
  return all;
}

namespace {

std::mutex& reading() {
  static std::mutex& mutex = *new std::mutex;
  return mutex;
}

thread_local bool may_read = false;

}  // namespace

ReadingLock::ReadingLock() : is_first_(!may_read) {
  if (!is_first_) return;
  if (PyGILState_Check()) {
    const pybind11::gil_scoped_release others_may_run;
    reading().lock();
  } else {
    reading().lock();
  }
  may_read = true;
}

ReadingLock::~ReadingLock() {
  if (!is_first_) return;
  may_read = false;
  reading().unlock();
}

bool ReadingLock::is_held_here() { return may_read; }

LentReading::LentReading(bool is_held_there) { may_read = is_held_there; }
LentReading::~LentReading() { may_read = false; }

WrongScene::WrongScene(const formats::Diagnostics& all, bool is_refused)
    : std::runtime_error(all.render(false)), diagnostics(all), refused(is_refused) {}

void OpenedScene::add(const formats::Change& change) {
  std::erase_if(source_.changes, [&](const formats::Change& old) { return formats::undoes(change, old); });
  source_.changes.push_back(change);
}

OpenedScene OpenedScene::with(const std::vector<std::string>& changes) const {
  OpenedScene other = *this;
  for (const formats::Change& change : formats::read_changes(changes)) other.add(change);
  return other;
}

OpenedScene OpenedScene::by(const std::string& key, const std::string& specification) const {
  OpenedScene other = *this;
  for (const formats::Change& change : runs::choose_method(key, specification)) other.add(change);
  return other;
}

std::vector<std::string> OpenedScene::changes() const {
  std::vector<std::string> all;
  for (const formats::Change& change : source_.changes) all.push_back(change.text);
  return all;
}

std::vector<std::string> OpenedScene::command() const {
  std::vector<std::string> words{"netloft", "run", file()};
  for (const std::string& change : changes()) {
    words.push_back("--set");
    words.push_back(change);
  }
  return words;
}

formats::Value OpenedScene::tables() const {
  const ReadingLock lock;
  formats::Diagnostics diagnostics;
  formats::Value tables = source_.scene.tables(source_.changes, diagnostics);
  if (diagnostics.errors()) throw WrongScene(diagnostics, false);
  return tables;
}

std::map<std::string, formats::NumberWords> OpenedScene::words() const {
  const ReadingLock lock;
  formats::CollectedWords collected;
  formats::Diagnostics diagnostics;
  bool refused = false;
  scenes::SceneSource(source_.scene.file()).instance(source_.changes, registry(), diagnostics, refused);
  if (diagnostics.errors()) throw WrongScene(diagnostics, refused);
  return std::move(collected.by_path);
}

formats::Diagnostics OpenedScene::check() const {
  const ReadingLock lock;
  runs::PreparedScene scene(source_, registry());
  scene.prepare();
  return scene.diagnostics();
}

std::shared_ptr<runs::PreparedScene> OpenedScene::prepare(const runs::PreparedScene* like) const {
  const ReadingLock lock;
  auto scene = std::make_shared<runs::PreparedScene>(source_, registry());
  const auto state = like ? scene->prepare_like(*like) : scene->prepare();
  if (state != runs::PreparedScene::State::ready)
    throw WrongScene(scene->diagnostics(), state == runs::PreparedScene::State::refused);
  return scene;
}

}  // namespace netloft::python
