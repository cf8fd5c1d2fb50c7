// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/motion/motion_run.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/folders.hpp"
#include "tests/support/work_notes.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::results {
namespace {

MotionResult motion_in(const std::filesystem::path& output, bool resume) {
  runs::PreparedScene scene(
      {netloft::test::source_folder() + "/gear-library/scenes/dynamics/released-rope.toml",
       {"analysis.duration=0.3", "parts.rope.cells=4"},
       1},
      netloft::test::shipped_plugins());
  EXPECT_EQ(scene.prepare(), runs::PreparedScene::State::ready) << scene.diagnostics().render(false);
  return run_motion(scene, {},
                    {.output = output, .resume = resume, .identity = "this", .on_step = {}, .warn = {}});
}

// The motion has ended, and only its file has not been written: the journal keeps all outputs for --resume.
TEST(MotionRun, ThatIsInterruptedWhileItsResultIsWrittenMakesItWhenItIsResumed) {
  const auto folder =
      std::filesystem::path(testing::TempDir()) / ("netloft-motion" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const auto output = folder / "a.hdf", part = folder / "a.hdf.part";
  {
    const netloft::test::WorkNotes notes("writing " + (folder / "a.hdf.new").string());
    const MotionResult interrupted = motion_in(output, false);
    EXPECT_EQ(interrupted.march.status, MarchStatus::interrupted);
    EXPECT_EQ(interrupted.result.path, part.string());
    EXPECT_EQ(interrupted.result.outcome, "interrupted");
    EXPECT_FALSE(std::filesystem::exists(output));
  }
  const MotionResult resumed = motion_in(output, true);
  EXPECT_EQ(resumed.march.status, MarchStatus::finished) << resumed.march.reason;
  EXPECT_EQ(resumed.result.states, 4u);
  EXPECT_TRUE(std::filesystem::exists(output));
  EXPECT_FALSE(std::filesystem::exists(part));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace netloft::results
