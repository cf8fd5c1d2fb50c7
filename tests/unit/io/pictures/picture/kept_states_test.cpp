// SPDX-License-Identifier: BSD-3-Clause
#include "io/pictures/view/result_json.hpp"

#include <gtest/gtest.h>

namespace netloft::pictures {
namespace {

using States = std::vector<std::size_t>;

TEST(KeptStates, AreAllOfThemWhereThereIsRoom) { EXPECT_EQ(kept_states(3, 100), (States{0, 1, 2})); }

TEST(KeptStates, AreSpacedEvenlyFromTheFirstToTheLast) {
  EXPECT_EQ(kept_states(101, 5), (States{0, 25, 50, 75, 100}));
}

TEST(KeptStates, EndWithTheNewestEvenWhereOneIsKept) { EXPECT_EQ(kept_states(7, 1), (States{6})); }

}  // namespace
}  // namespace netloft::pictures
