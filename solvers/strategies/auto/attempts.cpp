// SPDX-License-Identifier: BSD-3-Clause
#include "solvers/strategies/auto/attempts.hpp"

#include <algorithm>
#include <sstream>
#include <string_view>

namespace netloft::automatic {

namespace {

/// The properties of a scene that decide which attempts suit it.
struct Kind {
  bool sticks, has_loaded_members, has_meshes;
};

Kind kind_of(const Search& search) {
  Kind kind{};
  kind.sticks = search.remembers();
  kind.has_loaded_members = search.has_members() && search.load() > 0;
  kind.has_meshes = search.levels() > 1;
  return kind;
}

struct Row {
  Attempt attempt;
  bool (*suits)(const Kind& kind);
};

/// The attempts in their order, each with a test whether it suits a scene. The order was chosen on random
/// variants of the hard cases of tests/stability.
const Row kTable[] = {
    // The strategy auto itself solves the coarser mesh, starting from a still coarser mesh if there is one.
    // On the finer mesh, the strategy has to find out which members are slack. Newton's method does this
    // member by member, tension/only does it for all members at once.
    // If the coarser mesh leaves few members slack, Newton's method is quicker: in the panel of fig. 6a, with
    // 16 to 20 % slack, it takes 11 factorisations, with tension/only 36; in trawls, with 55 to 79 %, 25 to
    // 155 and 21 to 73.
    {{"coarse-to-fine", "coarse-to-fine", "by=auto:restarts=0,then=tension/only:least_slack=0.33",
      "a coarser mesh costs a fraction of the work and leads near the solution; the step to the fine mesh "
      "decides which members are slack"},
     [](const Kind& k) { return k.has_meshes && k.has_loaded_members; }},
    {{"coarse-to-fine", "coarse-to-fine", "by=auto:restarts=0",
      "a coarser mesh costs a fraction of the work and leads near the solution"},
     [](const Kind& k) { return k.has_meshes && !k.has_loaded_members; }},
    {{"tension-stages", "tension/stages", "",
      "with tensions as unknowns, stiff members can turn far in one step"},
     [](const Kind& k) { return k.has_loaded_members; }},
    // Relaxation takes more steps on a finer mesh and is therefore tried after the attempts above. For long
    // lines with 12 000 unknowns it took eight times as long as tension-stages.
    {{"relaxed", "relaxed", "", "elements change between sticking and sliding, which no tangent predicts"},
     [](const Kind& k) { return k.sticks; }},
    {{"direct", "direct", "", "the start may be near the solution"}, [](const Kind&) { return true; }},
    {{"stiffness-steps", "stiffness-steps", "",
      "soft members can turn farther in one step than stiff members"},
     [](const Kind&) { return true; }},
    {{"pseudo-time", "pseudo-time", "", "a damped motion does not end at an unstable equilibrium"},
     [](const Kind& k) { return !k.sticks; }},
};

/// The parts of the strategy that the user excludes by the option `without`, such as `without` =
/// "restarts+direct".
std::vector<std::string> left_out(const Options& options) {
  std::vector<std::string> names;
  std::istringstream parts(options.without);
  for (std::string name; std::getline(parts, name, '+');) names.push_back(name);
  return names;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::vector<const char*> parts() {
  std::vector<const char*> all{"restarts", "compensated"};
  for (const Row& row : kTable)
    if (std::string_view(row.attempt.name) != all.back()) all.push_back(row.attempt.name);
  return all;
}

bool is_left_out(const Options& options, const std::string& part) {
  return contains(left_out(options), part);
}

std::vector<Attempt> attempts_for(const Search& search, const Options& options) {
  const Kind kind = kind_of(search);
  std::vector<Attempt> attempts;
  for (const Row& row : kTable)
    if (row.suits(kind) && !is_left_out(options, row.attempt.name)) attempts.push_back(row.attempt);
  return attempts;
}

}  // namespace netloft::automatic
