// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/python/module/opened_scene.hpp"

#include <atomic>
#include <functional>

namespace netloft::python {

/// How a motion ended.
struct MotionEnd {
  std::filesystem::path file;  // the result; NAME.hdf.part after an interruption
  std::vector<std::string> warnings;
};

/// Computes the motion of a scene into the result file `output`, as `netloft run` does. `on_step` receives
/// the present time and the time of the end [s]. Throws WrongScene, FileError, and std::invalid_argument if
/// the scene has no motion.
MotionEnd simulate(const OpenedScene& source, const std::filesystem::path& output,
                   const std::function<void(double, double)>& on_step, const std::atomic<bool>& interrupt);

}  // namespace netloft::python
