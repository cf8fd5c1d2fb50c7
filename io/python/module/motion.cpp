// SPDX-License-Identifier: BSD-3-Clause
#include "io/python/module/motion.hpp"

#include "io/formats/work/interruptible_work.hpp"
#include "io/program/session/session.hpp"
#include "io/results/file/provenance.hpp"
#include "io/results/file/start_from.hpp"
#include "io/results/motion/motion_run.hpp"
#include "io/results/text/plan_text.hpp"

namespace netloft::python {

namespace {

void require_motion(const scenes::LoadedScene& loaded) {
  if (loaded.analysis.kind != AnalysisKind::dynamics)
    throw std::invalid_argument(
        "simulate() computes motions, and this scene is an equilibrium; use solve(), or "
        "with_({\"analysis.kind\": \"dynamic\", \"analysis.duration\": \"10 s\"})");
}

/// Displacements at the start if a motion begins at a result; nullopt for other motions.
std::optional<std::vector<double>> start_of(runs::PreparedScene& scene) {
  const auto& file = scene.loaded().analysis.dynamics.start_file;
  if (file.empty()) return {};
  const results::StoredShape shape(file);
  return scene.assembler().displacements(results::positions_from(shape, scene.loaded()));
}

}  // namespace

MotionEnd simulate(const OpenedScene& source, const std::filesystem::path& output,
                   const std::function<void(double, double)>& on_step, const std::atomic<bool>& interrupt) {
  const formats::InterruptibleWork reading(interrupt);
  const auto scene = source.prepare();
  require_motion(scene->loaded());
  const results::RunContext context{source.command(), results::utc_now(), scene->registry().opened(),
                                    results::plan_text(scene->plan(), program::plan_extras(*scene))};
  MotionEnd end;
  results::MotionOptions how{};
  how.output = output;
  how.start = start_of(*scene);
  how.interrupt = &interrupt;
  if (on_step) how.on_step = [&](const StepRecord& step) { on_step(step.t, step.end); };
  how.warn = [&](const std::string& text) { end.warnings.push_back(text); };
  end.file = results::run_motion(*scene, context, how).result.path;
  return end;
}

}  // namespace netloft::python
