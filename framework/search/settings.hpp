// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/verdict.hpp"

#include <functional>
#include <span>
#include <vector>

namespace netloft {

/// Multiplies data of the scene so that its settings have these factors.
void set_factors(Scene& scene, std::span<const double> factors);

/// Sum of the data of a setting over the elements of its part: the length of a rope.
double amount_of(const Scene& scene, const Setting& setting);

/// An equilibrium of a scene with given factors, and what the nodes of its settings bear there [N].
struct SetEquilibrium {
  Solution solution;
  std::vector<double> reactions;  // one per setting; empty: there is no equilibrium
};

/// Finds the equilibrium for these factors, near displacements `start`; where these are empty, from the start
/// of the scene.
using FindWithFactors =
    std::function<SetEquilibrium(std::span<const double> factors, const std::vector<double>& start)>;

/// Finds the factors of the settings of a scene, so that each of their nodes bears what is wanted:
///   g_k(y) = R_k/T_k − 1 = 0,   y_k = ln of factor k                                             (1)
/// R_k [N] size of the reaction at the equilibrium, T_k [N] what is wanted. The slopes J of g over y are
/// measured by one more equilibrium for each setting; steps are then Newton's with these slopes, which learn
/// from every step (C. G. Broyden, Mathematics of Computation 19, 1965; of one setting this is the secant
/// method):
///   J s = −g,   y' = y + t s,   t ≤ 1 so that no |t s_k| exceeds kLargestChange                  (2)
///   J' = J + (g' − g − t J s) sᵀ/(t sᵀs)                                                         (3)
/// A step to where there is no equilibrium, or that brings the largest |g_k| no nearer to zero, is halved;
/// where that does not help, the slopes are measured once more there. Every equilibrium is looked for from
/// the one before. Where none bears what is wanted, the solution is the one that came nearest, not converged,
/// with a sentence that says how near. Its stages and statistics are those of all.
Solution find_settings(const Scene& scene, const FindWithFactors& find, const std::vector<double>& start);

}  // namespace netloft
