// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/cli/options.hpp"
#include "io/hdf5/handle.hpp"

#include <csignal>
#include <string>

namespace netloft::io {

/// While it lives, a crash ends the program with a sentence about the file and exit code 2: HDF5 1.10 reads
/// beyond its memory on some damaged files, and there is nothing to go on with.
class DamagedFileWatch {
 public:
  DamagedFileWatch(const std::string& path, bool json);
  ~DamagedFileWatch();
  DamagedFileWatch(const DamagedFileWatch&) = delete;
  DamagedFileWatch& operator=(const DamagedFileWatch&) = delete;

 private:
  struct sigaction before_[3];
};

/// Runs an action on a result file that may be damaged; what is wrong with the file is wrong input.
template <class Action>
auto on_file(const std::string& path, bool json, Action&& action) {
  const DamagedFileWatch watch(path, json);
  try {
    return action();
  } catch (const FileError& e) {
    const std::string reason = e.what();
    const bool names_it = reason.find("cannot read ") == 0 || reason.find(path) != std::string::npos;
    throw UsageError{names_it ? reason : "cannot read " + path + ": " + reason};
  }
}

}  // namespace netloft::io
