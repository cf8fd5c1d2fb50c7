// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/hdf5/handle.hpp"
#include "io/program/session/options.hpp"

#include <string>

namespace netloft::program {

/// Reports later crashes of the program on standard error: the running plugin, its call, and whether the
/// stack overflowed. The exit code is then kOther. It is also kOther, with a sentence, if a plugin ends the
/// program by exit, quick_exit, _exit or _Exit. A plugin is taken to have done so if the program ends before
/// last_step(), but not by end_at_once().
void explain_crashes();
/// Marks the last step of the program, and returns its exit code. The exit code is `code`, except that kDone
/// becomes kOther if a plugin broke a rule of the plugin interface and this has not been reported.
int last_step(int code);
/// Ends the process without the handlers of atexit().
[[noreturn]] void end_at_once(int code);
/// Serves calls of _exit and _Exit in plugins and libraries: reports the early end, and ends the process.
[[noreturn]] void end_called_from_outside(int code);

/// Reports crashes in conformance checks of the component `type` like explain_crashes(), and names the check.
/// Checks are ended after `seconds` of processor time and by an interruption. An empty `type` ends this mode.
void explain_crashes_of(const std::string& type, double seconds = 0);

/// While it exists, a crash ends the program with a sentence about the file and exit code 2, because HDF5
/// 1.10 crashes on some damaged files. Only one object may exist at a time.
class DamagedFileWatch {
 public:
  DamagedFileWatch(const std::string& path, bool json);
  ~DamagedFileWatch();
  DamagedFileWatch(const DamagedFileWatch&) = delete;
  DamagedFileWatch& operator=(const DamagedFileWatch&) = delete;
};

/// Calls a function on a result file that may be damaged. Errors of the file become UsageErrors.
template <class Action>
auto on_file(const std::string& path, bool json, Action&& action) {
  const DamagedFileWatch watch(path, json);
  try {
    return action();
  } catch (const formats::FileError& e) {
    const std::string reason = e.what();
    const bool names_it = reason.find("cannot read ") == 0 || reason.find(path) != std::string::npos;
    throw UsageError{names_it ? reason : "cannot read " + path + ": " + reason};
  }
}

}  // namespace netloft::program
