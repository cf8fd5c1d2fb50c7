// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/compare_options.hpp"
#include "io/program/session/scope_options.hpp"
#include "io/program/session/study_options.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace netloft::program {

/// Options of the commands that show a result.
struct PictureOptions {
  std::string view = "oblique";  // --view
  std::string field;             // --field
  std::size_t width = 1000;      // --width
  std::size_t states = 100;      // view: --states
  int state = -1;                // --state; -1: the newest
  std::string fit = "netting";   // --fit
  bool dark = false;             // --dark
  bool log = false;              // --log
  bool elements = false;         // --elements
  bool dimensions = false;       // --dimensions
};

/// The command line, taken apart.
struct Options {
  std::string command;               // run, plan, list, describe, schema, test
  std::string kind;                  // new: element, law, solver, integrator, strategy
  std::string target;                // scene, component, plugin or result
  std::string other;                 // diff: the second result
  std::vector<std::string> targets;  // view: results
  std::string output;                // -o
  bool resume = false;               // --resume
  bool overwrite = false;            // --overwrite
  bool error = false;                // --error
  std::string start_from;            // --start-from RESULT.hdf
  bool stages = false;               // --stages
  std::vector<std::int64_t> nodes;   // refine: --nodes
  std::string strategy;              // --strategy NAME[:key=value[,key=value]]
  std::string solver;                // --solver, likewise
  std::vector<std::string> set;      // --set path=value
  std::vector<std::string> plugins;  // --plugins DIR
  bool scene_plugins = false;        // --scene-plugins
  bool mesh = false;                 // --mesh
  std::size_t mesh_nodes = 2000;     // draw: --nodes
  int threads = 0;                   // 0: as many as the machine has
  double seconds = 60;               // test: --seconds. All of the largest shipped plugin takes 1 s
  bool json = false;
  std::string color = "auto";
  bool html = false, csv = false;  // report
  std::string mesh_file, folder;   // import: --mesh, --check
  bool divides = false;            // import: --divide
  bool moves = false;              // import: --motion
  PictureOptions picture;          // of view and draw
  CompareOptions compare;          // of that command alone
  ScopeOptions scope;              // of that command alone
  StudyCommandOptions study;       // of that command alone
  std::vector<std::string> words;  // the command line as given
  std::vector<std::string> given;  // long names of the options in it: "--field"
};

/// Something wrong with the command line: exit 2.
struct UsageError {
  std::string message;
};

/// An option that changes nothing is a misunderstanding: throws UsageError if one of `idle` is given, with
/// `why`: "GEAR is a net plan".
void refuse_idle(const Options& options, const std::vector<std::string>& idle, const std::string& why);

/// Exit codes: the promise of the README.
enum Exit { kDone = 0, kOther = 1, kWrongInput = 2, kNotConverged = 3, kRefused = 4, kInterrupted = 130 };

}  // namespace netloft::program
