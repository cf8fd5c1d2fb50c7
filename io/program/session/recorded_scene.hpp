// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/program/session/options.hpp"
#include "io/results/figures/result.hpp"
#include "io/runs/prepared_scene.hpp"

namespace netloft::program {

/// The scene of a result, from the texts and the command line that its file contains.
struct RecordedScene {
  MethodOptions options;  // those of the command, completed by those of the run
  runs::CaseSource source;
  results::Origins origins;
};

/// Whether the argument SCENE names a result instead of a scene.
bool names_result(const MethodOptions& options);

/// The scene of the result that the argument SCENE names. --set of the command takes precedence over --set of
/// the run. Throws UsageError if the file cannot be read, lacks the texts, or is not that of an equilibrium.
RecordedScene recorded_scene(const MethodOptions& options);

/// Throws UsageError if a file that the scene reads has changed since the result was written: a catalogue, a
/// mesh or a relief. These are opened again; the texts of all other files are those of the result.
void refuse_changed_files(const RecordedScene& recorded, const scenes::LoadedScene& loaded);

}  // namespace netloft::program
