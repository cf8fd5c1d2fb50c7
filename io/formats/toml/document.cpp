// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/document.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <optional>
#include <set>

#include "framework/parameters/nearest.hpp"
#include "io/formats/files/installed_folder.hpp"
#include "io/formats/toml/change.hpp"
#include "io/formats/toml/merge.hpp"
#include "io/formats/toml/parse.hpp"

namespace netloft::formats {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestFile = std::size_t{16} << 20;
constexpr std::size_t kDeepestInclude = 32;

struct FileText {
  std::string text;
  std::string trouble;  // empty: the text is valid
};

FileText read_file(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return {{}, "is a directory; a TOML file is expected"};
  if (fs::exists(path, ignored) && !fs::is_regular_file(path, ignored))
    return {{}, "is a pipe, a device or similar, which may never end; a TOML file is expected"};
  std::FILE* file = std::fopen(path.c_str(), "rb");
  if (!file) return {{}, std::string("cannot be opened: ") + std::strerror(errno)};
  FileText result;
  std::array<char, 1 << 16> block;
  for (std::size_t n; (n = std::fread(block.data(), 1, block.size(), file)) > 0;) {
    result.text.append(block.data(), n);
    if (result.text.size() > kLargestFile) break;
  }
  if (std::ferror(file)) result.trouble = std::string("cannot be read: ") + std::strerror(errno);
  std::fclose(file);
  return result;
}

/// The index of the first byte that is not valid UTF-8, or npos. Overlong forms and surrogates are invalid.
std::size_t find_bad_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t k) {
      return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0u;
    };
    const auto follows = [&](std::size_t k) { return (byte(k) & 0xC0u) == 0x80u; };
    const unsigned lead = byte(0);
    std::size_t length = 0;
    if (lead < 0x80)
      length = 1;
    else if (lead >= 0xC2 && lead < 0xE0 && follows(1))
      length = 2;
    else if (lead >= 0xE0 && lead < 0xF0 && follows(1) && follows(2))
      length = 3;
    else if (lead >= 0xF0 && lead < 0xF5 && follows(1) && follows(2) && follows(3))
      length = 4;
    const bool overlong = (lead == 0xE0 && byte(1) < 0xA0) || (lead == 0xF0 && byte(1) < 0x90);
    const bool beyond = (lead == 0xED && byte(1) > 0x9F) || (lead == 0xF4 && byte(1) > 0x8F);
    if (length == 0 || overlong || beyond) return i;
    i += length;
  }
  return std::string_view::npos;
}

std::string find_trouble(const std::string& text) {
  if (text.size() > kLargestFile)
    return "is larger than " + std::to_string(kLargestFile >> 20) + " MiB, too large for a scene";
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) return "is empty";
  if (text.find('\0') != std::string::npos) return "is a binary file; a TOML file is expected";
  if (const std::size_t bad = find_bad_utf8(text); bad != std::string::npos)
    return "is not UTF-8 text: line " +
           std::to_string(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(bad), '\n') +
                          1) +
           " has an invalid byte";
  return {};
}

/// A hint if an included file is missing because only the scene was copied from the library: to include the
/// file of this name in the library. Empty if the library has no such file either.
std::string cure_of_missing(const fs::path& path) {
  std::error_code failed;
  const fs::path scenes = installed_folder() / "share/netloft/gear-library/scenes";
  if (fs::exists(path, failed) || !fs::is_directory(scenes, failed)) return {};
  const fs::path tail = path.parent_path().filename() / path.filename();
  for (const fs::path& candidate : {scenes / path.filename(), scenes / tail, scenes.parent_path() / tail})
    if (fs::is_regular_file(candidate, failed))
      return "the library has it: include = [\"" + candidate.lexically_normal().string() + "\"]";
  return {};
}

/// Reads a file and the files that it includes, which come first.
class Loader {
 public:
  enum class Others { opened, refused };  // what happens to files that are not in `stored`

  /// `stored`: texts that are used instead of files.
  Loader(std::vector<SourceFile>& files, Diagnostics& diagnostics, const StoredTexts& stored = {},
         Others others = Others::opened)
      : files_(files), diagnostics_(diagnostics), stored_(stored), others_(others) {}

  /// Loads a file and its includes. `named_at` is the entry in the including file; for the root it is empty.
  Value load(const fs::path& path, const Place& named_at) {
    const std::string name = path.lexically_normal().string();
    FileText file = read(path, name);
    if (file.trouble.empty()) file.trouble = find_trouble(file.text);
    if (!file.trouble.empty()) {
      diagnostics_.error(named_at, name + ' ' + file.trouble, cure_of_missing(path));
      return {named_at, Table{}};
    }
    done_.insert(identity(path));
    chain_.push_back(path);
    Value value = add(std::move(file.text), name, path.parent_path());
    chain_.pop_back();
    return value;
  }

  Value add(std::string text, const std::string& name, const fs::path& folder) {
    const int file = diagnostics_.add_source(name, text);
    files_.push_back({name, text, fnv1a64(text)});
    std::optional<Value> own = parse_toml(text, file, diagnostics_);
    if (!own) return {Place{file, 1, 1, 1}, Table{}};
    Value all{own->place, Table{}};
    for (const Value& entry : take_list(*own, "include", "water.toml")) include(all, entry, folder);
    for (const Value& entry : take_list(*own, "without", "floats.headline")) leave_out(all, entry);
    merge(all, std::move(*own));
    return all;
  }

 private:
  FileText read(const fs::path& path, const std::string& name) const {
    if (const auto at = stored_.find(name); at != stored_.end()) return {at->second, {}};
    return others_ == Others::opened ? read_file(path) : FileText{{}, "was not stored"};
  }

  std::string identity(const fs::path& path) const {
    std::error_code failed;
    if (others_ == Others::refused) return path.lexically_normal().string();
    const fs::path canonical = fs::canonical(path, failed);
    return failed ? path.lexically_normal().string() : canonical.string();
  }

  /// Takes a key out of the tables of a file. Its value is a list.
  std::vector<Value> take_list(Value& own, const std::string& key, const char* example) {
    std::vector<Member>& members = own.as<Table>()->members;
    const auto at =
        std::find_if(members.begin(), members.end(), [&](const Member& m) { return m.key == key; });
    if (at == members.end()) return {};
    const Value value = std::move(at->value);
    members.erase(at);
    if (const Array* array = value.as<Array>()) return array->items;
    diagnostics_.error(value.place, key + " is not an array", "write " + key + " = [\"" + example + "\"]");
    return {};
  }

  /// Leaves out a table or a key that the included files have.
  void leave_out(Value& all, const Value& entry) {
    const std::string* path = entry.as<std::string>();
    const Change named = read_change((path ? *path : "") + "=0");
    if (!path || !named.fault.empty())
      return diagnostics_.error(entry.place, "without names tables and keys of the included files",
                                "write without = [\"floats.headline\"]");
    Table* table = all.as<Table>();
    for (std::size_t i = 0; i + 1 < named.steps.size() && table; ++i) {
      Member* inner = named.steps[i].item ? nullptr : table->find(named.steps[i].key);
      table = inner ? inner->value.as<Table>() : nullptr;
    }
    if (table && !named.steps.back().item &&
        std::erase_if(table->members, [&](const Member& m) { return m.key == named.steps.back().key; }) > 0)
      return;
    diagnostics_.error(entry.place, "without: the included files have no " + *path,
                       hint_of_missing(table, named));
  }

  static std::string hint_of_missing(const Table* table, const Change& named) {
    for (const PathStep& step : named.steps)
      if (step.item) return "one item of an array cannot be left out; state the array again without it";
    std::vector<std::string> keys;
    for (const Member& member : table ? table->members : std::vector<Member>{}) keys.push_back(member.key);
    const auto near = nearest(named.steps.back().key, keys);
    return near ? "did you mean \"" + *near + "\"?" : "";
  }

  void include(Value& all, const Value& entry, const fs::path& folder) {
    const std::string* name = entry.as<std::string>();
    if (!name || name->empty())
      return diagnostics_.error(entry.place, "an include is the name of a file, a text");
    if (name->find('\0') != std::string::npos)
      return diagnostics_.error(entry.place, "a file name contains a NUL byte");
    const fs::path path = folder / *name;
    const std::string id = identity(path);
    const auto loop =
        std::find_if(chain_.begin(), chain_.end(), [&](const fs::path& p) { return identity(p) == id; });
    if (loop != chain_.end()) return diagnostics_.error(entry.place, "include cycle: " + spell_cycle(loop));
    if (done_.contains(id)) return;
    if (chain_.size() >= kDeepestInclude)
      return diagnostics_.error(
          entry.place, "includes are nested deeper than " + std::to_string(kDeepestInclude) + " files");
    merge(all, load(path, entry.place));
  }

  std::string spell_cycle(std::vector<fs::path>::const_iterator loop) const {
    std::string text;
    for (auto at = loop; at != chain_.end(); ++at) text += at->lexically_normal().string() + " -> ";
    return text + loop->lexically_normal().string();
  }

  std::vector<SourceFile>& files_;
  Diagnostics& diagnostics_;
  const StoredTexts stored_;
  Others others_;
  std::vector<fs::path> chain_;  // files from the root to the one that is being read
  std::set<std::string> done_;
};

}  // namespace

Document Document::load(const fs::path& path, const std::vector<std::string>& overrides,
                        Diagnostics& diagnostics) {
  Document document;
  document.root_ = Loader(document.files_, diagnostics).load(path, {});
  for (const std::string& text : overrides) apply(document.root_, read_change(text), diagnostics);
  return document;
}

Document Document::load_edited(const fs::path& path, const StoredTexts& edited, Diagnostics& diagnostics) {
  Document document;
  document.root_ = Loader(document.files_, diagnostics, edited).load(path, {});
  return document;
}

Document Document::parse(std::string text, const std::string& name, const std::vector<std::string>& overrides,
                         Diagnostics& diagnostics) {
  Document document;
  document.root_ = Loader(document.files_, diagnostics).add(std::move(text), name, {});
  for (const std::string& change : overrides) apply(document.root_, read_change(change), diagnostics);
  return document;
}

Document Document::recall(std::vector<SourceFile> files, Diagnostics& diagnostics) {
  Document document;
  if (files.empty()) return document;
  const fs::path scene = files.front().path;
  StoredTexts texts;
  for (SourceFile& file : files) texts.emplace(std::move(file.path), std::move(file.text));
  document.root_ = Loader(document.files_, diagnostics, texts, Loader::Others::refused).load(scene, {});
  return document;
}

std::string fnv1a64(std::string_view text) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  std::array<char, 32> buffer;
  std::snprintf(buffer.data(), buffer.size(), "fnv1a64:%016llx", static_cast<unsigned long long>(hash));
  return buffer.data();
}

}  // namespace netloft::formats
