// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/stability/suite/column.hpp"
#include "tests/stability/suite/start.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace netloft::hard_cases {

/// The right answer of a case. unique: there is one equilibrium, the reference. stable: the reference or
/// another stable equilibrium of no higher energy. none: there is no equilibrium, and the program has to
/// report that.
enum class Expected { unique, stable, none };

/// One hard case: a scene, the changes to it, and how its initial shape is disturbed.
struct HardCase {
  std::string name;   // "panel/noise-of-two-meshes"
  std::string about;  // a sentence
  std::filesystem::path scene;
  std::vector<std::string> overrides;                     // for all sizes
  std::map<std::string, std::vector<std::string>> sizes;  // "small" -> overrides
  std::vector<std::string> flow;  // values by which the net slows the water; empty without a net in a current
  std::vector<StartStep> start;
  Expected expected = Expected::stable;
  bool neutral = false;    // some motion meets no force, so only the energy is compared
  bool is_random = false;  // has no reference but the best equilibrium of the run
  std::string reference;   // name of the reference, which several cases may share
};

struct Suite {
  std::filesystem::path folder;
  std::vector<HardCase> cases;
  std::vector<Column> columns;
};

/// Sizes in the order they are run.
inline const std::vector<std::string> kSizes{"small", "medium", "large"};

/// Reads solvers.toml and every other TOML file of the folder. `number` is the seed of all random numbers of
/// random cases. The returned suite is valid only if there are no errors.
Suite read_suite(const std::filesystem::path& folder, std::uint64_t number,
                 formats::Diagnostics& diagnostics);

/// Leaves only the cases that have a flow, with it if `slowed`. No equilibrium in slowed water is known in
/// advance, so that such cases are judged as random ones are.
void keep_nets_in_current(Suite& suite, bool slowed);

const char* name_of(Expected expected);

}  // namespace netloft::hard_cases
