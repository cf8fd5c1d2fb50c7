// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/options.hpp"

namespace netloft::program {

struct RunOptions : MethodOptions {
  std::string output;              // option -o
  bool resume = false;             // option --resume
  bool overwrite = false;          // option --overwrite
  std::string start_from;          // option --start-from RESULT.hdf
  bool stages = false;             // option --stages
  bool error = false;              // option --error
  bool sensitivities = false;      // option --sensitivities
  std::vector<std::string> words;  // the command line, for the result file
};

struct DesignOptions : SceneOptions {  // `scene` is GEAR_OR_SCENE
  int port = 0;                        // option --port; 0: any free one
  std::string beside;                  // option --beside: a gear or result to compare with
  bool no_browser = false;             // option --no-browser
  bool as_solver = false;              // hidden option --as-solver: answers a design on standard streams
};

int run_command(const RunOptions& options);        // solves a scene
int plan_command(const MethodOptions& options);    // lists the needs of a scene
int design_command(const DesignOptions& options);  // serves a page on which a gear is changed
int serve_command(const DesignOptions& options);   // serves the same to programs

}  // namespace netloft::program
