// SPDX-License-Identifier: BSD-3-Clause
//
// Evaluations of an assembler that are rarely needed, and serial: one term alone, sums per part, outputs,
// memory.
#include "framework/assembler/workspace.hpp"

#include <algorithm>
#include <cassert>

namespace netloft {

bool Assembler::evaluate_term(std::span<const double> x, std::size_t family, std::size_t term,
                              std::span<double> residual, const Kinematics& motion) {
  std::fill(residual.begin(), residual.end(), 0.0);
  const ElementFamily& f = *families_[family];
  const bool done = visit_tiles(
      x, motion, family, [&](std::size_t, netloft_tile& t) { return f.evaluate(f.active_terms()[term], t); },
      [&](std::size_t tile, const netloft_tile&, Workspace& w) {
        scatter(group_of(family), tile, {.residual = residual.data()}, w);
      });
  bodies_.hand_on(x, {}, residual.data(), {}, false);
  frames_.turn(residual.data());
  return done;
}

bool Assembler::term_energy(std::span<const double> x, std::size_t family, std::size_t term, double& energy,
                            const Kinematics& motion) {
  energy = 0;
  const ElementFamily& f = *families_[family];
  const netloft_term& wanted = f.active_terms()[term];
  if (!(wanted.traits & NETLOFT_CONSERVATIVE)) return true;
  const auto evaluate = [&](std::size_t, netloft_tile& t) {
    std::fill_n(workspaces_[0]->energy, kLanes, 0.0);
    t.energy = workspaces_[0]->energy;
    t.force = nullptr;
    t.want = NETLOFT_WANT_ENERGY;
    return f.evaluate(wanted, t);
  };
  return visit_tiles(x, motion, family, evaluate,
                     [&](std::size_t, const netloft_tile& t, const Workspace& w) {
                       for (std::size_t lane = 0; lane < t.count; ++lane) energy += w.energy[lane];
                     });
}

bool Assembler::sum_term(std::span<const double> x, std::size_t family, std::size_t term,
                         std::span<double> sums, const Kinematics& motion) {
  std::fill(sums.begin(), sums.end(), 0.0);
  const ElementFamily& f = *families_[family];
  const auto rows = 3 * static_cast<std::size_t>(f.nodes_per_element());  // moments are no forces
  std::size_t part = 0;
  return visit_tiles(
      x, motion, family, [&](std::size_t, netloft_tile& t) { return f.evaluate(f.active_terms()[term], t); },
      [&](std::size_t, const netloft_tile& t, const Workspace& w) {
        for (std::size_t lane = 0; lane < t.count; ++lane) {
          while (t.first + lane >= f.part_begin()[part + 1]) ++part;
          for (std::size_t d = 0; d < rows; ++d) sums[3 * part + d % 3] += w.force.data()[d * kLanes + lane];
        }
      });
}

bool Assembler::sum_term_at(std::span<const double> x, std::size_t family, std::size_t term,
                            std::span<const std::int32_t> groups, std::size_t group_count,
                            std::span<double> sums, const Kinematics& motion) {
  std::fill(sums.begin(), sums.end(), 0.0);
  const ElementFamily& f = *families_[family];
  const auto evaluate = [&](std::size_t, netloft_tile& t) { return f.evaluate(f.active_terms()[term], t); };
  std::size_t part = 0;
  return visit_tiles(
      x, motion, family, evaluate, [&](std::size_t, const netloft_tile& t, const Workspace& w) {
        for (std::size_t lane = 0; lane < t.count; ++lane) {
          while (t.first + lane >= f.part_begin()[part + 1]) ++part;
          for (int n = 0; n < f.nodes_per_element(); ++n) {
            const std::uint32_t node = f.node(t.first + lane, n);
            if (node >= groups.size() || groups[node] < 0) continue;
            double* sum = &sums[3 * (part * group_count + static_cast<std::size_t>(groups[node]))];
            for (std::size_t axis = 0; axis < 3; ++axis)
              sum[axis] += w.force.data()[(3 * static_cast<std::size_t>(n) + axis) * kLanes + lane];
          }
        }
      });
}

bool Assembler::outputs(std::span<const double> x, std::size_t family,
                        std::vector<std::vector<double>>& values, const Kinematics& motion) {
  const ElementFamily& f = *families_[family];
  const std::size_t count = f.type().outputs.size();
  values.assign(count, std::vector<double>(f.size()));
  if (!count) return true;
  std::vector<double> lines(count * kLanes);
  bool all_known = true;
  const auto evaluate = [&](std::size_t, netloft_tile& t) {
    if (f.output(t, lines.data()) == NETLOFT_OK) return NETLOFT_OK;
    std::fill(lines.begin(), lines.end(), std::numeric_limits<double>::quiet_NaN());
    all_known = false;
    return NETLOFT_OK;
  };
  visit_tiles(x, motion, family, evaluate, [&](std::size_t tile, const netloft_tile& t, const Workspace&) {
    for (std::size_t k = 0; k < count; ++k)
      std::copy_n(&lines[k * kLanes], t.count, &values[k][tile * kLanes]);
  });
  return all_known;
}

std::vector<LawUse> Assembler::find_law_use(std::span<const double> x, const Kinematics& motion) {
  std::vector<LawUse> uses;
  for (std::size_t f = 0; f < families_.size(); ++f) {
    const ElementFamily& family = *families_[f];
    for (const auto& watch : family.law_watches()) watch->begin();
    for (const auto& term : family.active_terms())
      if (term.traits & NETLOFT_READS_CURRENT)
        visit_tiles(
            x, motion, f, [&](std::size_t, netloft_tile& t) { return family.evaluate(term, t); },
            [](std::size_t, const netloft_tile&, const Workspace&) {});
    for (const auto& watch : family.law_watches()) {
      uses.push_back(watch->end());
      uses.back().parts = family.parts();
    }
  }
  std::erase_if(uses, [](const LawUse& use) { return use.ranges.empty(); });
  return uses;
}

bool Assembler::remember(std::span<const double> x, const Kinematics& motion) {
  for (std::size_t f = 0; f < families_.size(); ++f)
    if (!memories_[f].empty() && !remember_family(f, x, motion)) return false;
  for (auto& memory : memories_) memory.accept();
  return true;
}

bool Assembler::remember_family(std::size_t family, std::span<const double> x, const Kinematics& motion) {
  const ElementFamily& f = *families_[family];
  memories_[family].begin();
  const auto evaluate = [&](std::size_t tile, netloft_tile& t) {
    t.state_new = memories_[family].next(tile);
    for (const auto& term : f.active_terms())
      if (term.traits & NETLOFT_READS_STATE)
        if (const int status = f.evaluate(term, t); status != NETLOFT_OK) return status;
    return int{NETLOFT_OK};
  };
  return visit_tiles(x, motion, family, evaluate, [](std::size_t, const netloft_tile&, const Workspace&) {});
}

std::vector<double> Assembler::memory() const {
  std::vector<double> all;
  for (const auto* memories : {&memories_, &stretch_rates_})
    for (const auto& memory : *memories) all.insert(all.end(), memory.all().begin(), memory.all().end());
  return all;
}

void Assembler::set_memory(std::span<const double> kept) {
  for (auto* memories : {&memories_, &stretch_rates_})
    for (auto& memory : *memories) {
      assert(kept.size() >= memory.all().size());
      std::copy_n(kept.begin(), memory.all().size(), memory.all().begin());
      kept = kept.subspan(memory.all().size());
    }
  assert(kept.empty() && "it is the memory of a scene with as many elements");
}

}  // namespace netloft
