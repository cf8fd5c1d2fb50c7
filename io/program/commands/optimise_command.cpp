// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/files/whole_file.hpp"
#include "io/program/commands/studies.hpp"
#include "io/program/session/memory_room.hpp"
#include "io/program/session/print.hpp"
#include "io/program/session/replaced_file.hpp"
#include "io/program/session/session.hpp"
#include "io/program/session/watchdog.hpp"
#include "io/studies/optimum/scene_optimum.hpp"

namespace netloft::program {

namespace {

namespace fs = std::filesystem;

fs::path make_folder(const OptimiseOptions& o, const studies::OptimumFile& file) {
  const fs::path folder = o.output.empty() ? file.name + ".optimum" : o.output;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw UsageError{folder.string() + " cannot be made: " + error.message()};
  return folder;
}

constexpr const char *kHistoryFile = "history.jsonl", *kSceneFile = "scene.toml",
                     *kPictureFile = "history.svg";

/// Throws UsageError if an output would replace a file that the scene is read from.
void require_places(const fs::path& folder, const runs::PreparedScene& scene) {
  for (const char* name : {kHistoryFile, kSceneFile, kPictureFile})
    require_place((folder / name).string(), paths_of(scene.loaded()));
}

/// Prints the answer and writes its scene and its picture.
int end_with(const OptimiseOptions& o, Terminal& terminal, const studies::SceneOptimum& done,
             const fs::path& source, const fs::path& folder) {
  terminal.clear();
  print_line(o.json ? studies::optimum_json(done) : studies::optimum_text(done));
  if (done.is_interrupted)
    return end_interrupted(
        terminal, "call it again to go on; " + (folder / kHistoryFile).string() + " has what was solved");
  return write_last(terminal, done.found.converged ? kDone : kNotConverged, [&] {
    if (done.found.best.parameters.empty()) return;
    formats::write_keeping(folder / kSceneFile, studies::scene_text(done, source, folder));
    formats::write_keeping(folder / kPictureFile, formats::draw_svg(studies::optimum_plot(done)));
  });
}

}  // namespace

int optimise_command(const OptimiseOptions& options) {
  require_memory_to_solve();
  Terminal terminal(options);
  formats::Diagnostics diagnostics;
  const studies::OptimumFile file = studies::read_optimum_file(options.file, diagnostics);
  Registry registry;
  find_plugins(options, registry);
  Watchdog watchdog(terminal,
                    ending_with_a_sentence(terminal, "the optimisation ends here; call it again to go on"));
  const runs::Watch watch{.interrupt = &interrupt_flag(),
                          .on_budget = [&](double seconds) { watchdog.allow(seconds); }};
  const fs::path source = fs::path(options.file).parent_path();
  studies::CheckedOptimum checked;
  if (!file.scene.empty())
    checked = studies::check_optimum(file, source, registry, diagnostics, watch.on_budget);
  if (diagnostics.errors())
    return report_unready(
        diagnostics,
        checked.refused ? runs::PreparedScene::State::refused : runs::PreparedScene::State::wrong_input,
        terminal);
  if (diagnostics.warnings()) terminal.say(diagnostics);
  const fs::path folder = make_folder(options, file);
  require_places(folder, *checked.scene);
  studies::PointHistory history(folder / kHistoryFile, checked.inputs);
  catch_interrupts();
  std::size_t points = 0;
  const auto on_point = [&](const OptimumPoint&) {
    terminal.progress_in_steps("points", ++points, static_cast<std::size_t>(file.solves), file.name);
  };
  const studies::SceneOptimum done =
      studies::optimise_scene(file, checked, source, registry, history, watch, on_point);
  return end_with(options, terminal, done, source, folder);
}

}  // namespace netloft::program
