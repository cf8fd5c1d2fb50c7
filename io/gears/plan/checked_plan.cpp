// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/checked_plan.hpp"

#include "io/formats/toml/accepted_warnings.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/tried_cures.hpp"

#include <algorithm>
#include <tuple>

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

bool is_same_panel(const Panel& a, const Panel& b) {
  const auto all = [](const Panel& p) {
    return std::tie(p.name, p.stands, p.mesh, p.orientation, p.angle, p.fore, p.aft, p.states_aft, p.depth,
                    p.pieces, p.open, p.has_corners, p.is_round, p.outer, p.inner, p.outline, p.place,
                    p.aft_place);
  };
  return all(a) == all(b);
}

bool is_same_rope(const Rope& a, const Rope& b) {
  const auto all = [](const Rope& r) {
    return std::tie(r.name, r.stands, r.length, r.length_port, r.role, r.role_place, r.between, r.is_selvedge,
                    r.place, r.between_place);
  };
  return all(a) == all(b);
}

bool is_same_name(const Point& a, const Point& b) {
  return a.name == b.name && a.stands == b.stands && a.place == b.place;
}

std::shared_ptr<const NetCheck> check_of(NetPlan net, formats::Diagnostics said) {
  said.expect_trials(false);
  check_net(net, said);
  return std::make_shared<const NetCheck>(
      NetCheck{said.messages(), said.errors() ? std::vector<RopeSpan>{} : rope_spans(net)});
}

/// Checks a plan like check_plan(), but without proposals, and uses the stored check of an equal net. Panels
/// with errors are not changed, because the plan is read and checked again after an error.
void check_plan(const NetPlan& plan, PlanMemory& memory, formats::Diagnostics& said) {
  const auto check = memory.checks.of<const NetPlan&>(
      plan, [&](const NetPlan& net) { return check_of(net, said.without_messages()); });
  said.take_messages(check->messages);
  check_fittings(plan, check->spans, said);
}

}  // namespace

bool NetInput::operator==(const NetPlan& other) const {
  return std::ranges::equal(plan.panels, other.panels, is_same_panel) &&
         std::ranges::equal(plan.ropes, other.ropes, is_same_rope) && plan.hangings == other.hangings &&
         plan.joins == other.joins && std::ranges::equal(plan.points, other.points, is_same_name) &&
         plan.bodies == other.bodies;
}

NetPlan read_and_check(const formats::Value& root, const Catalogue& catalogue, PlanMemory& memory,
                       HintTrials trials, formats::Diagnostics& diagnostics) {
  formats::Diagnostics said = diagnostics;
  said.expect_trials(trials == HintTrials::of_all);
  NetPlan plan = read_plan(root, catalogue, memory, said);
  if (said.errors() == 0)
    trials == HintTrials::of_all ? check_plan(plan, said) : check_plan(plan, memory, said);
  if (trials == HintTrials::of_errors && said.errors())  // proposals are needed only after an error
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
