// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/judging/verdict.hpp"
#include "tests/stability/suite/suite.hpp"

#include <array>
#include <optional>

namespace netloft::hard_cases {

/// The best answer known to a case at one size. Positions are of some nodes only, spread over all.
struct Reference {
  struct Node {
    std::uint32_t node;
    std::array<double, 3> x;  // [m]
  };
  std::size_t unknowns = 0;
  double energy = 0;  // [J]
  double size = 1;    // diagonal of the box round all nodes [m]
  double load = 0;    // largest nodal load [N]
  double noise = 0;   // what rounding of the positions is worth in energy [J]
  std::vector<Node> nodes;
  std::string found_by;  // "newton from the sketch"
  double residual = 0;   // largest nodal one [N]
};

/// The host's classification of the point at which a solver ended.
enum class Where {
  reference,  // at the best answer known
  lower,      // stable, of less energy than that
  near,       // there, but less closely than a unique answer is wanted
  another,    // stable or of unknown stability, elsewhere, at no more energy
  higher,     // stable, at more energy: a shape of the gear, but not the best
  wrong,      // says it has arrived, and is not where the only answer is
  unstable,   // at a stationary point that is not stable, and says so
  unproven,   // in balance, but whether it is stable could not be found out
  failed,     // says that it has not arrived
  honest,     // there is no equilibrium, and it says so
  late,       // the same, but only because its budget was spent
  lied,       // there is no equilibrium, and it says that it has arrived
  flutters,   // swings on about an equilibrium, says so, and no solver of this run knows one where it rests
  unsettled,  // let go, it goes on and on, says so, and no solver of this run knows where it rests
  not_run,    // the case could not be set up
  unfit,      // the solver is not made for such a problem: it wants an energy
};

struct Verdict {
  Where where = Where::failed;
  double distance = 0;  // from the reference, over its size; of the nodes that it knows
  double gap = 0;       // energy above the reference: kSameEnergy of it is the noise
};

/// The same energy; the same shape, and a unique answer found: this close in position, over size.
inline constexpr double kSameEnergy = 1e-9, kSameShape = 1e-5, kSamePlace = 1e-8;

/// Energies that differ by less are the same [J]: a part of their own amount, or of the work of the largest
/// load across the gear; where there is neither, what rounding of the positions is worth.
double energy_noise(const Reference& reference, const Solution& solution);

/// Data by which a solution is judged, independent of the claims of the solver.
struct Ended {
  Solution solution;
  std::vector<double> positions;  // of all nodes [m]
  std::size_t unknowns = 0;
  bool conservative = true;  // energies tell which of two places is the better one
  /// The suite's own finding: the host's where forces have an energy, else by the growth of a disturbance
  /// (framework/judging/growth.hpp), which is asked of every claim of success.
  Stability stability = Stability::unknown;
  bool out_of_budget = false;
  bool unfit = false;  // the solver needs what the problem does not have

  bool claims_success() const { return !unfit && solution.status == SolveStatus::converged; }
  /// At a stable equilibrium, whatever it says.
  bool is_at_rest() const {
    return claims_success() && (stability == Stability::stable || stability == Stability::neutral);
  }
};

/// `reference` may be missing: then nothing can be said but whether it is balanced.
Verdict judge(const HardCase& c, const std::optional<Reference>& reference, const Ended& ended);

/// The two columns of truth. Right: stationary, stable, and equal to or better than the best answer that any
/// solver of the run or the references know; or an honest failure where there is nothing to find. Claimed
/// wrong: success was claimed at another than the only answer, at an unstable one, or where there is none.
bool is_right(Where where);
bool is_claimed_wrong(Where where);

bool is_answer(Where where);  // right, at an equilibrium
bool is_honest(Where where);  // right, without one
const char* name_of(Where where);

/// At the same place as the reference, and in balance to more digits.
bool is_closer(const Ended& ended, const Reference& reference);

/// Reference out of a solution.
Reference make_reference(const Ended& ended, std::string found_by);

}  // namespace netloft::hard_cases
