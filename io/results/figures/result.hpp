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

/// Sum of one term (kind of force) over all parts with one name, as a force on the gear [N].
struct PartLoad {
  std::string part, term;
  std::array<double, 3> force{};
};

/// Sum of the forces of one hold on the gear [N].
struct HoldForce {
  std::string name;
  std::array<double, 3> force{};
};

/// A row of the bill of materials with its load. NaN marks numbers that are unknown or do not apply.
struct Material {
  static constexpr double kUnknown = NamedScalar::kUnknown;
  scenes::BillItem item = {"", "", "", kUnknown, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown};
  double length = kUnknown;  // unstretched length of all its ropes or twines in the whole gear [m]
  double area = kUnknown;    // twines: length times diameter; bodies: projected area [m2]
  double mass = kUnknown;    // mass in air [kg]
  double load = kUnknown;    // largest tension in a rope or twine, in the last state [N]

  /// The load as a fraction of the breaking load; NaN unless both are known.
  double utilisation() const { return load / item.breaking_load; }
};

/// The origins of a result: program, machine, command line, files and plugins.
struct Origins {
  std::string version, machine, compiler, started, finished;
  std::vector<std::string> command;  // the words of the command line
  struct File {
    std::string path, hash, text;
  };
  std::vector<File> files;  // the first is the scene
  struct Plugin {
    std::string name, version, path, hash;
  };
  std::vector<Plugin> plugins;
  std::string plan;  // text that lists the forces that are evaluated, and why others are not
};

/// The extent of the modelled gear, and names of ropes in its net plan.
struct GearNames {
  int times = 1;                   // 2 if only one half was modelled, else 1
  std::string headline, footrope;  // names of ropes
};

/// Other equilibria of the scene, found by restarting the search from other positions.
struct FoundShapes {
  struct Other {
    // Energy [J]; largest distance of a node from its position in the solution [m].
    double energy = 0, distance = 0;
    std::string furthest;  // name of the node with this distance
    int times = 1;         // how often this equilibrium was found
  };
  int restarts = 0, times = 1;  // times: how often the solution was found
  int by_energy = 0;            // 1: the solution has the least energy; 0: it was found first
  std::vector<Other> others;
};

/// The motion into which a small disturbance of an unstable equilibrium grows, with or without oscillation.
struct Swing {
  std::string furthest;  // name of the node that moves most
  // Growth rate [1/s]; 0 if it is not known. Angular frequency [rad/s]; 0 if nothing oscillates.
  double rate = 0, frequency = 0;
  double share = 1;  // fraction of the mass of the gear that it moves (extent.hpp)
};

/// One solve in the search for the equilibrium: of the scene itself, or of an easier variant, such as a
/// coarser mesh.
struct Stage {
  std::string name, solver, outcome, sentence;
  netloft_variant variant{};
  std::int64_t unknowns = 0;
  Statistics statistics;
  double work = 0;
};

/// One accepted step of the solver, with numbers at the point that it reached.
struct Iteration {
  std::int64_t iteration = 0, factorisations = 0;
  double residual = 0, load = 0, energy = 0, seconds = 0;  // units: [N], [N], [J], [s]
  std::string note;
};

/// Energy that the time integration lost or created by its own error during a motion (energy_judge.hpp).
struct NumericalLoss {
  double lost = 0, given = 0;             // total over the motion [J]
  double negligible = 0;                  // energy W of energy_judge.hpp [J]; 0 in files of older versions
  double worst = 0, from = 0, until = 0;  // largest loss between two outputs [J], and their times [s]
  std::string node;                       // node whose velocity changed most between these outputs
  /// Whether the loss exceeds a twentieth of given + W, the energies in the motion. If it does, no accuracy
  /// setting resolves the motion after the loss. Because of W, rounding errors in a motion with little energy
  /// are not a loss.
  bool is_large() const { return std::abs(lost) > 0.05 * (given + negligible); }
  bool is_created() const { return lost < 0; }
};

/// Facts about a motion in time.
struct Motion {
  // `start_from` is "the equilibrium", "the sketch" (the initial positions), or a result file.
  std::string integrator, start_from;
  double time = 0, resumed_from = 0;  // present time; time from which a killed run was resumed [s]
  std::int64_t steps = 0, rejected = 0;
  double shortest = 0, longest = 0;  // shortest and longest step made [s]
  double stable_step = 0;            // longest stable step if no member is slack [s]; 0: any step is stable
  std::optional<StartBalance> start;
  std::optional<AchievedAccuracy> accuracy;  // nullopt: the scene prescribes the length of steps
  std::optional<NumericalLoss> loss;         // nullopt: energies were not recorded
  std::map<std::string, double> energies;    // energies at the last output [J]
};

/// The numbers of the scene on which the key figures depend most.
struct KeySensitivities {
  struct Row {
    std::string figure, figure_unit;  // a key figure (key_figures.hpp), and its unit
    std::string path, unit;           // path of the number for `--set`, and its unit as written (empty: none)
    double value = 0;                 // the number, in its unit
    double derivative = 0;            // derivative of the figure with respect to the number, in their units
    /// Change of the figure if the number increases by one percent, in the unit of the figure.
    double effect() const { return 0.01 * std::abs(value) * derivative; }
  };
  std::string note;       // how many numbers were examined, or why the table is empty
  std::vector<Row> rows;  // figures in the order of key_figures(), each with the largest effect first
};

/// The result of a run: the data for all its reports, pages and comparisons. make_result() or run_motion()
/// makes it; a file stores it (io/formats/hdf5/LAYOUT.md), and read_result() reads it. Positions and fields
/// are in the file only (StoredShape).
struct Result {
  std::string title, path;  // title: path of the scene; path: of the result file, empty: none yet
  std::string outcome, sentence, stability, at_fault;  // empty `outcome`: the run has not ended
  std::vector<std::string> diagnostics, warnings;
  std::vector<std::string> notes;  // facts that are missing because the file has an older format
  Origins origins;
  std::string solver, strategy, factorisation;
  std::size_t nodes = 0, elements = 0, states = 1;
  std::optional<GearNames> gear;              // nullopt: the scene has no net plan
  std::vector<scenes::NettingSheet> netting;  // panels of the plan that are given by counts and cuttings
  std::vector<NamedScalar> scalars;           // the numbers that the scene requests in [results]
  std::vector<NamedScalar> figures;           // figures of the gear (gear_figures.hpp)
  // The meshes from which mesh errors were estimated, or the reason why they are unknown; empty if mesh
  // errors were not requested.
  std::string mesh_note;
  double node_error = NamedScalar::kUnknown;  // largest displacement of a node in one more Newton step [m]
  std::vector<PartLoad> part_forces;          // sorted by term, then by part
  std::vector<HoldForce> hold_forces;
  std::array<double, 3> balance{};  // sum of all forces on the gear, holds included [N]
  // Largest residual and largest load of a node [N].
  double residual = NamedScalar::kUnknown, largest_load = NamedScalar::kUnknown;
  double energy = NamedScalar::kUnknown;          // energy of the forces that have a potential [J]
  std::optional<FoundShapes> shapes;              // nullopt: there was no search for other equilibria
  std::optional<Swing> swing;                     // nullopt: no motion grows
  std::optional<KeySensitivities> sensitivities;  // nullopt: not requested
  std::vector<Material> materials;
  std::int64_t unknowns = 0;
  double work = 0;  // work in the units of framework/balance/work.hpp
  double reading_seconds = 0, setup_seconds = 0;
  Statistics statistics;
  std::vector<Stage> stages;          // stages in their order; a search that solved only once has one
  std::vector<Iteration> iterations;  // accepted steps of the solver
  std::optional<Motion> motion;       // nullopt: the result is an equilibrium

  bool is_half() const { return gear && gear->times == 2; }
  bool is_answer() const { return outcome == "converged" || outcome == "finished"; }
};

}  // namespace netloft::results
