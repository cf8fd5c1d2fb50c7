// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/diagnostics.hpp"

#include <algorithm>
#include <cassert>

#include "io/formats/text/printable.hpp"

namespace netloft::formats {
namespace {

constexpr std::size_t kWindow = 100;     // characters shown of a long line
constexpr std::size_t kBeforeSpot = 40;  // characters that are shown before the marked place

bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }
std::vector<std::string> characters_of(const std::string& text) {
  std::vector<std::string> characters;
  for (const char c : text) {
    if (begins_character(c) || characters.empty()) characters.emplace_back();
    characters.back() += c;
  }
  return characters;
}

const char* word_for(Severity severity) { return severity == Severity::error ? "error" : "warning"; }

struct Style {
  const char *bold, *red, *yellow, *cyan, *off;
};
constexpr Style kPlain = {"", "", "", "", ""};
constexpr Style kColored = {"\033[1m", "\033[1;31m", "\033[1;33m", "\033[36m", "\033[0m"};

}  // namespace

int Diagnostics::add_source(std::string name, std::string text, Source kind) {
  sources_.push_back(std::make_shared<const Text>(Text{std::move(name), std::move(text), kind}));
  return static_cast<int>(sources_.size()) - 1;
}

void Diagnostics::error(const Place& place, std::string message, std::string hint, std::vector<Cure> cures) {
  add({Severity::error, place, std::move(message), std::move(hint), std::move(cures)});
}

void Diagnostics::warning(const Place& place, std::string message, std::string hint,
                          std::vector<Cure> cures) {
  add({Severity::warning, place, std::move(message), std::move(hint), std::move(cures)});
}

void Diagnostics::add(Diagnostic entry) {
  if (!seen_.emplace(entry.place.file, entry.place.line, entry.place.column, entry.message).second) return;
  if (entry.severity == Severity::error) ++errors_;
  if (!entry.accepted.empty()) ++accepted_;
  entries_.push_back(std::move(entry));
}

int Diagnostics::append(const Diagnostics& other) {
  const int by = static_cast<int>(sources_.size());
  sources_.insert(sources_.end(), other.sources_.begin(), other.sources_.end());
  for (Diagnostic entry : other.entries_) {
    if (entry.place.file >= 0) entry.place.file += by;
    add(std::move(entry));
  }
  return by;
}

Diagnostics Diagnostics::without_messages() const {
  Diagnostics silent;
  silent.sources_ = sources_;
  return silent;
}

void Diagnostics::take_messages(const std::vector<Diagnostic>& messages) {
  for (const Diagnostic& message : messages) add(message);
}

void Diagnostics::accept(std::size_t warning, std::string reason) {
  Diagnostic& entry = entries_[warning];
  assert(entry.severity == Severity::warning && !reason.empty());
  if (entry.accepted.empty()) ++accepted_;
  entry.accepted = std::move(reason);
}

std::vector<Diagnostic> Diagnostics::sorted() const { return sorted(false); }

std::vector<Diagnostic> Diagnostics::accepted() const { return sorted(true); }

std::vector<Diagnostic> Diagnostics::sorted(bool are_accepted) const {
  std::vector<Diagnostic> result;
  for (const Diagnostic& entry : entries_)
    if (entry.accepted.empty() != are_accepted) result.push_back(entry);
  const auto key = [](const Diagnostic& d) { return std::tuple(d.place.file, d.place.line, d.place.column); };
  std::stable_sort(result.begin(), result.end(),
                   [&](const Diagnostic& a, const Diagnostic& b) { return key(a) < key(b); });
  return result;
}

std::string Diagnostics::where(const Place& place) const {
  if (place.file < 0) return {};
  const Text& source = *sources_[static_cast<std::size_t>(place.file)];
  if (source.kind == Source::command_line || place.line == 0) return source.name;
  return source.name + ':' + std::to_string(place.line) + ':' + std::to_string(place.column);
}

std::string Diagnostics::source_line(const Place& place) const {
  if (place.file < 0 || place.line < 1) return {};
  const std::string& text = sources_[static_cast<std::size_t>(place.file)]->text;
  std::size_t begin = 0;
  for (int line = 1; line < place.line; ++line) {
    begin = text.find('\n', begin);
    if (begin == std::string::npos) return {};
    ++begin;
  }
  std::string line = text.substr(begin, text.find('\n', begin) - begin);
  if (line.ends_with('\r')) line.pop_back();
  return line;
}

/// The line and its underline, cut to a window around the marked place. The width of a control character is
/// that of its printable form.
std::string Diagnostics::excerpt(const Place& place) const {
  const std::vector<std::string> line = characters_of(source_line(place));
  if (line.empty()) return {};
  const std::size_t spot = static_cast<std::size_t>(std::max(place.column, 1)) - 1;
  const std::size_t begin =
      line.size() > kWindow && spot > kBeforeSpot ? std::min(spot, line.size()) - kBeforeSpot : 0;
  const std::size_t end = std::min(line.size(), begin + kWindow);
  const std::size_t marked = spot + static_cast<std::size_t>(std::max(place.length, 1));
  std::string shown = begin > 0 ? "..." : "", under(shown.size(), ' ');
  for (std::size_t i = begin; i < end; ++i) {
    const std::string character = printable_in_line(line[i]);
    shown += character;
    if (i == spot) under += '^';
    const std::size_t width = has_control_characters(line[i]) ? character.size() : 1;
    if (i < marked) under.append(i == spot ? width - 1 : width, i < spot ? ' ' : '~');
  }
  if (spot >= end) under += '^';
  if (end < line.size()) shown += "...";
  const std::string number = std::to_string(place.line);
  return "  " + number + " | " + shown + "\n  " + std::string(number.size(), ' ') + " | " + under + '\n';
}

std::string Diagnostics::render(bool color, std::size_t limit) const {
  const Style style = color ? kColored : kPlain;
  std::string text;
  const std::vector<Diagnostic> all = sorted();
  for (std::size_t i = 0; i < std::min(limit, all.size()); ++i) {
    const Diagnostic& entry = all[i];
    const std::string at = printable_in_line(where(entry.place));
    if (!at.empty()) text += style.bold + at + ':' + style.off + ' ';
    text += (entry.severity == Severity::error ? style.red : style.yellow) +
            std::string(word_for(entry.severity));
    text +=
        std::string(":") + style.off + ' ' + printable_in_line(entry.message) + '\n' + excerpt(entry.place);
    if (!entry.hint.empty())
      text +=
          std::string("  ") + style.cyan + "hint:" + style.off + ' ' + printable_in_line(entry.hint) + '\n';
  }
  if (all.size() > limit) text += "… and " + std::to_string(all.size() - limit) + " more\n";
  return text;
}

}  // namespace netloft::formats
