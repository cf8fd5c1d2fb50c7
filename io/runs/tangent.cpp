// SPDX-License-Identifier: BSD-3-Clause
#include "io/runs/tangent.hpp"

#include "framework/judging/correction.hpp"

namespace netloft::runs {

bool have_same_topology(const PreparedScene& a, const PreparedScene& b) {
  return a.assembler().numbering().dofs() == b.assembler().numbering().dofs() &&
         a.assembler().pattern() == b.assembler().pattern();
}

std::optional<std::vector<double>> tangent_towards(PreparedScene& scene, PreparedScene& near,
                                                   const std::vector<double>& x, Statistics& spent) {
  if (scene.loaded().analysis.settles || !scene.loaded().scene.settings.empty()) return std::nullopt;
  StaticProblem here(scene.assembler(), scene.factorisations(), {}),
      there(near.assembler(), scene.factorisations(), {});
  const std::vector<double> u = scene.assembler().displacements_to(x),
                            v = near.assembler().displacements_to(x);
  std::vector<double> at, r, r_near, du(u.size());
  double energy = 0;
  if (!here.recompute(u, at, r, energy) || !there.recompute(v, at, r_near, energy)) return std::nullopt;
  for (std::size_t i = 0; i < r.size(); ++i) r_near[i] -= r[i];
  const bool is_found = find_correction(here, u, r_near, du);  // (1)
  spent.add(here.statistics());
  spent.add(there.statistics());
  if (!is_found) return std::nullopt;
  for (std::size_t i = 0; i < v.size(); ++i) du[i] += v[i];
  std::vector<double> dx = there.positions(du);
  for (std::size_t i = 0; i < x.size(); ++i) dx[i] -= x[i];
  return dx;
}

}  // namespace netloft::runs
