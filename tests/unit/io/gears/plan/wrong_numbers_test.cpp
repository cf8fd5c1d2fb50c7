// SPDX-License-Identifier: BSD-3-Clause
// Plans in which one number is wrong. Every value that a hint proposes is written into the plan, and the plan
// is checked again: the message must be gone and no new one appear, or the hint must say what else is needed.
#include "tests/unit/io/gears/plan/wrong_numbers.hpp"
#include "tests/unit/io/gears/plan/plans.hpp"

#include "io/formats/toml/accepted_warnings.hpp"
#include "io/formats/toml/change.hpp"

#include <cstdio>
#include <map>
#include <set>

namespace netloft::gears {
namespace {

/// Results of the hints of several hundred messages.
struct Tally {
  std::map<std::string, int> messages, plans;

  void print(const char* heading) const {
    std::printf("| %s | messages | first messages of plans |\n|---|---|---|\n", heading);
    for (const auto& [what, times] : messages) {
      const auto first = plans.find(what);
      std::printf("| %s | %d | %d |\n", what.c_str(), times, first == plans.end() ? 0 : first->second);
    }
  }
};

constexpr const char *kPasses = "the plan passes", *kGone = "the message goes, others that were there stay",
                     *kSays = "the hint says what else is needed", *kNothing = "the hint proposes no value",
                     *kWrong = "the hint is wrong";

/// A plan in which a number was changed, and the messages of the check.
class WrongPlan {
 public:
  WrongPlan(formats::Value root, const Catalogue& catalogue)
      : root_(std::move(root)), catalogue_(catalogue), said_(check(root_, true)) {}

  std::vector<formats::Diagnostic> messages() const { return said_.sorted(); }

  const char* follow(const formats::Diagnostic& message) const {
    if (message.changes.empty()) return kNothing;
    formats::Value changed = root_;
    formats::Diagnostics faults;
    for (const auto& change : message.changes) formats::apply(changed, formats::read_change(change), faults);
    const formats::Diagnostics after = check(changed, false);
    const auto kinds_before = kinds_of(said_), kinds_after = kinds_of(after);
    const std::string kind = test::without_numbers(message.message);
    const bool is_gone = count(kinds_after, kind) < count(kinds_before, kind);
    if (!is_gone || faults.errors()) return kWrong;
    if (after.errors() + after.warnings() == 0) return kPasses;
    if (message.hint.find(", but then: ") != std::string::npos) return kSays;
    for (const auto& [other, times] : kinds_after)
      if (times > count(kinds_before, other)) return is_late(after, other) ? kGone : kWrong;
    return kGone;
  }

 private:
  formats::Diagnostics check(const formats::Value& root, bool with_cures) const {
    formats::Diagnostics said;
    if (with_cures) {
      PlanMemory none;
      const NetPlan plan = read_and_check(root, catalogue_, none, HintTrials::of_all, said);
      if (said.errors() == 0) check_seams(plan, said);
      return said;
    }
    NetPlan plan = read_plan(root, catalogue_, said);
    if (said.errors() == 0) check_plan(plan, said);
    if (said.errors() == 0) check_seams(plan, said);
    formats::mark_accepted(root, said);
    return said;
  }

  /// Whether a message is a warning of a check that did not run before because of errors.
  bool is_late(const formats::Diagnostics& after, const std::string& kind) const {
    return said_.errors() > 0 && after.errors() == 0 &&
           (kind.find("neither sewn nor hung") != std::string::npos ||
            kind.find("carry no netting") != std::string::npos);
  }

  static std::map<std::string, int> kinds_of(const formats::Diagnostics& said) {
    std::map<std::string, int> kinds;
    for (const auto& message : said.sorted()) {
      ++kinds[test::without_numbers(message.message)];
      if (message.severity == formats::Severity::error)
        ++kinds["error: " + test::without_numbers(message.message)];
    }
    return kinds;
  }
  static int count(const std::map<std::string, int>& kinds, const std::string& kind) {
    const auto at = kinds.find(kind);
    return at == kinds.end() ? 0 : at->second;
  }

  formats::Value root_;
  const Catalogue& catalogue_;
  formats::Diagnostics said_;
};

std::vector<PlanDocument> right_plans() {
  std::vector<PlanDocument> plans;
  formats::Diagnostics diagnostics;
  plans.push_back(*PlanDocument::parse(kGoodPlan, "good.toml", diagnostics));
  std::set<std::filesystem::path> files;  // sorted, so that the draws are the same everywhere
  for (const auto& entry : std::filesystem::directory_iterator(test::source_folder() + "/gear-library/gears"))
    if (entry.path().extension() == ".toml") files.insert(entry.path());
  for (const auto& file : files) plans.push_back(*PlanDocument::load(file, {}, diagnostics));
  EXPECT_EQ(diagnostics.errors(), 0) << diagnostics.render(false);
  return plans;
}

TEST(WrongNumbers, AreAnsweredWithValuesThatHelp) {
  constexpr int kPlans = 500;
  const auto rights = right_plans();
  test::NumberDraw draw(1);
  Tally tally;
  for (int wrong = 0; wrong < kPlans;) {
    const PlanDocument& right = rights[draw.below(rights.size())];
    const auto change = draw.wrong_number(right.root);
    formats::Value root = right.root;
    formats::Diagnostics faults;
    formats::apply(root, change, faults);
    ASSERT_EQ(faults.errors(), 0) << change.text;
    const WrongPlan plan(std::move(root), right.catalogue);
    const auto messages = plan.messages();
    if (messages.empty()) continue;
    ++wrong;
    for (std::size_t i = 0; i < messages.size(); ++i) {
      const std::string what = plan.follow(messages[i]);
      ++tally.messages[what];
      if (i == 0) ++tally.plans[what];
      EXPECT_NE(what, kWrong) << change.text << '\n' << messages[i].message << '\n' << messages[i].hint;
    }
  }
  tally.print("what the first proposal of a hint does");
  EXPECT_LE(tally.plans[kNothing], kPlans * 5 / 100);
  EXPECT_GE(tally.plans[kPasses], kPlans * 95 / 100);
}

}  // namespace
}  // namespace netloft::gears
