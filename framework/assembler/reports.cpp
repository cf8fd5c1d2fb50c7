// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/reports.hpp"

#include "framework/assembler/scatter.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace netloft {

namespace {

auto caller_of(const ElementFamily& family, std::size_t term) {
  assert(term < family.active_terms().size());
  return [&family, term](std::size_t, netloft_tile& t, TileSums&) {
    return family.evaluate(family.active_terms()[term], t);
  };
}

const auto ignore = [](std::size_t, const netloft_tile&, const TileSums&) {};

}  // namespace

const ElementFamily& ElementReports::family_at(std::size_t family) const {
  assert(family < elements_.tiles().families.size());
  return *elements_.tiles().families[family];
}

/// Adds the force of a term at the nodes of its elements. Forces on carried nodes are not passed on to
/// bodies.
bool ElementReports::add_term(std::span<const double> x, std::size_t family, std::size_t term,
                              std::span<double> residual, const Kinematics& motion) {
  const ElementTiles& tiles = elements_.tiles();
  const Tiling& tiling = tiles.group_of(family).tiling;
  return elements_.visit(x, motion, family, caller_of(family_at(family), term),
                         [&](std::size_t tile, const netloft_tile&, TileSums& of_tile) {
                           scatter(tiling, tile, tiles.symmetric, of_tile, residual.data(), nullptr);
                         });
}

bool ElementReports::evaluate_term(std::span<const double> x, std::size_t family, std::size_t term,
                                   std::span<double> residual, const Kinematics& motion) {
  assert(residual.size() == x.size());
  std::fill(residual.begin(), residual.end(), 0.0);
  const bool done = add_term(x, family, term, residual, motion);
  bodies_.hand_on(x, {}, residual.data(), {}, false);
  frames_.turn(residual.data());
  return done;
}

/// After each term, only the entries of the nodes of its elements are added and cleared. The time is
/// therefore proportional to the number of elements, even if there are many families.
std::vector<double> ElementReports::sum_terms(std::span<const double> x, bool (*counts)(std::uint32_t)) {
  const ElementTiles& tiles = elements_.tiles();
  std::vector<double> sum(x.size(), 0.0), alone(x.size(), 0.0);
  for (std::size_t f = 0; f < tiles.families.size(); ++f) {
    const auto& terms = family_at(f).active_terms();
    for (std::size_t t = 0; t < terms.size(); ++t) {
      if (!counts(terms[t].traits)) continue;
      const bool done = add_term(x, f, t, alone, {});
      for (const std::int32_t dof : tiles.group_of(f).tiling.vector_map) {
        const auto i = static_cast<std::size_t>(dof);
        if (done) sum[i] += alone[i];
        alone[i] = 0;
      }
    }
  }
  bodies_.hand_on(x, {}, sum.data(), {}, false);
  frames_.turn(sum.data());
  return sum;
}

bool ElementReports::term_energy(std::span<const double> x, std::size_t family, std::size_t term,
                                 double& energy, const Kinematics& motion) {
  energy = 0;
  const ElementFamily& f = family_at(family);
  assert(term < f.active_terms().size());
  const netloft_term& wanted = f.active_terms()[term];
  if (!(wanted.traits & NETLOFT_CONSERVATIVE)) return true;
  const auto evaluate = [&](std::size_t, netloft_tile& t, TileSums& of_tile) {
    t.energy = of_tile.energy;
    t.force = nullptr;
    t.want = NETLOFT_WANT_ENERGY;
    return f.evaluate(wanted, t);
  };
  return elements_.visit(x, motion, family, evaluate,
                         [&](std::size_t, const netloft_tile& t, const TileSums& of_tile) {
                           for (std::size_t lane = 0; lane < t.count; ++lane) energy += of_tile.energy[lane];
                         });
}

/// Only the rows of nodes are summed; moments are in the rows after them.
bool ElementReports::sum_term(std::span<const double> x, std::size_t family, std::size_t term,
                              std::span<double> sums, const Kinematics& motion) {
  const ElementFamily& f = family_at(family);
  assert(sums.size() == 3 * f.parts().size());
  std::fill(sums.begin(), sums.end(), 0.0);
  const auto rows = 3 * static_cast<std::size_t>(f.nodes_per_element());
  std::size_t part = 0;
  const auto add = [&](std::size_t, const netloft_tile& t, const TileSums& of_tile) {
    for (std::size_t lane = 0; lane < t.count; ++lane) {
      while (t.first + lane >= f.part_begin()[part + 1]) ++part;
      for (std::size_t d = 0; d < rows; ++d)
        sums[3 * part + d % 3] += of_tile.force.data()[d * kTileLanes + lane];
    }
  };
  return elements_.visit(x, motion, family, caller_of(f, term), add);
}

bool ElementReports::sum_term_at(std::span<const double> x, std::size_t family, std::size_t term,
                                 std::span<const std::int32_t> groups, std::size_t group_count,
                                 std::span<double> sums, const Kinematics& motion) {
  const ElementFamily& f = family_at(family);
  assert(sums.size() == 3 * f.parts().size() * group_count);
  std::fill(sums.begin(), sums.end(), 0.0);
  std::size_t part = 0;
  const auto add = [&](std::size_t, const netloft_tile& t, const TileSums& of_tile) {
    for (std::size_t lane = 0; lane < t.count; ++lane) {
      while (t.first + lane >= f.part_begin()[part + 1]) ++part;
      for (int n = 0; n < f.nodes_per_element(); ++n) {
        const std::uint32_t node = f.node(t.first + lane, n);
        if (node >= groups.size() || groups[node] < 0) continue;
        double* sum = &sums[3 * (part * group_count + static_cast<std::size_t>(groups[node]))];
        for (std::size_t axis = 0; axis < 3; ++axis)
          sum[axis] += of_tile.force.data()[(3 * static_cast<std::size_t>(n) + axis) * kTileLanes + lane];
      }
    }
  };
  return elements_.visit(x, motion, family, caller_of(f, term), add);
}

bool ElementReports::outputs(std::span<const double> x, std::size_t family,
                             std::vector<std::vector<double>>& values, const Kinematics& motion) {
  const ElementFamily& f = family_at(family);
  const std::size_t count = f.type().outputs.size();
  values.assign(count, std::vector<double>(f.size()));
  if (!count) return true;
  // If a flow changes the water of this family, another family (ChangedWater) evaluates the outputs.
  std::size_t seen = family;
  for (std::size_t g = 0; g < elements_.tiles().families.size(); ++g)
    if (family_at(g).repeated() == &f) seen = g;
  std::vector<double> lines(count * kTileLanes);
  bool all_known = true;
  const auto evaluate = [&](std::size_t, netloft_tile& t, TileSums&) {
    if (family_at(seen).output(t, lines.data()) == NETLOFT_OK) return NETLOFT_OK;
    std::fill(lines.begin(), lines.end(), std::numeric_limits<double>::quiet_NaN());
    all_known = false;
    return NETLOFT_OK;
  };
  elements_.visit(x, motion, seen, evaluate, [&](std::size_t tile, const netloft_tile& t, const TileSums&) {
    for (std::size_t k = 0; k < count; ++k)
      std::copy_n(&lines[k * kTileLanes], t.count, &values[k][tile * kTileLanes]);
  });
  return all_known;
}

std::vector<LawUse> ElementReports::find_law_use(std::span<const double> x, const Kinematics& motion) {
  std::vector<LawUse> uses;
  for (std::size_t f = 0; f < elements_.tiles().families.size(); ++f) {
    const ElementFamily& family = family_at(f);
    if (!family.reads(NETLOFT_READS_CURRENT)) continue;
    for (const auto& watch : family.law_watches()) watch->begin();
    for (std::size_t term = 0; term < family.active_terms().size(); ++term)
      if (family.active_terms()[term].traits & NETLOFT_READS_CURRENT)
        elements_.visit(x, motion, f, caller_of(family, term), ignore);
    for (const auto& watch : family.law_watches()) {
      uses.push_back(watch->end());
      uses.back().parts = family.parts();
    }
  }
  std::erase_if(uses, [](const LawUse& use) { return use.ranges.empty(); });
  return uses;
}

}  // namespace netloft
