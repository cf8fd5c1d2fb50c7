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

/// Sum of one force over all parts with one name, in the direction in which it acts on the gear [N].
struct PartLoad {
  std::string part, term;
  std::array<double, 3> force{};
};

/// Sum of the forces of one hold on the gear [N].
struct HoldForce {
  std::string name;
  std::array<double, 3> force{};
};

/// A row of the bill of materials with its load. NaN marks numbers that do not apply or are unknown.
struct Material {
  static constexpr double kUnknown = NamedScalar::kUnknown;
  scenes::BillItem item = {"", "", "", kUnknown, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown};
  double length = kUnknown;  // total unstretched length in the whole gear, of ropes or twines [m]
  double area = kUnknown;    // length times diameter of twines; projected area of bodies [m2]
  double mass = kUnknown;    // in air [kg]
  double load = kUnknown;    // largest tension in a rope or twine, in the newest state [N]

  /// The load as a fraction of the breaking load; NaN unless both are known.
  double utilisation() const { return load / item.breaking_load; }
};

/// The origins of a result.
struct Origins {
  std::string version, machine, compiler, started, finished;
  std::vector<std::string> command;  // one entry per word
  struct File {
    std::string path, hash, text;
  };
  std::vector<File> files;  // the first is the scene
  struct Plugin {
    std::string name, version, path, hash;
  };
  std::vector<Plugin> plugins;
  std::string plan;  // the forces that are evaluated, and why the others are off
};

/// The names of a scene with a net plan.
struct GearNames {
  int times = 1;                   // 2: one half was modelled
  std::string headline, footrope;  // ropes
};

/// Other equilibria that a search found.
struct FoundShapes {
  struct Other {
    double energy = 0, distance = 0;  // distance: of the node furthest from its position in the solution [m]
    std::string furthest;             // name of that node
    int times = 1;                    // how often it was found
  };
  int restarts = 0, times = 1;  // times: how often the solution was found
  int by_energy = 0;            // 1: the solution has the least energy; 0: it was found first
  std::vector<Other> others;
};

/// The motion that grows about an equilibrium with oscillating or steady instability.
struct Swing {
  std::string furthest;  // the node with the largest displacement
  // Growth rate [1/s], 0: not known; angular frequency [rad/s], 0: no oscillation
  double rate = 0, frequency = 0;
};

/// One solve of the search, of the scene itself or of an easier variant.
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

/// Energy that the time scheme removed or added during a run, as energy_judge.hpp finds it. No force accounts
/// for this energy.
struct NumericalLoss {
  double lost = 0, given = 0;             // total over the run [J]
  double worst = 0, from = 0, until = 0;  // largest loss between two outputs [J], and their times [s]
  std::string node;                       // node whose velocity changed most between these outputs
  /// Whether the loss exceeds a twentieth of the energy given: no accuracy setting then resolves the later
  /// path.
  bool is_large() const { return std::abs(lost) > 0.05 * given; }
  bool is_created() const { return lost < 0; }
};

/// Facts that only motions have.
struct Motion {
  std::string integrator, start_from;  // "the equilibrium", "the sketch", or a file
  double time = 0, resumed_from = 0;   // time reached; time at which the run was resumed [s]
  std::int64_t steps = 0, rejected = 0;
  double shortest = 0, longest = 0;  // shortest and longest step made [s]
  double stable_step = 0;            // longest stable step with all members taut [s]; 0: any step is stable
  std::optional<StartBalance> start;
  std::optional<AchievedAccuracy> accuracy;  // empty: the steps were prescribed
  std::optional<NumericalLoss> loss;         // empty: there is no energy budget
  std::map<std::string, double> energies;    // at the last output [J]
};

/// The data for all reports, pages and comparisons of a run. make_result() or run_motion() makes it, and a
/// file holds it (io/formats/hdf5/LAYOUT.md), from which read_result() restores it. Positions and fields are
/// in the file only (StoredShape).
struct Result {
  std::string title, path;                             // path of the scene; path of the file, empty: none yet
  std::string outcome, sentence, stability, at_fault;  // an empty outcome: the run has not ended
  std::vector<std::string> diagnostics, warnings;
  std::vector<std::string> notes;  // which facts are missing because the file has an older format
  Origins origins;
  std::string solver, strategy, factorisation;
  std::size_t nodes = 0, elements = 0, states = 1;
  std::optional<GearNames> gear;     // only for a scene with a net plan
  std::vector<NamedScalar> scalars;  // the numbers of [results]
  std::vector<NamedScalar> figures;  // gear_figures.hpp
  // the meshes behind the mesh errors, or why there are no mesh errors; empty: not requested
  std::string mesh_note;
  double node_error = NamedScalar::kUnknown;  // largest displacement of a node by the next Newton step [m]
  std::vector<PartLoad> part_forces;          // by term, then by part
  std::vector<HoldForce> hold_forces;
  std::array<double, 3> balance{};  // sum of all forces on the gear, holds included [N]
  // Residual, largest load: at one node [N]
  double residual = NamedScalar::kUnknown, largest_load = NamedScalar::kUnknown;
  double energy = NamedScalar::kUnknown;  // sum over the forces that have an energy [J]
  std::optional<FoundShapes> shapes;      // empty: there was no search for other equilibria
  std::optional<Swing> swing;             // empty: no motion grows
  std::vector<Material> materials;
  std::int64_t unknowns = 0;
  double work = 0;  // in the units of work.hpp
  double reading_seconds = 0, setup_seconds = 0;
  Statistics statistics;
  std::vector<Stage> stages;          // empty: there was only one
  std::vector<Iteration> iterations;  // accepted points
  std::optional<Motion> motion;       // empty: the result is an equilibrium

  bool is_half() const { return gear && gear->times == 2; }
  bool is_answer() const { return outcome == "converged" || outcome == "finished"; }
};

}  // namespace netloft::results
