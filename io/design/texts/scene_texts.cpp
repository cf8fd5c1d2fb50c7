// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/texts/scene_texts.hpp"

#include "io/design/texts/literal.hpp"
#include "io/design/texts/rewriting.hpp"
#include "io/design/texts/written_value.hpp"
#include "io/formats/files/whole_file.hpp"
#include "io/formats/toml/parse.hpp"
#include "io/formats/toml/spelled_value.hpp"
#include "io/gears/catalogue/part_choice.hpp"

#include <unistd.h>

#include <algorithm>

namespace netloft::design {

namespace {

namespace fs = std::filesystem;

bool is_below(const fs::path& file, const fs::path& folder) {
  if (folder.empty()) return false;
  std::error_code failed;
  const fs::path inner = fs::weakly_canonical(file, failed), outer = fs::weakly_canonical(folder, failed);
  return std::mismatch(outer.begin(), outer.end(), inner.begin(), inner.end()).first == outer.end();
}

bool may_be_written(const fs::path& file) { return ::access(file.c_str(), W_OK) == 0; }

/// A name for a variant of a scene; no file in the working folder has this name.
fs::path variant_name(const fs::path& scene) {
  const std::string stem = scene.stem().string() + "-variant";
  fs::path name = stem + ".toml";
  for (int i = 2; fs::exists(name); ++i) name = stem + "-" + std::to_string(i) + ".toml";
  return name;
}

std::string variant_text(const fs::path& scene) {
  return "# A variant of " + scene.stem().string() + ".\ninclude = [" +
         formats::spell_in_file({{}, scene.lexically_normal().string()}) + "]\n";
}

void require_no_errors(const formats::Diagnostics& diagnostics, const std::string& before) {
  if (diagnostics.errors()) throw Refused(before + first_error_of(diagnostics));
}

/// The smallest edit from one text to another.
Edit edit_between(const std::string& file, const std::string& from, const std::string& to) {
  const std::size_t most = std::min(from.size(), to.size());
  std::size_t begin = 0, end = 0;
  while (begin < most && from[begin] == to[begin]) ++begin;
  while (end < most - begin && from[from.size() - 1 - end] == to[to.size() - 1 - end]) ++end;
  return {file, begin, from.substr(begin, from.size() - begin - end),
          to.substr(begin, to.size() - begin - end)};
}

bool is_plain_name(const std::string& name) {
  return name.size() > 5 && name.size() <= 200 && name.ends_with(".toml") && name.front() != '.' &&
         std::ranges::none_of(
             name, [](char c) { return c == '/' || c == '\\' || static_cast<unsigned char>(c) < 0x20; });
}

}  // namespace

std::string first_error_of(const formats::Diagnostics& diagnostics) {
  for (const formats::Diagnostic& one : diagnostics.sorted())
    if (one.severity == formats::Severity::error) {
      const std::string where = diagnostics.where(one.place);
      return (where.empty() ? "" : where + ": ") + one.message + (one.hint.empty() ? "" : "; " + one.hint);
    }
  return {};
}

SceneTexts::SceneTexts(const fs::path& scene, const fs::path& library) : file_(scene.lexically_normal()) {
  const auto text = formats::read_whole(scene);
  if (!text) throw formats::ReadError(scene.string() + " does not exist");
  if (is_below(scene, library) || !may_be_written(scene)) {
    file_ = variant_name(scene);
    texts_[file_.string()] = variant_text(scene);
    return;
  }
  texts_[file_.string()] = *text;
  open_own(library);
  saved_ = texts_;
}

/// Reads those included files that belong to the design.
void SceneTexts::open_own(const fs::path& library) {
  formats::Diagnostics unheard;
  const fs::path folder = file_.has_parent_path() ? file_.parent_path() : fs::path(".");
  const formats::Document whole = document(unheard);
  for (const formats::SourceFile& file : whole.files())
    if (is_below(file.path, folder) && !is_below(file.path, library) && may_be_written(file.path))
      texts_.emplace(file.path, file.text);
}

formats::Document SceneTexts::document(formats::Diagnostics& diagnostics) const {
  return formats::Document::load_edited(file_, texts_, diagnostics);
}

Edit SceneTexts::set(const formats::Change& change, bool goes_on) {
  formats::Diagnostics said;
  const formats::Document before = document(said);
  require_no_errors(said, "the text has an error; correct it first: ");
  formats::Value wanted = before.root();
  formats::apply(wanted, change, said, gears::keys_that_name_parts());
  require_no_errors(said, "");
  const Edit edit = edited(before, change, wanted);
  put(edit);
  formats::Diagnostics after;
  if (!are_same(document(after).root(), wanted) || after.errors()) {
    put({edit.file, edit.at, edit.after, edit.before});
    throw Refused(change.path + " cannot be set here; change it in the text");
  }
  return keep(edit, goes_on);
}

/// The edit of the text that makes the document equal to `wanted`.
Edit SceneTexts::edited(const formats::Document& before, const formats::Change& change,
                        const formats::Value& wanted) const {
  const std::span<const formats::PathStep> path = change.steps;
  const Found found = follow(before.root(), path);
  const auto stated = path.first(found.steps);
  const bool is_table = found.value->as<formats::Table>();
  if (is_table && found.steps < path.size()) return override_in_scene(before, path, change.value);
  const formats::Value& value = *follow(wanted, stated).value;
  const formats::Place& place = found.value->place;
  const std::string& file = before.files().at(static_cast<std::size_t>(std::max(place.file, 0))).path;
  if (!texts_.contains(file)) return override_in_scene(before, stated, value);
  const std::string& text = texts_.at(file);
  const std::size_t at = byte_at(text, place.line, place.column);
  if (const auto* array = found.value->as<formats::Array>();
      (is_table && text[at] != '{') || (array && array->from_headers))
    throw Refused(change.path + " is a table of its own; set its keys, or change it in the text");
  return {file, at, text.substr(at, length_of_literal(text, at)), formats::spell_in_file(value)};
}

/// The edit that adds a value to the scene and thus overrides the value in an included file.
Edit SceneTexts::override_in_scene(const formats::Document& before, std::span<const formats::PathStep> path,
                                   const formats::Value& value) const {
  const std::string name = file_.string();
  const auto item =
      std::ranges::find_if(path, [](const formats::PathStep& step) { return step.item.has_value(); });
  formats::Value whole = value;
  auto steps = path;
  if (item != path.end()) {  // an array in the scene replaces the whole array of the included file
    steps = path.first(static_cast<std::size_t>(item - path.begin()));
    whole = *follow(before.root(), steps).value;
    formats::Value* inner = &whole;
    for (const formats::PathStep& step : path.subspan(steps.size()))
      inner = step.item ? &inner->as<formats::Array>()->items[*step.item]
                        : &inner->as<formats::Table>()->find(step.key)->value;
    *inner = value;
  }
  formats::Diagnostics unheard;
  const auto own = formats::parse_toml(texts_.at(name), 0, unheard);
  for (const std::string& text : with_new_key(texts_.at(name), own.value(), steps, whole))
    if (formats::parse_toml(text, 0, unheard)) return edit_between(name, texts_.at(name), text);
  throw Refused(spell_path(path) + " cannot be stated in " + name + "; write it into the text");
}

Edit SceneTexts::replace(const std::string& file, std::string text, bool goes_on) {
  const auto at = texts_.find(file);
  if (at == texts_.end()) throw Refused("\"" + file + "\" is not among the files that may be changed here");
  const Edit edit = edit_between(file, at->second, text);
  put(edit);
  return keep(edit, goes_on);
}

void SceneTexts::put(const Edit& edit) {
  texts_.at(edit.file).replace(edit.at, edit.before.size(), edit.after);
}

/// Records an edit. If it continues the last edit, both are recorded as one.
Edit SceneTexts::keep(Edit edit, bool goes_on) {
  steps_.resize(done_);
  Edit* last = goes_on && !steps_.empty() && steps_.back().size() == 1 ? &steps_.back().front() : nullptr;
  const bool is_within = last && last->file == edit.file && edit.at >= last->at &&
                         edit.at + edit.before.size() <= last->at + last->after.size();
  if (is_within) {
    last->after.replace(edit.at - last->at, edit.before.size(), edit.after);
  } else if (edit.before != edit.after) {
    steps_.push_back({edit});
    ++done_;
  }
  return edit;
}

std::vector<Edit> SceneTexts::become(const formats::Value& wanted) {
  Step step;
  for (const auto& [name, text] : rewritten(file_, texts_, wanted))
    if (text != texts_.at(name)) step.push_back(edit_between(name, texts_.at(name), text));
  if (step.empty()) return step;
  steps_.resize(done_);
  steps_.push_back(step);
  redo();
  return step;
}

bool SceneTexts::undo() {
  if (!can_undo()) return false;
  for (const Edit& edit : steps_[--done_]) put({edit.file, edit.at, edit.after, edit.before});
  return true;
}

bool SceneTexts::redo() {
  if (!can_redo()) return false;
  for (const Edit& edit : steps_[done_++]) put(edit);
  return true;
}

std::vector<std::string> SceneTexts::save() {
  std::vector<std::string> written;
  for (const auto& [name, text] : texts_) {
    const auto before = saved_.find(name);
    if (before != saved_.end() && before->second == text) continue;
    const auto there = formats::read_whole(name);
    if (there && (before == saved_.end() || *there != before->second) && *there != text)
      throw Refused(name + " was changed by another program; save under another name");
    written.push_back(name);
  }
  for (const std::string& name : written) {
    formats::write_whole(name, texts_.at(name));
    saved_[name] = texts_.at(name);
  }
  return written;
}

void SceneTexts::save_as(const std::string& name) {
  if (!is_plain_name(name))
    throw Refused("\"" + name + "\" is not the name of a file in the scene's folder; write a name such as " +
                  "my-trawl.toml");
  const fs::path path = (file_.parent_path() / name).lexically_normal();
  if (path != file_ && fs::exists(fs::symlink_status(path)))
    throw Refused(path.string() + " exists; choose another name");
  const std::string text = texts_.at(file_.string());
  formats::write_whole(path, text);
  if (path != file_) {
    texts_.erase(file_.string());
    saved_.erase(file_.string());
    for (Step& step : steps_)
      for (Edit& edit : step)
        if (edit.file == file_.string()) edit.file = path.string();
    file_ = path;
    texts_[path.string()] = text;
  }
  saved_[path.string()] = text;
  save();
}

std::vector<std::string> SceneTexts::reread() {
  std::vector<std::string> changed;
  for (const auto& [name, text] : saved_) {
    if (texts_.at(name) != text) continue;
    const auto there = formats::read_whole(name);
    if (there && *there != text) changed.push_back(name);
  }
  for (const std::string& name : changed) {
    saved_[name] = formats::read_whole(name).value_or("");
    replace(name, saved_[name]);
  }
  return changed;
}

}  // namespace netloft::design
