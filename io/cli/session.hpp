// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/cli/commands.hpp"
#include "io/cli/terminal.hpp"
#include "io/report/text.hpp"
#include "io/scene/loaded_scene.hpp"

#include <memory>

namespace netloft::io {

/// A scene on its way from a file to an assembled problem: what `run` and `plan` share.
class Session {
 public:
  explicit Session(const Options& options);

  /// Reads, checks and assembles the scene. Anything but kDone: it was said why, stop with that code.
  int open();

  const LoadedScene& loaded() const { return loaded_; }
  const Plan& plan() const { return plan_; }
  Assembler& assembler() { return *assembler_; }
  Registry& registry() { return registry_; }
  Terminal& terminal() { return terminal_; }
  PlanExtras plan_extras() const;
  double reading_seconds() const { return reading_seconds_; }
  double setup_seconds() const { return setup_seconds_; }

 private:
  std::vector<std::string> overrides() const;
  int read();
  int assemble();
  int report(int code);
  void add_faults(const SceneError& error);

  const Options& options_;
  Terminal terminal_;
  Registry registry_;
  Diagnostics diagnostics_;
  LoadedScene loaded_;
  Plan plan_;
  std::unique_ptr<Assembler> assembler_;
  double reading_seconds_ = 0, setup_seconds_ = 0;
};

int threads_for(const Options& options);

}  // namespace netloft::io
