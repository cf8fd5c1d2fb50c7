// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/work/interruptible_work.hpp"
#include "io/python/module/background.hpp"
#include "io/python/module/module.hpp"
#include "io/python/module/opened_scene.hpp"
#include "io/studies/calibration/calibration.hpp"
#include "io/studies/optimum/scene_optimum.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

namespace netloft::python {

namespace py = pybind11;

namespace {

namespace fs = std::filesystem;

/// The report of a search, as JSON and as text.
struct SearchReports {
  std::string json, text;
};

void require_none(const formats::Diagnostics& diagnostics, bool refused) {
  if (diagnostics.errors()) throw WrongScene(diagnostics, refused);
}

/// The work of `netloft optimise`. Points that are in `history` are not solved again.
SearchReports optimise_file(const fs::path& path, const fs::path& history,
                            const std::atomic<bool>& interrupt) {
  const formats::InterruptibleWork reading(interrupt);
  const ReadingLock lock;
  formats::Diagnostics diagnostics;
  const studies::OptimumFile file = studies::read_optimum_file(path, diagnostics);
  const fs::path folder = path.parent_path();
  studies::CheckedOptimum checked;
  if (!file.scene.empty()) checked = studies::check_optimum(file, folder, registry(), diagnostics);
  require_none(diagnostics, checked.refused);
  studies::PointHistory known(history, checked.inputs);
  const auto done =
      studies::optimise_scene(file, checked, folder, registry(), known, {.interrupt = &interrupt});
  return {studies::optimum_json(done), studies::optimum_text(done)};
}

/// The work of `netloft calibrate`.
SearchReports calibrate_file(const fs::path& path, const std::atomic<bool>& interrupt) {
  const formats::InterruptibleWork reading(interrupt);
  const ReadingLock lock;
  formats::Diagnostics diagnostics;
  studies::CalibrationFile file = studies::read_calibration_file(path, diagnostics);
  const fs::path folder = path.parent_path();
  studies::CheckedCalibration checked;
  if (!diagnostics.errors()) checked = studies::check_calibration(file, folder, registry(), diagnostics, {});
  require_none(diagnostics, checked.refused);
  const auto done =
      studies::calibrate(std::move(file), checked, folder, registry(), {.interrupt = &interrupt});
  return {studies::calibration_json(done), studies::calibration_text(done)};
}

/// Runs a search in the background. Returns its reports, and the exception of the signal handler that ended
/// it, if any. The reports are empty if the search ended before its first point.
template <class Search>
py::tuple reports_of(const Search& search) {
  SearchReports found;
  const auto raised = call_in_background([&](std::atomic<bool>& interrupt) {
    try {
      found = search(interrupt);
    } catch (const formats::Interrupted&) {
      return;
    }
  });
  py::object ended_by = py::none();
  try {
    if (raised) std::rethrow_exception(raised);
  } catch (py::error_already_set& e) {
    ended_by = e.value();
  }
  return py::make_tuple(found.json, found.text, ended_by);
}

}  // namespace

void bind_searches(py::module_& module) {
  module.def(
      "optimise",
      [](const fs::path& file, const fs::path& history) {
        return reports_of([&](const auto& interrupt) { return optimise_file(file, history, interrupt); });
      },
      py::arg("file"), py::arg("history"));
  module.def(
      "calibrate",
      [](const fs::path& file) {
        return reports_of([&](const auto& interrupt) { return calibrate_file(file, interrupt); });
      },
      py::arg("file"));
}

}  // namespace netloft::python
