// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/work_notes.hpp"

#include <gtest/gtest.h>

namespace netloft::formats {
namespace {

using netloft::test::WorkNotes;
using Heard = std::vector<std::string>;

TEST(LongWork, IsFollowedFromItsFirstStepToItsEnd) {
  WorkNotes notes;
  report({"reading", "before"});
  {
    const LongWork work({"reading", "a.toml"});
    report({"meshing", "belly", 12, "nodes"});
    hear_interruption();
  }
  report({"reading", "after"});
  EXPECT_EQ(notes.heard, (Heard{"reading a.toml", "meshing belly", "…", "end"}));
}

TEST(LongWork, WithinOtherWorkIsAPartOfIt) {
  WorkNotes notes;
  {
    const LongWork work({"reading", "a.toml"});
    { const LongWork part({"checking", "the net plan"}); }
    report({"assembling", "a"});
  }
  EXPECT_EQ(notes.heard, (Heard{"reading a.toml", "checking the net plan", "assembling a", "end"}));
}

TEST(LongWork, ThatIsInterruptedEnds) {
  for (const char* last : {"reading a.toml", "meshing belly"}) {
    WorkNotes notes(last);
    const auto work = [] {
      const LongWork reading({"reading", "a.toml"});
      report({"meshing", "belly"});
    };
    EXPECT_THROW(work(), Interrupted);
    EXPECT_EQ(notes.heard.back(), "end") << last;
    report({"reading", "after"});
    EXPECT_EQ(notes.heard.back(), "end") << last;
  }
}

TEST(LongWork, NeedsNobodyToFollowIt) {
  const LongWork work({"reading", "a.toml"});
  report({"meshing", "belly"});
  hear_interruption();
}

}  // namespace
}  // namespace netloft::formats
