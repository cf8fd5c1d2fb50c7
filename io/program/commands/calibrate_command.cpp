// SPDX-License-Identifier: BSD-3-Clause
#include "io/program/commands/studies.hpp"
#include "io/program/session/memory_room.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/session.hpp"
#include "io/program/session/watchdog.hpp"
#include "io/studies/calibration/calibration.hpp"

namespace netloft::program {

int calibrate_command(const CalibrateOptions& options) {
  require_memory_to_solve();
  Terminal terminal(options);
  formats::Diagnostics diagnostics;
  studies::CalibrationFile file = studies::read_calibration_file(options.file, diagnostics);
  Registry registry;
  find_plugins(options, registry);
  Watchdog watchdog(terminal,
                    ending_with_a_sentence(terminal, "the calibration ends here without an answer"));
  const std::filesystem::path folder = std::filesystem::path(options.file).parent_path();
  const runs::Watch watch{.interrupt = &interrupt_flag(),
                          .on_budget = [&](double seconds) { watchdog.allow(seconds); }};
  studies::CheckedCalibration checked;
  if (!diagnostics.errors())
    checked = studies::check_calibration(file, folder, registry, diagnostics, watch.on_budget);
  if (diagnostics.errors())
    return report_unready(
        diagnostics,
        checked.refused ? runs::PreparedScene::State::refused : runs::PreparedScene::State::wrong_input,
        terminal);
  if (diagnostics.warnings()) terminal.say(diagnostics);
  catch_interrupts();
  const auto on_solve = [&](std::size_t solves, const std::string& scene) {
    terminal.progress_in_steps("solves", solves, 0, scene);
  };
  const studies::Calibration done =
      studies::calibrate(std::move(file), checked, folder, registry, watch, on_solve);
  terminal.clear();
  print_line(options.json ? studies::calibration_json(done) : studies::calibration_text(done));
  if (done.is_interrupted)
    return end_interrupted(terminal, done.fit.parameters.empty()
                                         ? "no step of the search was finished"
                                         : "these are the best values that were found until then");
  return done.fit.converged ? kDone : kNotConverged;
}

}  // namespace netloft::program
