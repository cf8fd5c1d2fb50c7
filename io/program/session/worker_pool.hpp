// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace netloft::program {

/// The end of a program that was started for a job.
struct WorkerEnd {
  int code = 0;            // exit code; 128 + signal if it was killed by one
  std::string last_words;  // last line that it wrote to standard error
  std::string sentence() const;
};

/// Starts programs for jobs 0 … count − 1, at most `jobs` at a time, in this order, each with the command
/// line of `command`, and calls `on_end` when one ends. After an interruption, and when this program ends, no
/// more are started and those that run are terminated. Returns the number of jobs that were started.
std::size_t run_workers(std::size_t count, int jobs,
                        const std::function<std::vector<std::string>(std::size_t)>& command,
                        const std::function<void(std::size_t, const WorkerEnd&)>& on_end,
                        const std::atomic<bool>& interrupt);

}  // namespace netloft::program
