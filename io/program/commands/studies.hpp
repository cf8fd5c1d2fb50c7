// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/options.hpp"

namespace netloft::program {

struct ScopeOptions : MethodOptions {
  std::string depth;            // option --depth LO:HI[:N]
  std::string warp = "2:5:13";  // option --warp, in the form LO:HI:COUNT, as a multiple of the depth
  std::string heel = "-5:5";    // option --heel LO:HI
  std::string spread;           // option --spread LO:HI; empty: any
  std::string output;           // option -o
};

struct SensitivityOptions : MethodOptions {
  std::vector<std::string> to, of;  // options --to, --of
  bool check = false;               // option --check
  std::string output;               // option -o
};

struct CalibrateOptions : PluginOptions {
  std::string file;  // argument CALIBRATION
};

struct OptimiseOptions : PluginOptions {
  std::string file;    // argument STUDY
  std::string output;  // option -o; empty: the name of the file with .optimum
};

struct StudyPlanOptions : PluginOptions {
  std::string file;    // argument STUDY
  std::string output;  // option -o
};

/// Options of the action `study missing`.
struct StudyOptions : CommonOptions {
  std::string folder;  // argument FOLDER
};

struct StudyCollectOptions : StudyOptions {
  std::string output;  // option -o; empty: the folder of the study
};

struct StudyRunOptions : PluginOptions {
  std::string folder;  // argument FOLDER
  std::string items;   // option --items 1-10,15
  int jobs = 0;        // option --jobs; 0: one per core of the machine
  int threads = 0;     // option --threads; 0: one
};

struct StudySubmitOptions : PluginOptions {
  std::string folder;  // argument FOLDER
  std::string engine;  // option --engine parallel, slurm
  int jobs = 0;        // option --jobs; 0: one per core of the machine
  int chunk = 0;       // option --chunk; 0: as many items as take at least a minute
};

struct StudyShowOptions : StudyOptions {
  std::vector<std::string> figures, at;  // options --figure, --at NAME=VALUE
  std::string over, by;                  // options --over, --by
  std::string output;                    // option -o
};

int scope_command(const ScopeOptions& options);          // lengths of warp for each depth
int calibrate_command(const CalibrateOptions& options);  // calibrates parameters of scenes with measurements
int sensitivity_command(const SensitivityOptions& options);  // derivatives of figures with respect to numbers
int optimise_command(const OptimiseOptions& options);        // finds the best values of numbers of a scene

// actions on studies: many solves of one scene with varied inputs
int study_plan_command(const StudyPlanOptions& options);
int study_run_command(const StudyRunOptions& options);
int study_missing_command(const StudyOptions& options);
int study_submit_command(const StudySubmitOptions& options);
int study_collect_command(const StudyCollectOptions& options);
int study_show_command(const StudyShowOptions& options);

}  // namespace netloft::program
