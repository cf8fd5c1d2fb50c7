// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

namespace netloft::program {

/// Options of every command that has an answer.
struct CommonOptions {
  std::string color = "auto";  // option --color
  bool json = false;           // option --json
};

/// Options of commands that load plugins.
struct PluginOptions : CommonOptions {
  std::vector<std::string> plugins;  // option --plugins DIR
};

/// Options of commands that read a scene.
struct SceneOptions : PluginOptions {
  std::string scene;             // argument SCENE
  std::vector<std::string> set;  // option --set path=value
  int threads = 0;               // option --threads; 0: one per core of the machine
  bool scene_plugins = false;    // option --scene-plugins
};

/// Options of commands that solve a scene by one method.
struct MethodOptions : SceneOptions {
  std::string strategy, solver;  // options --strategy, --solver NAME[:key=value[,key=value]]
};

/// An error of the command line: exit code 2.
struct UsageError {
  std::string message;
};

/// Exit codes, as documented in the README.
enum Exit { kDone = 0, kOther = 1, kWrongInput = 2, kNotConverged = 3, kRefused = 4, kInterrupted = 130 };

}  // namespace netloft::program
