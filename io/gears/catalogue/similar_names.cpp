// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/catalogue/similar_names.hpp"

#include "framework/parameters/nearest.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <compare>
#include <optional>

namespace netloft::gears {

namespace {

using Words = std::vector<std::string>;

constexpr std::size_t kMostNames = 3;
constexpr std::size_t kMostLetters = 64;  // longest name that is compared with names of parts

/// The words of a name in lower case: "Nylon-2mm" has nylon and 2mm.
Words words_of(const std::string& name) {
  Words words(1);
  for (const char c : name)
    if (c == '-' || c == '_' || c == ' ')
      words.emplace_back();
    else
      words.back() += detail::lower(c);
  std::erase(words, "");
  return words;
}

std::string joined(const Words& words) {
  std::string name;
  for (const auto& word : words) name += (name.empty() ? "" : "-") + word;
  return name;
}

/// The group of synonyms that contains a word; the word alone if no group contains it.
Words synonyms_of(const std::string& word, const std::vector<Words>& groups) {
  for (const auto& group : groups)
    if (std::find(group.begin(), group.end(), word) != group.end()) return group;
  return {word};
}

/// The diameter [m] in a word such as 2.3mm; nullopt if the word is not a diameter.
std::optional<double> diameter_in(const std::string& word) {
  double millimetres = 0;
  const auto* end = word.data() + word.size();
  const auto [after, error] = std::from_chars(word.data(), end, millimetres);
  if (error != std::errc() || std::string_view(after, end) != "mm") return std::nullopt;
  return 1e-3 * millimetres;
}

/// The name with the smallest number of different letters, possibly after a word is replaced by a synonym. At
/// most a sixth of the letters, or a single letter, may differ, because names of different materials may
/// differ in few letters.
std::optional<std::string> nearest_spelling(const std::string& name, const std::vector<std::string>& names,
                                            const std::vector<Words>& groups) {
  std::optional<std::string> best;
  std::size_t least = kMostLetters;
  const auto consider = [&](const std::string& spelling) {
    const auto near = nearest(spelling, names);
    const std::size_t letters = near ? detail::edit_distance(spelling, *near) : kMostLetters;
    if (letters >= least || letters > std::max<std::size_t>(1, spelling.size() / 6)) return;
    best = near;
    least = letters;
  };
  consider(name);
  const Words words = words_of(name);
  for (std::size_t i = 0; i < words.size(); ++i)
    for (const auto& synonym : synonyms_of(words[i], groups)) {
      Words replaced = words;
      replaced[i] = synonym;
      consider(joined(replaced));
    }
  return best;
}

/// The number of words in a name (without the diameter) that occur neither themselves nor as synonyms in the
/// name of a part.
std::size_t other_words(const Words& words, const Words& of_part, const std::vector<Words>& groups) {
  return static_cast<std::size_t>(std::count_if(words.begin(), words.end(), [&](const std::string& word) {
    const Words same = synonyms_of(word, groups);
    return std::find_first_of(of_part.begin(), of_part.end(), same.begin(), same.end()) == of_part.end();
  }));
}

double diameter_of(const CataloguePart& part) {
  const auto diameter = part.numbers.find("diameter");
  return diameter == part.numbers.end() ? 0 : diameter->second;
}

/// A part whose name shares words with a name that was looked up.
struct Similar {
  std::size_t other_words;
  double off;  // difference of the diameters [m]
  std::string name;
  auto operator<=>(const Similar&) const = default;
};

/// The parts whose names share at least one word with `name`, the most similar first.
std::vector<Similar> with_common_words(const std::string& name,
                                       const std::vector<const CataloguePart*>& parts,
                                       const std::vector<Words>& groups) {
  Words words = words_of(name);
  double wanted = 0;
  for (const auto& word : words) wanted = diameter_in(word).value_or(wanted);
  std::erase_if(words, [](const std::string& word) { return diameter_in(word).has_value(); });
  std::vector<Similar> found;
  for (const auto* part : parts)
    if (const std::size_t other = other_words(words, words_of(part->name), groups); other < words.size())
      found.push_back({other, std::abs(diameter_of(*part) - wanted), part->name});
  std::sort(found.begin(), found.end());
  return found;
}

/// The names of the most similar parts with the same diameter, or of the most similar parts if none has it.
std::vector<std::string> first_names(const std::vector<Similar>& found) {
  constexpr double kSame = 1e-6;  // [m]
  std::vector<std::string> names;
  for (const Similar& one : found) {
    const bool is_worse = one.other_words > found[0].other_words || (found[0].off < kSame && one.off > kSame);
    if (names.size() == kMostNames || is_worse) break;
    names.push_back(one.name);
  }
  return names;
}

}  // namespace

std::vector<std::string> similar_names(const std::string& name,
                                       const std::vector<const CataloguePart*>& parts,
                                       const std::vector<std::vector<std::string>>& synonyms) {
  if (name.size() > kMostLetters) return {};
  std::vector<std::string> names;
  for (const auto* part : parts) names.push_back(part->name);
  const auto found = with_common_words(name, parts, synonyms);
  const bool has_all_words = !found.empty() && found[0].other_words == 0;
  const auto near = has_all_words ? std::nullopt : nearest_spelling(name, names, synonyms);
  return near ? std::vector<std::string>{*near} : first_names(found);
}

}  // namespace netloft::gears
