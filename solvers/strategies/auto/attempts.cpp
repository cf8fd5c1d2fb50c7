// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/auto/attempts.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace netloft::automatic {

namespace {

/// What of a scene decides which attempts suit it.
struct Kind {
  bool sticks, has_slack_members, has_members, has_meshes;
};

/// By how much the stiffest part would stretch if it carried all that drives the gear; 1 where nothing does.
double stretch_of_stiffest(Study& study) {
  return study.load() == 0 ? 1 : study.load() / std::max(study.load(), study.stiffness());
}

Kind kind_of(Study& study, const Options& options) {
  Kind kind{};
  const double stretch = stretch_of_stiffest(study);
  kind.sticks = study.remembers();
  kind.has_members = study.has_members() && study.load() > 0;
  kind.has_slack_members =
      kind.has_members && (study.flows() ? study.members() > study.size() : stretch <= options.slack);
  kind.has_meshes = study.levels() > 1;
  return kind;
}

struct Row {
  Attempt attempt;
  bool (*suits)(const Kind& kind);
};

/// In the order of what they cost; each row says when it is tried.
const Row kTable[] = {
    {{"relaxed", "relaxed", "", "relaxed", "elements stick and slide, which no tangent foresees"},
     [](const Kind& k) { return k.sticks; }},
    {{"tension-only", "tension/only", "", "direct",
      "twines and ropes may be slack: with tension only it is convex"},
     [](const Kind& k) { return k.has_slack_members && !k.sticks; }},
    {{"coarse-to-fine", "coarse-to-fine", "by=auto,with=restarts=0", "direct",
      "a coarser mesh costs a fraction and leads near"},
     [](const Kind& k) { return k.has_meshes && !k.sticks; }},
    {{"tension-stages", "tension/stages", "", "direct",
      "with tensions as unknowns stiff members turn at once"},
     [](const Kind& k) { return k.has_members && !k.sticks; }},
    {{"direct", "direct", "", "direct", "the start may be near"}, [](const Kind&) { return true; }},
    {{"stiffness-steps", "stiffness-steps", "", "direct", "soft members turn where stiff ones hold fast"},
     [](const Kind&) { return true; }},
    {{"pseudo-time", "pseudo-time", "", "pseudo-time", "a motion passes by what is unstable"},
     [](const Kind& k) { return !k.sticks; }},
    {{"relaxed", "relaxed", "", "relaxed", "a solver without a tangent leads where the others stall"},
     [](const Kind& k) { return !k.sticks; }},
};

}  // namespace

void check_parts(const Options& options) {
  std::vector<std::string> known{"restarts", "compensated"};
  for (const Row& row : kTable)
    if (std::find(known.begin(), known.end(), row.attempt.name) == known.end())
      known.push_back(row.attempt.name);
  std::istringstream parts(options.without);
  for (std::string name; std::getline(parts, name, '+');) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    std::string all;
    for (const std::string& part : known) all += (all.empty() ? "" : ", ") + part;
    throw std::invalid_argument("without = \"" + name + "\" is no part of it; there are " + all);
  }
}

bool is_left_out(const Options& options, const std::string& part) {
  std::istringstream parts(options.without);
  for (std::string name; std::getline(parts, name, '+');)
    if (name == part) return true;
  return false;
}

std::vector<Attempt> attempts_for(Study& study, const Options& options) {
  const Kind kind = kind_of(study, options);
  std::vector<Attempt> attempts;
  for (const Row& row : kTable)
    if (row.suits(kind) && !is_left_out(options, row.attempt.name)) attempts.push_back(row.attempt);
  // A coarser mesh is brought to equilibrium likewise, without what the user leaves out.
  for (Attempt& attempt : attempts)
    if (!attempt.parameters.empty() && *options.without)
      attempt.parameters += ";without=" + std::string(options.without);
  return attempts;
}

}  // namespace netloft::automatic
