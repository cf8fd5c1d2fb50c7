// SPDX-License-Identifier: BSD-3-Clause
//
// What is asked of an assembler once in a while: one term alone, sums per part, outputs, memory. Serial.
#include "framework/assembler/workspace.hpp"

#include <algorithm>

namespace netloft {

/// Lets `evaluate` fill each tile of a family and hands it to `visit`. False: see fault().
template <class Evaluate, class Visit>
bool Assembler::visit_tiles(std::span<const double> x, std::size_t family, const Evaluate& evaluate,
                            const Visit& visit) {
  const Tiling& tiling = tilings_[family];
  const auto dofs = static_cast<std::size_t>(families_[family]->type().dofs());
  Workspace& w = *workspaces_[0];
  for (std::size_t tile = 0; tile < tiling.tiles; ++tile) {
    netloft_tile t = make_tile(tiling, tile, x, w);
    std::fill_n(w.force.begin(), dofs * kLanes, 0.0);
    t.force = w.force.data(), t.want = NETLOFT_WANT_FORCE;
    if (const int status = evaluate(tile, t); status != NETLOFT_OK) {
      report(family, t, status, w);
      return collect_faults();
    }
    visit(tile, t, w);
  }
  return true;
}

bool Assembler::evaluate_term(std::span<const double> x, std::size_t family, std::size_t term,
                              std::span<double> residual) {
  std::fill(residual.begin(), residual.end(), 0.0);
  const ElementFamily& f = *families_[family];
  const bool done = visit_tiles(
      x, family, [&](std::size_t, netloft_tile& t) { return f.active_terms()[term].evaluate(f.self(), &t); },
      [&](std::size_t tile, const netloft_tile&, Workspace& w) {
        scatter(family, tile, {.residual = residual.data()}, w);
      });
  bodies_.hand_on(x, residual.data(), nullptr, false);
  frames_.turn(residual.data());
  return done;
}

bool Assembler::sum_term(std::span<const double> x, std::size_t family, std::size_t term,
                         std::span<double> sums) {
  std::fill(sums.begin(), sums.end(), 0.0);
  const ElementFamily& f = *families_[family];
  const auto dofs = static_cast<std::size_t>(f.type().dofs());
  std::size_t part = 0;
  return visit_tiles(
      x, family, [&](std::size_t, netloft_tile& t) { return f.active_terms()[term].evaluate(f.self(), &t); },
      [&](std::size_t, const netloft_tile& t, const Workspace& w) {
        for (std::size_t lane = 0; lane < t.count; ++lane) {
          while (t.first + lane >= f.part_begin()[part + 1]) ++part;
          for (std::size_t d = 0; d < dofs; ++d) sums[3 * part + d % 3] += w.force[d * kLanes + lane];
        }
      });
}

bool Assembler::outputs(std::span<const double> x, std::size_t family,
                        std::vector<std::vector<double>>& values) {
  const ElementFamily& f = *families_[family];
  const std::size_t count = f.type().outputs.size();
  values.assign(count, std::vector<double>(f.size()));
  if (!count) return true;
  std::vector<double> lines(count * kLanes);
  bool all_known = true;
  const auto evaluate = [&](std::size_t, netloft_tile& t) {
    if (f.type().element.output(f.self(), &t, lines.data()) == NETLOFT_OK) return NETLOFT_OK;
    std::fill(lines.begin(), lines.end(), std::numeric_limits<double>::quiet_NaN());
    all_known = false;
    return NETLOFT_OK;
  };
  visit_tiles(x, family, evaluate, [&](std::size_t tile, const netloft_tile& t, const Workspace&) {
    for (std::size_t k = 0; k < count; ++k)
      std::copy_n(&lines[k * kLanes], t.count, &values[k][tile * kLanes]);
  });
  return all_known;
}

bool Assembler::remember(std::span<const double> x) {
  for (std::size_t f = 0; f < families_.size(); ++f)
    if (!memories_[f].empty() && !remember_family(f, x)) return false;
  for (auto& memory : memories_) memory.accept();
  return true;
}

bool Assembler::remember_family(std::size_t family, std::span<const double> x) {
  const ElementFamily& f = *families_[family];
  memories_[family].begin();
  const auto evaluate = [&](std::size_t tile, netloft_tile& t) {
    t.state_new = memories_[family].next(tile);
    for (const auto& term : f.active_terms())
      if (term.traits & NETLOFT_READS_STATE)
        if (const int status = term.evaluate(f.self(), &t); status != NETLOFT_OK) return status;
    return int{NETLOFT_OK};
  };
  return visit_tiles(x, family, evaluate, [](std::size_t, const netloft_tile&, const Workspace&) {});
}

}  // namespace netloft
