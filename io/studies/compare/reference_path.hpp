// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/compare/reference.hpp"

namespace netloft::studies {

/// The paths from which errors of motions are measured. Each path is computed by an integrator from another
/// plugin than the tested one. Its accuracy is ten times finer than the tightest accuracy in the comparison,
/// or equal to the tightest one if the motion fails at the finer one. The uncertainty of a path is its
/// distance from the path of a further integrator. Methods without damping of materials are compared with
/// paths without such damping.
class ReferencePaths {
 public:
  /// `wanted` is the integrator to use (empty: the most trusted installed one); `tightest` is the smallest
  /// accuracy in the comparison.
  ReferencePaths(const runs::CaseSource& source, Registry& registry, std::string wanted, double tightest,
                 const runs::Watch& watch)
      : source_(source),
        registry_(registry),
        wanted_(std::move(wanted)),
        tightest_(tightest),
        watch_(watch) {}

  /// The reference for a method; nullopt if the motion fails with every integrator. `is_damped`: whether the
  /// method includes the damping of materials.
  std::optional<ReferenceAnswer> find_for(const Method& method, bool is_damped);

 private:
  const std::optional<ReferenceAnswer>& path_of(const Method& method, bool is_damped);

  const runs::CaseSource& source_;
  Registry& registry_;
  std::string wanted_;
  double tightest_;
  const runs::Watch& watch_;
  std::map<std::pair<std::string, bool>, std::optional<ReferenceAnswer>> found_;
};

/// The largest distance of a node between corresponding outputs of two paths [m]; infinite if one path has
/// more outputs.
double path_distance(const Scene& scene, const Numbering& numbering,
                     const std::vector<std::vector<double>>& a, const std::vector<std::vector<double>>& b);

}  // namespace netloft::studies
