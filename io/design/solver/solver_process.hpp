// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/design/live/temporary_folder.hpp"
#include "io/design/solver/line_pipe.hpp"
#include "io/design/solver/solver_call.hpp"

#include <sys/types.h>

#include <string>
#include <vector>

namespace netloft::design {

/// A solver in a process of its own, so that a crash or an endless loop of a plugin does not end the design.
/// The process is started by the first call, and again by the first call after its end. It ends with this
/// object. For use by one thread.
class SolverProcess {
 public:
  /// `command`: a command line of this program that runs serve_solver() on its standard streams.
  explicit SolverProcess(std::vector<std::string> command) : command_(std::move(command)) {}
  ~SolverProcess();
  SolverProcess(const SolverProcess&) = delete;
  SolverProcess& operator=(const SolverProcess&) = delete;

  /// Answers like a SolverCall. The process is killed if it does not answer within some seconds after an
  /// interruption.
  Json answer(const std::string& name, const Json& body, const std::atomic<bool>& interrupt,
              const OnProgress& on_progress);

 private:
  void start();
  Json next_message(const std::atomic<bool>& interrupt);
  [[noreturn]] void throw_end(const std::string& sentence);
  std::string end();

  std::vector<std::string> command_;
  TemporaryFolder folder_;  // for its files, which a process that crashes leaves
  pid_t process_ = 0;       // 0: none is running
  int words_ = -1;          // its standard error, a file in memory
  LinePipe pipe_;
  std::uint64_t call_ = 0;
};

}  // namespace netloft::design
