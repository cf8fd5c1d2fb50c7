// SPDX-License-Identifier: BSD-3-Clause
//
// The nodal blocks of ∂r/∂a, by which explicit schemes divide. They are summed from the elements' tangents,
// without a sparse matrix.
#include "framework/assembler/workspace.hpp"

#include <algorithm>
#include <cmath>

namespace netloft {

namespace {

/// Entry (r, c) of a tangent in all lanes, packed or full.
const double* entry_of(const double* tangent, bool symmetric, std::size_t dofs, std::size_t r,
                       std::size_t c) {
  const std::size_t at = symmetric ? packed(std::max(r, c)) + std::min(r, c) : r * dofs + c;
  return tangent + at * kLanes;
}

double largest_lane(std::span<const double> lanes) {
  double largest = 0;
  for (const double m : lanes) largest = std::max(largest, std::abs(m));
  return largest;
}

/// What a row of an element on a body is multiplied by among the unknowns: rotations by the arm.
double turn_factor(const ElementFamily& f, std::size_t element, std::size_t row) {
  return row / 3 == 1 ? f.arm(element) : 1;
}

/// The body that has its origin at a node.
template <class Pairs>
std::size_t body_at(const Pairs& pairs, std::uint32_t origin) {
  const auto found = std::find_if(pairs.begin(), pairs.end(), [&](const auto& p) { return p[0] == origin; });
  return static_cast<std::size_t>(found - pairs.begin());
}

/// M ← Qᵀ M Q, row by row.
void turn(double* M, const std::array<double, 9>& Q) {
  double left[9] = {}, both[9] = {};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) left[3 * i + j] += Q[3 * k + i] * M[3 * k + j];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) both[3 * i + j] += left[3 * i + k] * Q[3 * k + j];
  std::copy_n(both, 9, M);
}

}  // namespace

bool Assembler::masses(std::span<const double> x, std::span<double> blocks, double& coupled) {
  std::fill(blocks.begin(), blocks.end(), 0.0);
  coupled = 0;
  for (std::size_t f = 0; f < families_.size(); ++f)
    if (families_[f]->reads(NETLOFT_READS_ACCELERATION) && !add_masses(x, f, blocks, coupled)) return false;
  if (!bodies_.empty())
    bodies_.hand_on_masses(x, blocks.first(3 * numbering_.dofs()), blocks.subspan(3 * numbering_.dofs()));
  for (const auto& [node, Q] : axes_) turn(&blocks[9 * std::size_t{node}], Q);
  return true;
}

bool Assembler::add_masses(std::span<const double> x, std::size_t family, std::span<double> blocks,
                           double& coupled) {
  const auto between = blocks.subspan(3 * numbering_.dofs());
  const ElementFamily& f = *families_[family];
  const auto dofs = static_cast<std::size_t>(f.type().dofs());
  const bool on_body = f.type().is_on_body();
  for (const auto& term : f.active_terms()) {
    if (!(term.traits & NETLOFT_READS_ACCELERATION)) continue;
    const bool symmetric = term.traits & NETLOFT_SYMMETRIC;
    const auto evaluate = [&](std::size_t, netloft_tile& t) {
      t.force = nullptr;
      t.tangent = workspaces_[0]->scratch.data();
      std::fill_n(t.tangent, (symmetric ? packed(dofs) : dofs * dofs) * kLanes, 0.0);
      t.want = NETLOFT_WANT_TANGENT;
      return f.evaluate(term, t);
    };
    const auto add = [&](std::size_t, const netloft_tile& t, const Workspace& w) {
      for (std::size_t r = 0; r < dofs; ++r)
        for (std::size_t c = 0; c < dofs; ++c) {
          const double* lanes = entry_of(w.scratch.data(), symmetric, dofs, r, c);
          if (!on_body && r / 3 != c / 3) {
            coupled = std::max(coupled, largest_lane({lanes, t.count}));
            continue;
          }
          for (std::size_t lane = 0; lane < t.count; ++lane) {
            const std::size_t e = t.first + lane;
            const double m = lanes[lane] / (on_body ? turn_factor(f, e, r) * turn_factor(f, e, c) : 1);
            if (r / 3 == c / 3)
              blocks[9 * std::size_t{f.node(e, static_cast<int>(r / 3))} + 3 * (r % 3) + c % 3] += m;
            else if (r < 3 && c / 3 == 1)
              between[9 * body_at(bodies_.pairs(), f.node(e, 0)) + 3 * r + c % 3] += m;
            else if (r / 3 != 1 || c >= 3)
              coupled = std::max(coupled, std::abs(m));
          }
        }
    };
    if (!visit_tiles(x, {.cu = 0, .cv = 0, .ca = 1}, family, evaluate, add)) return false;
  }
  return true;
}

}  // namespace netloft
