// SPDX-License-Identifier: BSD-3-Clause
#include "io/cli/session.hpp"

#include "io/cli/error_json.hpp"
#include "solvers/factorisation/factorisation.hpp"

#include <algorithm>
#include <cstdio>
#include <stdexcept>
#include <thread>

namespace netloft::io {

int threads_for(const Options& options) {
  if (options.threads > 0) return options.threads;
  return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 64);
}

CaseSource source_of(const Options& options) {
  CaseSource source{options.target, options.set, threads_for(options)};
  if (options.looks >= 0) source.overrides.push_back("analysis.looks=" + std::to_string(options.looks));
  if (options.solver.empty()) return source;
  try {
    for (auto& word : solver_overrides(options.solver)) source.overrides.push_back(std::move(word));
  } catch (const std::invalid_argument& e) {
    throw UsageError{e.what()};
  }
  return source;
}

Session::Session(const Options& options)
    : options_(options), terminal_(options.color), case_(source_of(options), registry_) {
  find_plugins(options, registry_);
}

int Session::open() {
  const Case::State state = case_.open();
  const Diagnostics& diagnostics = case_.diagnostics();
  if (state != Case::State::ready) return tell_why_not(diagnostics, state, options_, terminal_);
  if (diagnostics.warnings()) terminal_.say(diagnostics.render(terminal_.color()));
  return kDone;
}

int tell_why_not(const Diagnostics& diagnostics, Case::State state, const Options& options,
                 Terminal& terminal) {
  terminal.say(diagnostics.render(terminal.color()));
  const int code = state == Case::State::refused ? kRefused : kWrongInput;
  if (options.json) std::puts(errors_json(diagnostics, code).c_str());
  return code;
}

namespace {

/// What the program does around the solver.
std::string way_of(const Case& scene) {
  const Analysis& analysis = scene.loaded().analysis;
  if (!analysis.continuation) return "";
  if (analysis.in_stages)
    return "from soft to stiff first, tensions being unknowns, then over easier scenes where it does not "
           "arrive";
  const std::string chosen = analysis.automatic ? "chosen by auto, " : "";
  if (scene.begins_in_cones())
    return chosen +
           "from where it rests if twines and ropes bear tension only, over coarser meshes and easier scenes "
           "where it does not arrive";
  return chosen +
         "from coarser meshes where cells can be halved, over easier scenes where it does not arrive "
         "(from soft to stiff first where the load would hardly stretch it)";
}

}  // namespace

PlanExtras Session::plan_extras() {
  const auto factorisation =
      make_factorisation(plan().symmetric ? MatrixClass::positive_definite : MatrixClass::unsymmetric);
  return {loaded().analysis.solver, factorisation->description(), assembler().pattern().entries(),
          threads_for(options_),    assembler().threads_used(),   way_of(case_)};
}

}  // namespace netloft::io
