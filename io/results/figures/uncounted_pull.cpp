// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/uncounted_pull.hpp"

#include "io/results/figures/make_result.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace netloft::results {

namespace {

// Smallest uncounted pull that is reported, as a fraction of the pull of the warps. At sea, pulls are
// measured to a hundredth at best.
constexpr double kCounts = 0.01;

/// The nodes of the scene at which warps begin. The figures of towing count the pull at these nodes.
std::set<std::uint32_t> starts_of_warps(const scenes::LoadedScene& loaded) {
  std::set<std::uint32_t> starts;
  if (const auto warps = loaded.gear->roles.find("warp"); warps != loaded.gear->roles.end())
    for (const auto rope : warps->second) starts.insert(loaded.parts[rope].nodes.front());
  return starts;
}

}  // namespace

std::vector<std::string> uncounted_pull_warnings(const scenes::LoadedScene& loaded,
                                                 const Assembler& assembler, std::span<const double> residual,
                                                 const std::vector<NamedScalar>& figures) {
  std::vector<std::string> warnings;
  const NamedScalar* pull = loaded.gear ? find_scalar(figures, "towing/pull") : nullptr;
  if (!pull) return warnings;
  const auto starts = starts_of_warps(loaded);
  for (const scenes::Hold& hold : loaded.holds) {
    double forwards = 0;  // pull forwards, of the whole gear [N]
    for (std::size_t i = 0; i < hold.nodes.size(); ++i)
      if (!starts.contains(hold.nodes[i]))
        forwards -= loaded.gear->times * assembler.reaction(hold.nodes[i], residual, hold.axes[i])[0];
    if (forwards > kCounts * std::abs(pull->value))
      warnings.push_back(
          fmt::format("{} pulls the gear forwards with {:.4g} N, which towing/pull ({:.4g} N) leaves out: "
                      "give a rope that begins there role = \"warp\" to count its pull",
                      hold.name, forwards, pull->value));
  }
  return warnings;
}

}  // namespace netloft::results
