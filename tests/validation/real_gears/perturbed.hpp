// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/validation/real_gears/solving.hpp"

namespace netloft::real_gears {

/// Slightly perturbed drawings of one gear, as if users had drawn it inexactly.
struct PerturbedDrawings {
  int count = 30;
  double least = 1e-3, largest = 0.3;  // standard deviation of a free coordinate [m]
  std::uint64_t seed = 1;
};

/// The unperturbed drawing, then the perturbed ones, whose amplitudes grow by equal ratios.
std::vector<Start> starts_of(const PerturbedDrawings& drawings);

/// The work and the result of one solve.
struct Effort {
  bool converged = false;
  int factorisations = 0;
};

/// How often a way of solving converges, and at what cost. Median and 95 % include runs that did not
/// converge.
struct Reliability {
  std::size_t runs = 0, converged = 0;
  int median = 0, most_of_them = 0;  // median of factorisations, and the number that 95 % of runs do not
                                     // exceed
};
Reliability summarise(std::vector<Effort> efforts);

Reliability solve_perturbed(const NeutralCase& gear, const Modelling& modelling,
                            const PerturbedDrawings& drawings, const test::Solving& how);

}  // namespace netloft::real_gears
