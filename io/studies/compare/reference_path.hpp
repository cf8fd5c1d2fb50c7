// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/compare/reference.hpp"

namespace netloft::studies {

/// The paths that errors of motions are measured against: of an integrator of another plugin than the method
/// under test, a decade finer than the tightest accuracy that is compared, or as fine as that where it is
/// lost there. How far two such paths of different integrators are apart is said with them. Methods that
/// leave the damping of materials out are held against paths without it.
class ReferencePaths {
 public:
  /// `wanted`: the only integrator asked; empty: the most trusted that there are.
  ReferencePaths(const runs::CaseSource& source, Registry& registry, std::string wanted, double tightest,
                 const runs::Watch& watch)
      : source_(source),
        registry_(registry),
        wanted_(std::move(wanted)),
        tightest_(tightest),
        watch_(watch) {}

  /// Returns nothing if all of them lose the motion.
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

/// The largest distance of a node between two paths at equal outputs [m]; infinite where they have not the
/// same outputs.
double path_distance(const Scene& scene, const Numbering& numbering,
                     const std::vector<std::vector<double>>& a, const std::vector<std::vector<double>>& b);

}  // namespace netloft::studies
