// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/accepted_warnings.hpp"

#include "io/formats/toml/table_reader.hpp"

#include <string_view>

namespace netloft::formats {
namespace {

constexpr const char* kShape =
    "write [[accept]], warning = \"the words with which it begins\", reason = \"…\"";

struct AcceptedWarning {
  std::string words, reason, path;
  Place place;
};

/// Reads a text that must not be empty.
std::string read_words(TableReader& entry, const char* key, const char* doc) {
  std::string text = entry.text(key, {.doc = doc});
  if (entry.has(key) && text.find_first_not_of(' ') == std::string::npos)
    entry.error(key, "is empty", kShape);
  return text;
}

/// The tables of `accept`; entries that are not tables are reported.
std::vector<AcceptedWarning> read_entries(const Value& root, Diagnostics& diagnostics) {
  std::vector<AcceptedWarning> entries;
  const Table* table = root.as<Table>();
  const Member* accept = table ? table->find("accept") : nullptr;
  if (!accept) return entries;
  const Array* array = accept->value.as<Array>();
  if (!array) diagnostics.error(accept->value.place, "accept: is not an array of tables", kShape);
  for (std::size_t i = 0; array && i < array->items.size(); ++i) {
    const Value& item = array->items[i];
    const std::string path = "accept[" + std::to_string(i) + "]";
    if (!item.as<Table>()) {
      diagnostics.error(item.place, path + ": has no reason", kShape);
      continue;
    }
    TableReader entry(item, diagnostics, path);
    const int errors_before = diagnostics.errors();
    AcceptedWarning accepted;
    accepted.words = read_words(entry, "warning", "the words with which the warning begins");
    accepted.reason = read_words(entry, "reason", "why the warning is accepted");
    accepted.path = path;
    accepted.place = entry.place("warning");
    entry.finish();
    if (diagnostics.errors() == errors_before) entries.push_back(std::move(accepted));
  }
  return entries;
}

/// Whether a message begins with `words`, and the last of these is a whole word or number of the message.
bool begins_with(std::string_view message, std::string_view words) {
  if (!message.starts_with(words)) return false;
  const std::string_view rest = message.substr(words.size());
  return rest.empty() || std::string_view(" :,;").find(rest[0]) != std::string_view::npos;
}

/// The indices in messages() of the warnings that begin with the words of an entry.
std::vector<std::size_t> meant_by(const AcceptedWarning& entry, const Diagnostics& diagnostics) {
  std::vector<std::size_t> meant;
  const auto& messages = diagnostics.messages();
  for (std::size_t i = 0; i < messages.size(); ++i)
    if (messages[i].severity == Severity::warning && begins_with(messages[i].message, entry.words))
      meant.push_back(i);
  return meant;
}

void say_useless(const AcceptedWarning& entry, std::size_t meant, Diagnostics& diagnostics) {
  const std::string path = entry.path + ".warning: ";
  if (meant == 0)
    diagnostics.warning(entry.place, path + "no warning begins with \"" + entry.words + "\"",
                        "leave out this entry of `accept`, or write the words that begin the warning");
  else
    diagnostics.warning(
        entry.place, path + std::to_string(meant) + " warnings begin with \"" + entry.words + "\"",
        "an entry accepts one warning: write more of its words, and an entry for each of the others");
}

}  // namespace

void mark_accepted(const Value& root, Diagnostics& diagnostics) {
  Diagnostics silent;
  for (const auto& entry : read_entries(root, silent))
    if (const auto meant = meant_by(entry, diagnostics); meant.size() == 1)
      diagnostics.accept(meant[0], entry.reason);
}

void accept_warnings(const Value& root, Diagnostics& diagnostics) {
  const auto entries = read_entries(root, diagnostics);
  mark_accepted(root, diagnostics);
  if (diagnostics.errors()) return;  // warnings may be missing
  std::vector<std::size_t> meant;
  for (const auto& entry : entries) meant.push_back(meant_by(entry, diagnostics).size());
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (meant[i] != 1) say_useless(entries[i], meant[i], diagnostics);
}

}  // namespace netloft::formats
