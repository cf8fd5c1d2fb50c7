// SPDX-License-Identifier: BSD-3-Clause
#include "io/design/texts/rewriting.hpp"

#include "io/design/texts/literal.hpp"
#include "io/design/texts/scene_texts.hpp"
#include "io/design/texts/statements.hpp"
#include "io/design/texts/written_value.hpp"
#include "io/formats/toml/parse.hpp"
#include "io/formats/toml/spelled_value.hpp"

#include <algorithm>

namespace netloft::design {

namespace {

constexpr int kMostRewritings =
    500;  // a part has a few seams and hangings; more changes mean that there is no progress

using Steps = std::vector<formats::PathStep>;

/// The first place at which a document is not as it is wanted; a value that is not there is nullptr.
struct Difference {
  Steps path;
  const formats::Value *now = nullptr, *wanted = nullptr;
};

bool holds_tables(const formats::Array& array) {
  return std::ranges::all_of(array.items,
                             [](const formats::Value& item) { return item.as<formats::Table>(); });
}

std::optional<Difference> first_difference(const formats::Value& now, const formats::Value& wanted,
                                           Steps path);

std::optional<Difference> difference_of_tables(const formats::Table& now, const formats::Table& wanted,
                                               Steps path) {
  for (const formats::Member& member : now.members) {
    path.push_back({member.key});
    const formats::Member* other = wanted.find(member.key);
    if (!other) return Difference{path, &member.value, nullptr};
    if (auto found = first_difference(member.value, other->value, path)) return found;
    path.pop_back();
  }
  for (const formats::Member& member : wanted.members) {
    path.push_back({member.key});
    if (!now.find(member.key)) return Difference{path, nullptr, &member.value};
    path.pop_back();
  }
  return std::nullopt;
}

std::optional<Difference> first_difference(const formats::Value& now, const formats::Value& wanted,
                                           Steps path) {
  if (are_same(now, wanted)) return std::nullopt;
  const auto *table = now.as<formats::Table>(), *other_table = wanted.as<formats::Table>();
  if (table && other_table) return difference_of_tables(*table, *other_table, std::move(path));
  const auto *array = now.as<formats::Array>(), *other = wanted.as<formats::Array>();
  if (array && other && array->items.size() == other->items.size())
    for (std::size_t i = 0; i < array->items.size(); ++i) {
      path.push_back({{}, i});
      if (auto found = first_difference(array->items[i], other->items[i], path)) return found;
      path.pop_back();
    }
  return Difference{std::move(path), &now, &wanted};
}

/// The table with a header, and its values one below another.
std::string spelled_table(const std::string& header, const formats::Table& table) {
  std::string text = "\n" + header + "\n";
  for (const formats::Member& member : table.members)
    text += formats::spell_key(member.key) + " = " + formats::spell_in_file(member.value) + "\n";
  return text;
}

std::string with_end_of_line(std::string text) {
  return text.empty() || text.back() == '\n' ? text : text + "\n";
}

/// Changes the texts of a scene, one difference after another.
class Rewriting {
 public:
  Rewriting(const std::filesystem::path& scene, formats::StoredTexts texts, const formats::Value& wanted)
      : scene_(scene), name_(scene.string()), texts_(std::move(texts)), wanted_(wanted) {}

  formats::StoredTexts done() {
    for (int i = 0; i < kMostRewritings; ++i) {
      formats::Diagnostics said;
      document_ = formats::Document::load_edited(scene_, texts_, said);
      if (said.errors()) throw Refused("this cannot be written into the text: " + first_error_of(said));
      const auto next = first_difference(document_.root(), wanted_, {});
      if (!next) return std::move(texts_);
      change(*next);
    }
    throw Refused("this cannot be written into the text");
  }

 private:
  void change(const Difference& difference) {
    const Steps& path = difference.path;
    if (!difference.wanted) return leave_out(path);
    const auto* array = difference.wanted->as<formats::Array>();
    if (path.size() == 1 && array && holds_tables(*array)) return change_array(path, difference);
    if (!difference.now) return add(path, *difference.wanted);
    replace(path, *difference.now, *difference.wanted);
  }

  /// The own text in which a value is written; nullptr if another file has it.
  std::string* own_text_of(const formats::Value& value) {
    if (value.place.file < 0) return nullptr;
    const auto at = texts_.find(document_.files().at(static_cast<std::size_t>(value.place.file)).path);
    return at == texts_.end() ? nullptr : &at->second;
  }

  /// Takes the statements of a path out of the first own text that has some.
  bool take_out(const Steps& path) {
    for (auto& [name, text] : texts_) {
      std::string left = without_statements(text, path);
      if (left == text) continue;
      text = std::move(left);
      return true;
    }
    return false;
  }

  void leave_out(const Steps& path) {
    if (take_out(path)) return;
    const std::string what = spell_path(path);
    if (append_to_list(texts_.at(name_), {{"without"}}, " ", {{}, what})) return;
    formats::Array names;
    names.items.push_back({{}, what});
    put_key({{"without"}}, {{}, std::move(names)});
  }

  /// A new key of the scene, in the first way that makes a valid text.
  void put_key(const Steps& path, const formats::Value& value) {
    std::string& text = texts_.at(name_);
    formats::Diagnostics unheard;
    const auto own = formats::parse_toml(text, 0, unheard);
    for (std::string& way : with_new_key(text, own.value(), path, value))
      if (formats::parse_toml(way, 0, unheard)) {
        text = std::move(way);
        return;
      }
    throw Refused(spell_path(path) + " cannot be stated in " + name_ + "; write it into the text");
  }

  /// The own text that has a key of the first level, the scene first.
  std::string& text_with(const std::string& key) {
    const auto has_key = [&](const std::string& text) {
      return std::ranges::any_of(statements_of(text),
                                 [&](const Statement& s) { return s.path.front().key == key; });
    };
    std::string& scene = texts_.at(name_);
    if (!has_key(scene))
      for (auto& [name, text] : texts_)
        if (has_key(text)) return text;
    return scene;
  }

  void add(const Steps& path, const formats::Value& value) {
    const auto* table = value.as<formats::Table>();
    if (!table) return put_key(path, value);
    if (path.size() > 1) {
      std::string& text = text_with(path.front().key);
      text = with_end_of_line(std::move(text)) + spelled_table("[" + spell_path(path) + "]", *table);
      return;
    }
    for (const formats::Member& member : table->members) {  // [panels] has no header of its own
      Steps inner = path;
      inner.push_back({member.key});
      add(inner, member.value);
    }
  }

  void change_array(const Steps& path, const Difference& difference) {
    const auto& wanted = difference.wanted->as<formats::Array>()->items;
    const auto* now = difference.now ? difference.now->as<formats::Array>() : nullptr;
    const std::size_t count = now ? now->items.size() : 0;
    std::size_t same = 0;
    while (same < std::min(count, wanted.size()) && are_same(now->items[same], wanted[same])) ++same;
    const bool is_longer = same == count;
    if (is_longer && same < wanted.size()) return append(path, wanted[same]);
    if (!is_longer && wanted.size() < count && take_out_item(path, *now, same)) return;
    // The whole array stands in the scene from now on.
    texts_.at(name_) = without_statements(texts_.at(name_), path);
    put_key(path, *difference.wanted);
  }

  /// Adds an item at the end of an array of tables: to the list in the scene, or under a header of its own.
  void append(const Steps& path, const formats::Value& item) {
    std::string& text = text_with(path.front().key);
    if (append_to_list(text, path, "\n  ", item)) return;
    text = with_end_of_line(std::move(text)) +
           spelled_table("[[" + spell_path(path) + "]]", *item.as<formats::Table>());
  }

  /// Adds an item after the last one of a list in brackets; returns false if the text has no such list.
  static bool append_to_list(std::string& text, const Steps& path, const char* blank,
                             const formats::Value& item) {
    formats::Diagnostics unheard;
    const auto own = formats::parse_toml(text, 0, unheard);
    const Found found = follow(*own, path);
    const auto* list = found.steps == path.size() ? found.value->as<formats::Array>() : nullptr;
    if (!list || list->from_headers) return false;
    const formats::Place& place = list->items.empty() ? found.value->place : list->items.back().place;
    const std::size_t at = byte_at(text, place.line, place.column);
    if (list->items.empty())
      text.insert(at + 1, formats::spell_in_file(item));
    else
      text.insert(at + length_of_literal(text, at), "," + (blank + formats::spell_in_file(item)));
    return true;
  }

  /// Takes an item of an array of tables out of the own text that has it under a header.
  bool take_out_item(const Steps& path, const formats::Array& array, std::size_t item) {
    std::string* text = own_text_of(array.items[item]);
    if (!text || !array.from_headers) return false;
    std::size_t before = 0;  // items of this text
    for (std::size_t i = 0; i < item; ++i)
      before += array.items[i].place.file == array.items[item].place.file;
    Steps own = path;
    own.push_back({{}, before});
    std::string left = without_statements(*text, own);
    if (left == *text) return false;
    *text = std::move(left);
    return true;
  }

  void replace(const Steps& path, const formats::Value& now, const formats::Value& wanted) {
    if (std::string* text = own_text_of(now)) {
      const std::size_t at = byte_at(*text, now.place.line, now.place.column);
      text->replace(at, length_of_literal(*text, at), formats::spell_in_file(wanted));
      return;
    }
    const auto item =
        std::ranges::find_if(path, [](const formats::PathStep& s) { return s.item.has_value(); });
    const Steps whole(path.begin(), item);
    texts_.at(name_) = without_statements(texts_.at(name_), whole);
    put_key(whole, *follow(wanted_, whole).value);
  }

  const std::filesystem::path scene_;
  const std::string name_;
  formats::StoredTexts texts_;
  const formats::Value& wanted_;
  formats::Document document_;
};

}  // namespace

formats::StoredTexts rewritten(const std::filesystem::path& scene, formats::StoredTexts texts,
                               const formats::Value& wanted) {
  return Rewriting(scene, std::move(texts), wanted).done();
}

}  // namespace netloft::design
