// SPDX-License-Identifier: BSD-3-Clause
#include "framework/registry/plugin_call.hpp"

#include <gtest/gtest.h>

#include <pthread.h>

#include <algorithm>
#include <cfenv>
#include <stdexcept>
#include <thread>

namespace netloft {
namespace {

constexpr CallFrame kSolver{"slow/solver", "solve", nullptr, CallFrame::Kind::method};
constexpr CallFrame kTerm{"rope/bar", "term", "elastic", CallFrame::Kind::element};

TEST(PluginCall, NamesWhoIsAtWork) {
  const CallStack& calls = calls_of_this_thread();
  EXPECT_FALSE(calls.innermost_plugin().has_value());
  {
    const PluginCall solver(kSolver);
    EXPECT_EQ(text_of(calls.innermost()), "slow/solver, solve");
    const HostCall back;
    EXPECT_EQ(calls.innermost().kind, CallFrame::Kind::host);
    EXPECT_EQ(text_of(*calls.innermost_plugin()), "slow/solver, solve");
    const PluginCall term(kTerm);
    EXPECT_EQ(text_of(calls.innermost()), "rope/bar, term elastic");
    EXPECT_EQ(calls.depth(), 3u);
  }
  EXPECT_EQ(calls.depth(), 0u);
  EXPECT_EQ(text_of(calls.innermost()), "the program itself");
}

TEST(PluginCall, CountsWhatGoesOnAndWhatCallsBack) {
  const CallStack& calls = calls_of_this_thread();
  const auto crossings = calls.crossings(), callbacks = calls.callbacks();
  {
    const PluginCall solver(kSolver);
    const HostCall back;
  }
  EXPECT_EQ(calls.crossings(), crossings + 4);
  EXPECT_EQ(calls.callbacks(), callbacks + 1);
}

TEST(PluginCall, KnowsWhoHasStoodSinceItIsWatched) {
  CallStack& calls = calls_of_this_thread();
  const PluginCall strategy(kSolver);
  {
    const HostCall back;
    const PluginCall term(kTerm);
    calls.watch_depth();
    EXPECT_EQ(calls.lowest(), 3u);
  }
  const HostCall back;
  EXPECT_EQ(calls.lowest(), 1u) << "only the outermost has not returned";
}

void nest(int more) {
  const PluginCall call(kTerm);
  if (more > 0) nest(more - 1);
}

TEST(PluginCall, SurvivesWhatIsNestedDeeperThanItHasNamesFor) {
  nest(3 * static_cast<int>(CallStack::kDeepest));
  EXPECT_EQ(calls_of_this_thread().depth(), 0u);
}

// ---------------------------------------------------------------- the rules of the boundary

template <class Body>
std::string rule_broken_by(Body&& body) {
  EXPECT_EQ(call_plugin(kTerm, -1, body), -1);
  return take_broken_rule();
}

TEST(PluginCall, ReturnsWhatAFunctionReturnsThatKeepsTheRules) {
  EXPECT_EQ(call_plugin(kTerm, -1, [] { return 7; }), 7);
  EXPECT_EQ(take_broken_rule(), "");
}

TEST(PluginCall, LetsNoExceptionOut) {
  const std::string thrown = rule_broken_by([]() -> int { throw std::runtime_error("unfinished"); });
  EXPECT_EQ(thrown, "rope/bar let an exception out of term elastic: unfinished");
  EXPECT_EQ(rule_broken_by([]() -> int { throw 1; }), "rope/bar let an exception out of term elastic");
  EXPECT_EQ(calls_of_this_thread().depth(), 0u);
}

TEST(PluginCall, RestoresTheDirectionOfRounding) {
  const int before = std::fegetround();
  const std::string left = rule_broken_by([] { return std::fesetround(FE_UPWARD); });
  EXPECT_NE(left.find("rope/bar left another floating-point mode"), std::string::npos) << left;
  EXPECT_EQ(std::fegetround(), before);
}

TEST(PluginCall, LetsTheHostComputeInItsOwnModeWhenAMethodCallsBack) {
  const int before = std::fegetround();
  const int status = call_plugin(kSolver, -1, [&] {
    std::fesetround(FE_UPWARD);
    const HostCall back;
    EXPECT_EQ(std::fegetround(), before);
    return 0;
  });
  EXPECT_EQ(status, -1);
  EXPECT_NE(take_broken_rule().find("slow/solver left another"), std::string::npos);
}

TEST(PluginCall, ToleratesFlagsOfExceptions) {
  EXPECT_EQ(call_plugin(kTerm, -1, [] { return std::feraiseexcept(FE_DIVBYZERO | FE_INEXACT); }), 0);
  EXPECT_EQ(take_broken_rule(), "");
}

TEST(PluginCall, BlamesALawAndNotTheElementThatCallsIt) {
  constexpr CallFrame kLaw{"hydro/law", "evaluate", nullptr, CallFrame::Kind::element};
  const std::string broken = rule_broken_by([&] {
    call_plugin(kLaw, -1, [] { return std::fesetround(FE_DOWNWARD); });
    return 0;  // as if the element ignored the status
  });
  EXPECT_NE(broken.find("hydro/law left another"), std::string::npos) << broken;
}

TEST(PluginCall, EndsTheSentenceOfAPluginThatHasNoEnd) {
  char text[4] = {'x', 'x', 'x', 'x'};
  EXPECT_FALSE(take_broken_rule(text));
  EXPECT_STREQ(text, "xxx");
}

TEST(PluginCallDeathTest, EndsTheProgramAfterAJumpOverFunctionsOfTheHost) {
  const auto jump_over_host = [] {
    call_plugin(kSolver, -1, [] {
      calls_of_this_thread().push({});  // a call of the host that never returns
      return 0;
    });
  };
  EXPECT_DEATH(jump_over_host(), "");
}

TEST(PluginCallDeathTest, EndsTheProgramIfAPluginEndsItsThread) {
  const auto end_thread = [] { call_plugin(kTerm, -1, []() -> int { pthread_exit(nullptr); }); };
  EXPECT_DEATH(end_thread(), "");
}

TEST(PluginCall, IsSeenFromOtherThreads) {
  const PluginCall call(kSolver);
  const CallStack* mine = &calls_of_this_thread();
  std::thread([mine] {
    const auto all = calls_of_all_threads();
    EXPECT_EQ(std::count(all.begin(), all.end(), mine), 1);
    EXPECT_EQ(text_of(mine->innermost()), "slow/solver, solve");
    EXPECT_NE(&calls_of_this_thread(), mine);
  }).join();
}

}  // namespace
}  // namespace netloft
