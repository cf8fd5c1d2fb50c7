// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/compare/reference_path.hpp"

#include "framework/judging/correction.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace netloft::studies {

namespace {

// Accuracies to try for a reference, as factors on the tightest accuracy in the comparison.
constexpr std::array<double, 2> kFiner{0.1, 1};
// Integrators, the most trusted first: it fails on the fewest hard motions (tests/bench/motions).
constexpr std::array<const char*, 3> kTrustedIntegrators{
    "integrator energy-momentum", "integrator generalized-alpha", "integrator newmark"};

}  // namespace

double path_distance(const Scene& scene, const Numbering& numbering,
                     const std::vector<std::vector<double>>& a, const std::vector<std::vector<double>>& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = std::max(largest, largest_node_distance(scene, numbering, a[i], b[i]));
  return largest;
}

const std::optional<ReferenceAnswer>& ReferencePaths::path_of(const Method& method, bool is_damped) {
  const std::pair<std::string, bool> key{method.specification, is_damped};
  const auto [known, is_new] = found_.try_emplace(key);
  if (!is_new) return known->second;
  runs::CaseSource source = source_;
  if (!is_damped)
    source.changes.push_back(formats::make_change({"analysis", "material_damping"}, {{}, false}));
  for (const double finer : kFiner) {
    Trial trial = run_trial(source, registry_, method, finer * tightest_, 1, watch_);
    if (!trial.converged()) continue;
    known->second = ReferenceAnswer{method, true, trial.tolerance, Stability::unknown, {}};
    known->second->answer.uncertainty = std::numeric_limits<double>::quiet_NaN();
    known->second->path = std::move(trial.path);
    known->second->is_damped = trial.is_damped;
    break;
  }
  return known->second;
}

std::optional<ReferenceAnswer> ReferencePaths::find_for(const Method& method, bool is_damped) {
  std::vector<Method> candidates;
  for (const bool own_plugin : {false, true})
    for (const char* trusted : kTrustedIntegrators)
      if (const Method other{trusted}; (plugin_of(other) == plugin_of(method)) == own_plugin)
        candidates.push_back(other);
  if (!wanted_.empty()) candidates.assign(1, Method{"integrator " + wanted_});
  std::optional<ReferenceAnswer> reference;
  for (const Method& other : candidates) {
    const auto& found = path_of(other, is_damped);
    if (!found || found->is_damped != is_damped) continue;
    if (reference && plugin_of(other) != plugin_of(reference->method)) {
      runs::PreparedScene own(source_, registry_);
      own.prepare();
      reference->answer.uncertainty =
          path_distance(own.loaded().scene, own.assembler().numbering(), reference->path, found->path);
      break;
    }
    if (!reference) {
      reference = found;
      reference->independent = plugin_of(other) != plugin_of(method);
    }
  }
  return reference;
}

}  // namespace netloft::studies
