// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace netloft::program {

/// The outcome of a program that ran a job.
struct WorkerEnd {
  int code = 0;            // exit code; 128 + signal if a signal killed it
  std::string last_words;  // last line of its standard error
  std::string sentence() const;
};

/// Starts one program for each of the jobs 0 … count − 1, in this order, with the command line that `command`
/// gives for the job. At most `jobs` programs run at a time; `on_end` is called when one ends. After an
/// interruption, no more programs are started and running ones are terminated. Running programs are also
/// terminated if this program ends. Returns the number of started jobs.
std::size_t run_workers(std::size_t count, int jobs,
                        const std::function<std::vector<std::string>(std::size_t)>& command,
                        const std::function<void(std::size_t, const WorkerEnd&)>& on_end,
                        const std::atomic<bool>& interrupt);

}  // namespace netloft::program
