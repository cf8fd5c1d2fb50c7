// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/verdict.hpp"

#include <functional>
#include <span>
#include <vector>

namespace netloft {

/// Scales the data of the scene's settings (such as the length of a rope) to these factors, relative to the
/// data as read.
void set_factors(Scene& scene, std::span<const double> factors);

/// Sum of the data of a setting over the elements of the part; for a rope, its length.
double amount_of(const Scene& scene, const Setting& setting);

/// An equilibrium for given factors of the settings, and the reactions at the nodes of the settings [N].
struct SetEquilibrium {
  Solution solution;
  std::vector<double> reactions;  // reaction of each setting; empty: no equilibrium was found
};

/// Finds the equilibrium for given factors. The solver starts from the displacements `start` or, if `start`
/// is empty, from the initial shape of the scene.
using FindWithFactors =
    std::function<SetEquilibrium(std::span<const double> factors, const std::vector<double>& start)>;

/// Finds the factors of the settings of a scene such that the node of each setting has the required reaction:
///   g_k(y) = R_k/T_k − 1 = 0,   y_k = ln of factor k                                             (1)
/// R_k [N] is the magnitude of the reaction at the equilibrium, T_k [N] the required reaction. The slopes J
/// of g over y are measured with one more equilibrium per setting. Newton steps follow, whose slopes are
/// updated in every step (C. G. Broyden, Mathematics of Computation 19, 1965; the secant method if there is
/// one setting):
///   J s = −g,   y' = y + t s,   t ≤ 1 so that no |t s_k| exceeds kLargestChange                  (2)
///   J' = J + (g' − g − t J s) sᵀ/(t sᵀs)                                                         (3)
/// A step is halved if it finds no equilibrium or does not reduce the largest |g_k|; if that does not help,
/// the slopes are measured again. Every equilibrium starts from the previous one. If no equilibrium satisfies
/// (1), the solution is the equilibrium nearest to (1), marked as not converged, with a sentence about the
/// difference. The solution has the stages and statistics of all equilibria together.
Solution find_settings(const Scene& scene, const FindWithFactors& find, const std::vector<double>& start);

}  // namespace netloft
