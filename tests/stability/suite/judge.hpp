// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/verdict.hpp"
#include "tests/stability/suite/suite.hpp"

#include <array>
#include <optional>

namespace netloft::hard_cases {

/// The best known equilibrium of a case at one size. Positions are those of some nodes, spread over the gear.
struct Reference {
  struct Node {
    std::uint32_t node;
    std::array<double, 3> x;  // [m]
  };
  std::size_t unknowns = 0;
  double energy = 0;  // [J]
  double size = 1;    // diagonal of the box round all nodes [m]
  double load = 0;    // largest nodal load [N]
  double noise = 0;   // energy that rounding of the positions can change [J]
  std::vector<Node> nodes;
  std::string found_by;  // "newton from the sketch"
  double residual = 0;   // largest residual force on a node [N]
};

/// The suite's classification of the point at which a solver ended.
enum class Where {
  reference,  // at the best known equilibrium
  lower,      // stable, with less energy than the best known equilibrium
  near,       // at the reference, but less closely than a unique answer requires
  another,    // stable, at another place, with the energy of the reference or without one to compare
  higher,     // stable, with more energy: an equilibrium of the gear, but not the best
  wrong,      // claims success, but is unstable or not at the only equilibrium
  unstable,   // at a stationary point that is not stable, and reports it
  unproven,   // claims success, but it is not known whether the point is stable
  failed,     // the solver reports that it has not converged
  honest,     // there is no equilibrium, and the solver reports a failure
  late,       // there is no equilibrium, and the solver fails only because its budget is used up
  lied,       // there is no equilibrium, and the solver claims success
  flutters,   // the gear swings about an equilibrium, as reported, and no solver of this run found it at rest
  unsettled,  // the gear never comes to rest, as reported, and no solver of this run found it at rest
  not_run,    // the case could not be set up
  unfit,      // the solver is not made for such a problem, or is not run at this size
};

struct Verdict {
  Where where = Where::failed;
  double distance = 0;  // largest distance of nodes from their places in the reference, over its size
  double gap = 0;       // energy above the reference, scaled so that kSameEnergy is the noise
};

/// Limits for equal energies (relative difference), and for equal shapes and a unique answer (distance over
/// the size of the gear).
inline constexpr double kSameEnergy = 1e-9, kSameShape = 1e-5, kSamePlace = 1e-8;

/// The difference below which energies count as equal [J]: kSameEnergy times the energy, or times the work of
/// the largest load across the gear, but at least the change of energy by rounding of the positions.
double energy_noise(const Reference& reference, const Solution& solution);

/// Data by which a solution is judged, independently of the claims of the solver.
struct Ended {
  Solution solution;
  std::vector<double> positions;  // of all nodes [m]
  std::size_t unknowns = 0;
  bool conservative = true;  // the energy decides which of two equilibria is better
  /// Stability found by the suite: from the energy if forces have a potential, otherwise from the growth of a
  /// disturbance (framework/judging/growth.hpp), which is computed for every claim of success.
  Stability stability = Stability::unknown;
  bool out_of_budget = false;
  bool unfit = false;  // the solver is not made for this problem

  bool claims_success() const { return !unfit && solution.status == SolveStatus::converged; }
  /// Whether the point is a stable equilibrium, as found by the suite itself.
  bool is_at_rest() const {
    return claims_success() && (stability == Stability::stable || stability == Stability::neutral);
  }
};

/// Classifies a result. Without a `reference`, its place and energy are not judged.
Verdict judge(const HardCase& c, const std::optional<Reference>& reference, const Ended& ended);

/// The two counts of the matrix. Right: stationary, stable, and equal to or better than the best equilibrium
/// that the references or any solver of the run have; or a reported failure if there is no equilibrium.
/// Claimed wrong: success was claimed away from the only equilibrium, at an unstable one, or if there is
/// none.
bool is_right(Where where);
bool is_claimed_wrong(Where where);

bool is_answer(Where where);  // right, at an equilibrium
bool is_honest(Where where);  // right, without an equilibrium
const char* name_of(Where where);

/// Whether a result is at the same place as the reference, with a smaller residual.
bool is_closer(const Ended& ended, const Reference& reference);

/// Makes a reference of a solution.
Reference make_reference(const Ended& ended, std::string found_by);

}  // namespace netloft::hard_cases
