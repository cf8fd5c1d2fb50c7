// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/checked_plan.hpp"

#include "io/formats/toml/accepted_warnings.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/tried_cures.hpp"

namespace netloft::gears {

namespace {

NetPlan read_and_check(const std::optional<PlanDocument>& document, HintTrials trials,
                       formats::Diagnostics& diagnostics) {
  if (!document) return {};
  PlanMemory none;
  NetPlan plan = read_and_check(document->root, document->catalogue, none, trials, diagnostics);
  formats::accept_warnings(document->root, diagnostics);
  plan.files = document->files;
  return plan;
}

}  // namespace

NetPlan read_and_check(const formats::Value& root, const Catalogue& catalogue, PlanMemory& memory,
                       HintTrials trials, formats::Diagnostics& diagnostics) {
  formats::Diagnostics said = diagnostics;
  said.expect_trials(trials == HintTrials::of_all);
  NetPlan plan = read_plan(root, catalogue, memory, said);
  if (said.errors() == 0) check_plan(plan, said);
  if (trials == HintTrials::of_errors && said.errors())  // only now it is known that proposals are needed
    return read_and_check(root, catalogue, memory, HintTrials::of_all, diagnostics);
  formats::mark_accepted(root, said);
  if (trials == HintTrials::of_all) try_cures(root, catalogue, said);
  said.expect_trials(true);
  diagnostics = std::move(said);
  return plan;
}

NetPlan read_and_check(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                       formats::Diagnostics& diagnostics) {
  const formats::LongWork reading({"reading", file.native()});
  return read_and_check(PlanDocument::load(file, overrides, diagnostics), HintTrials::of_errors, diagnostics);
}

NetPlan read_and_check_text(const std::string& text, const std::string& name,
                            formats::Diagnostics& diagnostics) {
  return read_and_check(PlanDocument::parse(text, name, diagnostics), HintTrials::of_all, diagnostics);
}

}  // namespace netloft::gears
