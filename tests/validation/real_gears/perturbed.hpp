// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/validation/real_gears/solving.hpp"

namespace netloft::real_gears {

/// Drawings of one gear, each moved a little: what a user has who does not draw to the millimetre.
struct PerturbedDrawings {
  int count = 30;
  double least = 1e-3, largest = 0.3;  // standard deviation of a free coordinate [m]
  std::uint64_t seed = 1;
};

/// The plain drawing, then the perturbed ones, whose amplitudes grow by equal ratios.
std::vector<Start> starts_of(const PerturbedDrawings& drawings);

/// One solve: what counts of it.
struct Effort {
  bool converged = false;
  int factorisations = 0;
};

/// How sure and how dear a way of solving is. Median and 95 % are of all runs, whether they converged or not.
struct Reliability {
  std::size_t runs = 0, converged = 0;
  int median = 0, most_of_them = 0;  // factorisations; of the latter in 95 % no more
};
Reliability summarise(std::vector<Effort> efforts);

Reliability solve_perturbed(const NeutralCase& gear, const Modelling& modelling,
                            const PerturbedDrawings& drawings, const test::Solving& how);

}  // namespace netloft::real_gears
