// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/overload.hpp"

#include "framework/registry/element_outputs.hpp"
#include "io/results/figures/materials.hpp"
#include "io/scenes/reading/halves.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace netloft::results {

namespace {

// Largest plausible strain. Gears of the library reach 0.11; plans with a wrong number reach 0.6 and more. A
// test panel of the trawl-gear paper, which has an unrealistic stiffness, reaches 0.56.
constexpr double kMostStrain = 0.5;

/// For each part, the largest value of its outputs of one kind; 0 if it has no such output.
template <class IsOfKind>
std::vector<double> largest_outputs(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                    const Response& answer, IsOfKind is_of_kind) {
  std::vector<double> largest(loaded.scene.parts.size(), 0.0);
  for (std::size_t f = 0; f < answer.outputs.size(); ++f) {
    const ElementFamily& family = *assembler.families()[f];
    for (std::size_t k = 0; k < family.type().outputs.size(); ++k)
      for (std::size_t e = 0; e < family.size(); ++e)
        if (is_of_kind(family.type().outputs[k]))
          largest[family.part(e)] = std::max(largest[family.part(e)], answer.outputs[f][k][e]);
  }
  return largest;
}

/// Whether a part is in the bill of materials.
bool is_in_bill(const scenes::LoadedScene& loaded, const std::string& part) {
  return loaded.gear &&
         std::ranges::any_of(loaded.gear->bill, [&](const auto& item) { return is_called(part, item.name); });
}

}  // namespace

std::vector<std::string> overload_warnings(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                           const Response& answer) {
  std::vector<std::string> warnings;
  const auto largest = largest_outputs(loaded, assembler, answer, is_tension);
  for (std::size_t p = 0; p < largest.size(); ++p) {
    const std::string& name = loaded.scene.parts[p].name;
    const auto at = loaded.strengths.find(name);
    if (is_in_bill(loaded, name)) continue;
    if (at == loaded.strengths.end() || !(largest[p] > at->second.breaking_load)) continue;
    warnings.push_back(fmt::format("{} carries {:.4g} N and breaks at {:.4g} N{}", at->first, largest[p],
                                   at->second.breaking_load,
                                   at->second.material.empty() ? "" : " (" + at->second.material + ")"));
  }
  const auto strain =
      largest_outputs(loaded, assembler, answer, [](const auto& o) { return is_output(o, output::kStrain); });
  for (std::size_t p = 0; p < strain.size(); ++p)
    if (strain[p] > kMostStrain)
      warnings.push_back(fmt::format("{} is stretched by {:.3g} %, at which ropes and twines of nets break",
                                     loaded.scene.parts[p].name, 100 * strain[p]));
  return warnings;
}

std::vector<std::string> doubt_warnings(const scenes::LoadedScene& loaded, const Assembler& assembler,
                                        const Response& answer) {
  std::vector<std::string> warnings;
  for (std::size_t f = 0; f < answer.outputs.size(); ++f) {
    const ElementFamily& family = *assembler.families()[f];
    for (std::size_t k = 0; k < family.type().outputs.size(); ++k) {
      if (family.type().outputs[k].role != NETLOFT_OUTPUT_DOUBT) continue;
      // For each part: the number of elements outside their range of validity, and of all elements.
      std::map<std::uint32_t, std::array<std::size_t, 2>> elements;
      for (std::size_t e = 0; e < family.size(); ++e) {
        auto& [in_doubt, all] = elements[family.part(e)];
        in_doubt += answer.outputs[f][k][e] != 0;
        ++all;
      }
      for (const auto& [part, count] : elements)
        if (count[0] > 0)
          warnings.push_back(
              fmt::format("{}: {}{}", loaded.scene.parts[part].name, family.type().outputs[k].doc,
                          count[1] > 1 ? fmt::format(", at {} of its {} elements", count[0], count[1]) : ""));
    }
  }
  for (const auto& crossing : scenes::find_crossings(loaded, assembler.node_positions(answer.x)))
    warnings.push_back(crossing.sentence);
  return warnings;
}

}  // namespace netloft::results
