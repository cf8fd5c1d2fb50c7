// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/tried_cures.hpp"

#include "io/formats/toml/accepted_warnings.hpp"
#include "io/formats/toml/change.hpp"
#include "io/formats/toml/spelled_value.hpp"
#include "io/gears/catalogue/part_choice.hpp"
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/proposals.hpp"
#include "io/gears/plan/read_plan.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <sstream>
#include <tuple>
#include <utility>

namespace netloft::gears {

namespace {

using formats::Cure;
using formats::Diagnostic;

/// The text of a message without its numbers, which identifies the message after values have changed.
std::string kind_of(const Diagnostic& message) {
  std::istringstream words(message.message);
  std::string kind;
  for (std::string word; words >> word;) {
    const std::size_t first = word[0] == '+' || word[0] == '-' ? 1 : 0;
    const bool is_number = first < word.size() && std::isdigit(static_cast<unsigned char>(word[first]));
    kind += (is_number ? "#" : word) + ' ';
  }
  return kind;
}

/// The messages of the check of a plan, without accepted warnings.
struct Findings {
  std::vector<Diagnostic> messages;
  int errors = 0;

  /// Number of messages of a kind; number of errors among them.
  int count(const std::string& kind) const { return at(kinds_, kind); }
  int count_errors(const std::string& kind) const { return at(kinds_of_errors_, kind); }

  void add(const Diagnostic& message) {
    messages.push_back(message);
    ++kinds_[kind_of(message)];
    if (message.severity != formats::Severity::error) return;
    ++errors;
    ++kinds_of_errors_[kind_of(message)];
  }

 private:
  static int at(const std::map<std::string, int>& kinds, const std::string& kind) {
    const auto found = kinds.find(kind);
    return found == kinds.end() ? 0 : found->second;
  }
  std::map<std::string, int> kinds_, kinds_of_errors_;
};

/// A tried proposal: values that were changed one after another, and the messages that they cause.
struct Trial {
  Cure cure;
  Findings after;
  std::vector<Diagnostic> caused;  // errors first
  bool is_clean() const { return caused.empty(); }
  std::size_t caused_errors() const {
    return static_cast<std::size_t>(
        std::ranges::count(caused, formats::Severity::error, &Diagnostic::severity));
  }
};

bool is_better(const Trial& a, const Trial& b) {
  const auto rank = [](const Trial& t) {
    return std::tuple(t.caused_errors(), t.caused.size(), t.after.errors, t.after.messages.size());
  };
  return rank(a) < rank(b);
}

std::size_t number_of_parts(const formats::Value& root) {
  std::size_t parts = 1;
  for (const auto& member : root.as<formats::Table>()->members) {
    if (const auto* table = member.value.as<formats::Table>()) parts += table->members.size();
    if (const auto* array = member.value.as<formats::Array>()) parts += array->items.size();
  }
  return parts;
}

/// Text of a value as it stands in a file: "1N2B in" with its quotes.
std::string spelled_in_file(const formats::Value& value) {
  const std::string text = formats::spell_value({{}, formats::Array{{value}}});
  return text.substr(1, text.size() - 2);
}

std::string path_in(const std::string& change) { return formats::read_change(change).path; }

/// Such as "panels.bag.aft = 20 and then panels.bag.fore = 20".
std::string sentence_of(const Cure& cure) {
  std::string text;
  for (const auto& one : cure.changes) {
    const formats::Change change = formats::read_change(one);
    text += (text.empty() ? "" : ", and then ") + change.path + " = " + spelled_in_file(change.value);
  }
  return text + (cure.note.empty() ? "" : ", " + cure.note);
}

/// Tries the proposals for all messages about one plan. Each proposal is tried once, and may remove several
/// messages.
class CureTrials {
 public:
  CureTrials(const formats::Value& root, const Catalogue& catalogue, const formats::Diagnostics& said,
             const CureLimits& limits)
      : root_(root),
        catalogue_(catalogue),
        sources_(said.without_messages()),
        limits_(limits),
        left_(std::clamp(limits.part_trials / number_of_parts(root), limits.least, limits.most)),
        before_(check({})) {
    for (const auto& message : said.messages())
      if (message.accepted.empty()) all_.insert(all_.end(), message.cures.begin(), message.cures.end());
    for (const Cure& cure : all_) after(cure.changes);
  }

  /// The message with the hint that follows from the trials.
  Diagnostic cured(Diagnostic message) {
    std::vector<Trial> trials = helping(message);
    message.cures.clear();
    if (trials.empty()) return message;
    std::stable_sort(trials.begin(), trials.end(), is_better);
    if (!trials[0].is_clean())
      if (const auto whole = complete(message, trials)) trials = {*whole};
    message.changes = trials[0].cure.changes;
    const std::string general = message.hint.empty() ? "" : "; " + message.hint;
    message.hint = (trials[0].is_clean() ? choice_of(trials) : rest_of(trials[0])) + general;
    return message;
  }

 private:
  Findings check(const std::vector<std::string>& changes) const {
    formats::Diagnostics said = sources_;
    formats::Value root = root_;
    for (const auto& change : changes)
      formats::apply(root, formats::read_change(change), said, keys_that_name_parts());
    NetPlan plan = read_plan(root, catalogue_, said);
    const bool was_read = said.errors() == 0;
    if (was_read) check_plan(plan, said);
    // After errors, check_plan() leaves out some checks. Their messages must not count as new later.
    if (was_read && said.errors()) {
      check_loose_ropes(plan, {}, said);
      check_open_edges(plan, said);
    }
    formats::mark_accepted(root, said);
    Findings findings;
    for (const auto& message : said.messages())
      if (message.accepted.empty()) findings.add(message);
    return findings;
  }

  /// The findings after changes; nullptr if no more trials are allowed.
  const Findings* after(const std::vector<std::string>& changes) {
    if (const auto done = tried_.find(changes); done != tried_.end()) return &done->second;
    if (left_ == 0) return nullptr;
    --left_;
    return &tried_.emplace(changes, check(changes)).first->second;
  }

  /// Tries a proposal. nullopt if it does not remove the message, or if no more trials are allowed.
  std::optional<Trial> attempt(const Cure& cure, const Diagnostic& message) {
    const Findings* findings = after(cure.changes);
    const std::string kind = kind_of(message);
    if (!findings || findings->count(kind) >= before_.count(kind)) return std::nullopt;
    Trial trial{cure, *findings, {}};
    for (const auto severity : {formats::Severity::error, formats::Severity::warning})
      for (const auto& one : findings->messages)
        if (one.severity == severity && is_new(one, *findings)) trial.caused.push_back(one);
    return trial;
  }

  bool is_new(const Diagnostic& message, const Findings& findings) const {
    const std::string kind = kind_of(message);
    return findings.count(kind) > before_.count(kind) ||
           (message.severity == formats::Severity::error &&
            findings.count_errors(kind) > before_.count_errors(kind));
  }

  /// The proposals that remove a message; its own proposals come first.
  std::vector<Trial> helping(const Diagnostic& message) {
    std::vector<Trial> trials;
    for (const Cures* cures : {&message.cures, &std::as_const(all_)})
      for (const Cure& cure : *cures) {
        const bool is_known =
            std::ranges::any_of(trials, [&](const Trial& t) { return t.cure.changes == cure.changes; });
        if (auto trial = is_known ? std::nullopt : attempt(cure, message))
          trials.push_back(std::move(*trial));
      }
    return trials;
  }

  /// Completes one of the best proposals by further values, which remove the messages that the proposal
  /// causes; nullopt if that is impossible.
  std::optional<Trial> complete(const Diagnostic& message, const std::vector<Trial>& trials) {
    constexpr std::size_t kMostCompleted = 4;
    for (std::size_t i = 0; i < std::min(kMostCompleted, trials.size()); ++i)
      if (auto whole = extend(trials[i], message)) return whole;
    return std::nullopt;
  }

  std::optional<Trial> extend(const Trial& trial, const Diagnostic& message) {
    if (trial.cure.changes.size() >= limits_.steps) return std::nullopt;
    std::optional<Trial> best;
    for (const Cure& next : trial.caused[0].cures) {
      Cure longer = trial.cure;
      if (changes_again(longer, next)) continue;
      longer.changes.insert(longer.changes.end(), next.changes.begin(), next.changes.end());
      auto extended = attempt(longer, message);
      if (!extended || extended->caused.size() > trial.caused.size()) continue;
      if (extended->is_clean()) return extended;
      if (!best || is_better(*extended, *best)) best = std::move(extended);
    }
    return best ? extend(*best, message) : std::nullopt;
  }

  static bool changes_again(const Cure& cure, const Cure& next) {
    return std::ranges::any_of(cure.changes, [&](const std::string& done) {
      return std::ranges::any_of(next.changes,
                                 [&](const std::string& change) { return path_in(change) == path_in(done); });
    });
  }

  /// The best proposals, one for each key, if they are equally good: for example, "aft = 20, or depth = 50".
  std::string choice_of(const std::vector<Trial>& trials) const {
    std::string text;
    std::vector<std::string> paths;
    for (const Trial& trial : trials) {
      const std::string path = path_in(trial.cure.changes[0]);
      if (is_better(trials[0], trial) || paths.size() == limits_.alternatives) break;
      if (std::ranges::find(paths, path) != paths.end()) continue;
      paths.push_back(path);
      text += (text.empty() ? "" : ", or ") + sentence_of(trial.cure);
    }
    return text;
  }

  static std::string rest_of(const Trial& trial) {
    return sentence_of(trial.cure) + ", but then: " + trial.caused[0].message;
  }

  const formats::Value& root_;
  const Catalogue& catalogue_;
  const formats::Diagnostics sources_;
  const CureLimits limits_;
  std::size_t left_;  // trials that are still allowed
  const Findings before_;
  Cures all_;
  std::map<std::vector<std::string>, Findings> tried_;  // by the changes
};

}  // namespace

void try_cures(const formats::Value& root, const Catalogue& catalogue, formats::Diagnostics& diagnostics,
               const CureLimits& limits) {
  const auto& said = diagnostics.messages();
  if (std::ranges::none_of(said, [](const auto& m) { return !m.cures.empty() && m.accepted.empty(); }))
    return;
  CureTrials trials(root, catalogue, diagnostics, limits);
  std::vector<Diagnostic> messages;
  for (std::size_t i = 0; i < said.size(); ++i)
    messages.push_back(
        i < formats::Diagnostics::kMostCured && said[i].accepted.empty() ? trials.cured(said[i]) : said[i]);
  diagnostics = diagnostics.without_messages();
  diagnostics.take_messages(messages);
}

}  // namespace netloft::gears
