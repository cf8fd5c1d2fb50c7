// SPDX-License-Identifier: BSD-3-Clause
#include "framework/registry/plugin_call.hpp"

#include <gtest/gtest.h>

#include <algorithm>
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
