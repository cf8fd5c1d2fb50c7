// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/plugin.h>

#include "framework/balance/statistics.hpp"
#include "framework/motion/time_march.hpp"
#include "io/results/figures/named_scalar.hpp"
#include "io/scenes/reading/loaded_scene.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace netloft::results {

/// Sum of one force over all parts of one name, in the direction in which it acts on the gear [N].
struct PartLoad {
  std::string part, term;
  std::array<double, 3> force{};
};

/// Sum of the forces with which one hold acts on the gear [N].
struct HoldForce {
  std::string name;
  std::array<double, 3> force{};
};

/// A row of the bill of materials with its load; NaN marks numbers that do not apply or are not known.
struct Material {
  static constexpr double kUnknown = NamedScalar::kUnknown;
  scenes::BillItem item = {"", "", "", kUnknown, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown};
  double length = kUnknown;  // in the whole gear: of ropes, unstretched; of twines [m]
  double area = kUnknown;    // length times diameter of the twines; of bodies projected [m2]
  double mass = kUnknown;    // in air [kg]
  double load = kUnknown;    // largest tension in the newest state: of a rope, of a twine [N]

  /// The load as a fraction of the breaking load; NaN unless both are known.
  double utilisation() const { return load / item.breaking_load; }
};

/// The origins of a result.
struct Origins {
  std::string version, machine, compiler, started, finished;
  std::vector<std::string> command;  // word by word
  struct File {
    std::string path, hash, text;
  };
  std::vector<File> files;  // the first is the scene
  struct Plugin {
    std::string name, version, path, hash;
  };
  std::vector<Plugin> plugins;
  std::string plan;  // forces that are evaluated, and why the others are off
};

/// The names of a scene with a net plan.
struct GearNames {
  int times = 1;                   // 2: one half was modelled
  std::string headline, footrope;  // ropes
};

/// Other equilibria that a search found.
struct FoundShapes {
  struct Other {
    double energy = 0, distance = 0;  // [J], of its furthest node from where the solution has it [m]
    std::string furthest;             // that node
    int times = 1;                    // that it was found
  };
  int restarts = 0, times = 1;  // that the solution was found
  int by_energy = 0;            // 1: the solution is the one of least energy; 0: the first that was found
  std::vector<Other> others;
};

/// The motion that grows about an equilibrium that is swinging or unstable.
struct Swing {
  std::string furthest;            // the node that it moves furthest
  double rate = 0, frequency = 0;  // of growth [1/s], with which it swings [rad/s]; 0: not known, does not
};

/// One solve on the way to the equilibrium: of the scene itself, or of an easier variant.
struct Stage {
  std::string name, solver, outcome, sentence;
  netloft_variant variant{};
  std::int64_t unknowns = 0;
  Statistics statistics;
  double work = 0;
};

/// An accepted point of the solve.
struct Iteration {
  std::int64_t iteration = 0, factorisations = 0;
  double residual = 0, load = 0, energy = 0, seconds = 0;  // [N], [N], [J], [s]
  std::string note;
};

/// Energy that the time scheme took by energy_judge.hpp, over the outputs of a run: no force has taken it
/// and none has kept it.
struct NumericalLoss {
  double lost = 0, given = 0;             // in all [J]
  double worst = 0, from = 0, until = 0;  // most between two outputs [J], their times [s]
  std::string node;                       // whose velocity changed most between them
  /// The scheme decides about more than a twentieth: no accuracy resolves the path that follows.
  bool is_large() const { return std::abs(lost) > 0.05 * given; }
  bool is_created() const { return lost < 0; }
};

/// Facts that only motions have.
struct Motion {
  std::string integrator, start_from;  // "the equilibrium", "the sketch", or a file
  double time = 0, resumed_from = 0;   // reached, and where the run went on [s]
  std::int64_t steps = 0, rejected = 0;
  double shortest = 0, longest = 0;  // steps that were made [s]
  double stable_step = 0;            // longest stable one with all members taut [s]; 0: any is
  std::optional<StartBalance> start;
  std::optional<AchievedAccuracy> accuracy;  // none: steps were given
  std::optional<NumericalLoss> loss;         // none: no energy budget was kept
  std::map<std::string, double> energies;    // at the last output [J]
};

/// All that reports, pages and comparisons of a run are made from. It
/// is made by make_result() or run_motion() and lies in a file (io/formats/hdf5/LAYOUT.md), from which
/// read_result() makes it again. Positions and fields are in the file alone (StoredShape).
struct Result {
  std::string title, path;                             // the scene; the file, empty: none yet
  std::string outcome, sentence, stability, at_fault;  // outcome is empty: the run has not ended
  std::vector<std::string> diagnostics, warnings;
  std::vector<std::string> notes;  // facts that its file is too old to have
  Origins origins;
  std::string solver, strategy, factorisation;
  std::size_t nodes = 0, elements = 0, states = 1;
  std::optional<GearNames> gear;     // of a scene with a net plan
  std::vector<NamedScalar> scalars;  // of [results]
  std::vector<NamedScalar> figures;  // gear_figures.hpp
  std::string mesh_note;  // the meshes behind the mesh errors, or why there are none; empty: not asked for
  double node_error = NamedScalar::kUnknown;  // largest nodal move of the next Newton step [m]
  std::vector<PartLoad> part_forces;          // by term, then by part
  std::vector<HoldForce> hold_forces;
  std::array<double, 3> balance{};  // sum of all forces on the gear, those of the holds included [N]
  double residual = NamedScalar::kUnknown, largest_load = NamedScalar::kUnknown;  // of a node [N]
  double energy = NamedScalar::kUnknown;  // of the forces that have one [J]
  std::optional<FoundShapes> shapes;      // none: nobody looked for others
  std::optional<Swing> swing;             // none: nothing grows
  std::vector<Material> materials;
  std::int64_t unknowns = 0;
  double work = 0;  // in the units of work.hpp
  double reading_seconds = 0, setup_seconds = 0;
  Statistics statistics;
  std::vector<Stage> stages;          // if there were several
  std::vector<Iteration> iterations;  // accepted points
  std::optional<Motion> motion;       // none: an equilibrium

  bool is_half() const { return gear && gear->times == 2; }
  bool is_answer() const { return outcome == "converged" || outcome == "finished"; }
};

}  // namespace netloft::results
