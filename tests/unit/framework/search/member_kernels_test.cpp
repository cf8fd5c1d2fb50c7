// SPDX-License-Identifier: BSD-3-Clause
#include "framework/search/member_kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace netloft {
namespace {

double made_up(std::size_t i) { return std::sin(1.0 + 1.7 * static_cast<double>(i * i)); }

/// A bar between nodes 0 and 1, two members of a triangle on nodes 1, 2 and 3, and one member on nodes 2, 3
/// and 0, whose last pair of nodes has no block.
struct Members {
  static constexpr std::size_t kNodes = 4;
  std::vector<MemberSite> sites{site(0, 1, {0, 1}), site(1, 2, {1, 2, 3}), site(3, 1, {2, 3, 0})};
  std::vector<MemberWeights> weights;
  std::vector<double> lines;   // (t, f, a, b) of each
  std::vector<double> blocks;  // a t tᵀ + b I of each

  Members() {
    sites[2].block[3 * 2 + 2] = -1;
    for (std::size_t e = 0; e < 4; ++e) {
      const auto number = [&](std::size_t i) { return made_up(20 * e + i); };
      weights.push_back({{number(0), number(1), number(2)}, {number(3), number(4), number(5)}});
      for (std::size_t k = 0; k < 3; ++k) weights[e].number_c[k] = number(6) * weights[e].c[k];
      for (std::size_t i = 7; i < 13; ++i) lines.push_back(number(i));
      const double *t = &lines[6 * e], a = t[4], b = t[5];
      for (std::size_t i = 0; i < 9; ++i) blocks.push_back(a * t[i / 3] * t[i % 3] + (i % 4 == 0 ? b : 0));
    }
  }
  static MemberSite site(std::uint32_t first, std::uint32_t members, std::vector<int> nodes) {
    MemberSite s;
    s.first = first, s.members = members, s.nodes = static_cast<std::uint32_t>(nodes.size());
    for (std::size_t i = 0; i < 3 * nodes.size(); ++i) s.dof[i] = 3 * nodes[i / 3] + static_cast<int>(i % 3);
    for (std::size_t p = 0; p < nodes.size(); ++p)
      for (std::size_t q = 0; q < nodes.size(); ++q)
        s.block[3 * p + q] = 9 * (static_cast<int>(kNodes) * nodes[p] + nodes[q]);
    return s;
  }
  MemberTable table() const { return {sites, weights}; }

  /// Calls visit(site, member) for all members of all sites.
  template <class Visit>
  void for_members(const Visit& visit) const {
    for (const MemberSite& s : sites)
      for (std::size_t e = s.first; e < s.first + s.members; ++e) visit(s, e);
  }
  std::vector<double> expected_values() const {
    std::vector<double> values(9 * kNodes * kNodes, 0.5);
    for_members([&](const MemberSite& s, std::size_t e) {
      for (std::size_t p = 0; p < s.nodes; ++p)
        for (std::size_t q = 0; q < s.nodes; ++q)
          for (std::size_t i = 0; i < 9 && s.block[3 * p + q] >= 0; ++i)
            values[static_cast<std::size_t>(s.block[3 * p + q]) + i] +=
                weights[e].number_c[p] * weights[e].c[q] * blocks[9 * e + i];
    });
    return values;
  }
  std::vector<double> expected_forces() const {
    std::vector<double> forces(3 * kNodes, 0.5);
    for_members([&](const MemberSite& s, std::size_t e) {
      for (std::size_t i = 0; i < 3 * s.nodes; ++i)
        forces[static_cast<std::size_t>(s.dof[i])] +=
            weights[e].number_c[i / 3] * lines[6 * e + 3] * lines[6 * e + i % 3];
    });
    return forces;
  }
};

void expect_near(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-15) << i;
}

TEST(MemberKernels, AddBlocksOfAllPairsOfNodes) {
  const Members members;
  for (const MemberKernels& kernels : member_kernels_here()) {
    std::vector<double> values(members.expected_values().size(), 0.5);
    kernels.add_blocks(members.table(), members.blocks.data(), values.data());
    expect_near(values, members.expected_values());
  }
}

TEST(MemberKernels, AddForcesAndTangentsAlongLines) {
  const Members members;
  for (const MemberKernels& kernels : member_kernels_here()) {
    std::vector<double> values(members.expected_values().size(), 0.5),
        forces(members.expected_forces().size(), 0.5);
    kernels.add_lines(members.table(), members.lines.data(), forces.data(), values.data());
    expect_near(values, members.expected_values());
    expect_near(forces, members.expected_forces());
  }
}

TEST(MemberKernels, GiveTheSameBitsInWideRegistersAsInNarrowOnes) {
  const Members members;
  std::vector<std::vector<double>> all;
  for (const MemberKernels& kernels : member_kernels_here()) {
    std::vector<double>& values = all.emplace_back(members.expected_values().size(), 0.5);
    std::vector<double> forces(members.expected_forces().size());
    kernels.add_lines(members.table(), members.lines.data(), forces.data(), values.data());
    values.insert(values.end(), forces.begin(), forces.end());
    EXPECT_EQ(values, all.front());
  }
}

}  // namespace
}  // namespace netloft
