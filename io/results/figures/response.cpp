// SPDX-License-Identifier: BSD-3-Clause
#include "io/results/figures/response.hpp"

#include "framework/assembler/reports.hpp"

#include <algorithm>

namespace netloft::results {

namespace {

void add_forces(const Scene& scene, Assembler& assembler, std::size_t f, const Kinematics& motion,
                Response& answer) {
  const ElementFamily& family = *assembler.families()[f];
  std::vector<double> sums(3 * family.parts().size());
  for (std::size_t t = 0; t < family.active_terms().size(); ++t) {
    const netloft_term& term = family.active_terms()[t];
    if ((term.traits & NETLOFT_OF_MEMBERS) || !assembler.reports().sum_term(answer.x, f, t, sums, motion))
      continue;
    for (std::size_t p = 0; p < family.parts().size(); ++p)
      answer.forces.push_back({scene.parts[family.parts()[p]].name,
                               term.name,
                               {0.0 - sums[3 * p], 0.0 - sums[3 * p + 1], 0.0 - sums[3 * p + 2]},
                               term.traits});
  }
}

void add_drag_in_flow(Assembler& assembler, std::size_t f, const Kinematics& motion, Response& answer) {
  const ElementFamily& family = *assembler.families()[f];
  if (!family.repeated()) return;
  answer.drag_in_flow.resize(answer.x.size());
  std::vector<double> residual(answer.x.size());
  for (std::size_t t = 0; t < family.active_terms().size(); ++t)
    if (assembler.reports().evaluate_term(answer.x, f, t, residual, motion))
      for (std::size_t i = 0; i < residual.size(); ++i) answer.drag_in_flow[i] -= residual[i];
}

/// The index of the body of each node of the scene; -1 for nodes that do not belong to a body.
std::vector<std::int32_t> bodies_by_node(const Scene& scene) {
  std::vector<std::int32_t> bodies(scene.node_count(), -1);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    bodies[scene.bodies[b].origin] = static_cast<std::int32_t>(b);
    for (const auto& point : scene.bodies[b].points) bodies[point.node] = static_cast<std::int32_t>(b);
  }
  return bodies;
}

/// For each pair of a part of the family and a body: whether an element of the part has a node on the body.
std::vector<char> reached_bodies(const ElementFamily& family, std::span<const std::int32_t> body_of,
                                 std::size_t bodies) {
  std::vector<char> reached(bodies * family.parts().size());
  for (std::size_t p = 0; p < family.parts().size(); ++p)
    for (std::size_t e = family.part_begin()[p]; e < family.part_begin()[p + 1]; ++e)
      for (int n = 0; n < family.nodes_per_element(); ++n)
        if (const std::uint32_t node = family.node(e, n); node < body_of.size() && body_of[node] >= 0)
          reached[p * bodies + static_cast<std::size_t>(body_of[node])] = 1;
  return reached;
}

/// Adds the forces of family f on bodies. Forces that are zero at present are included, so that every output
/// of a motion has a value.
void add_body_forces(const Scene& scene, Assembler& assembler, std::size_t f, const Kinematics& motion,
                     Response& answer) {
  if (scene.bodies.empty()) return;
  const ElementFamily& family = *assembler.families()[f];
  const auto groups = bodies_by_node(scene);
  const std::size_t bodies = scene.bodies.size();
  const auto reached = reached_bodies(family, groups, bodies);
  if (std::ranges::find(reached, 1) == reached.end()) return;
  std::vector<double> sums(3 * bodies * family.parts().size());
  for (std::size_t t = 0; t < family.active_terms().size(); ++t) {
    if (!assembler.reports().sum_term_at(answer.x, f, t, groups, bodies, sums, motion)) continue;
    for (std::size_t k = 0; k < sums.size() / 3; ++k) {
      const double* sum = &sums[3 * k];
      if (!reached[k]) continue;
      const std::uint32_t part = family.parts()[k / bodies];
      answer.body_forces.push_back({static_cast<std::uint32_t>(k % bodies),
                                    part,
                                    {scene.parts[part].name,
                                     family.active_terms()[t].name,
                                     {0.0 - sum[0], 0.0 - sum[1], 0.0 - sum[2]},
                                     family.active_terms()[t].traits}});
    }
  }
}

}  // namespace

Response ask_elements(const Scene& scene, Assembler& assembler, std::span<const double> x,
                      const Kinematics& motion, bool with_forces) {
  Response answer{{x.begin(), x.end()}, FamilyOutputs(assembler.families().size()), {}, {}, {}};
  for (std::size_t f = 0; f < answer.outputs.size(); ++f) {
    assembler.reports().outputs(x, f, answer.outputs[f], motion);
    if (!with_forces) continue;
    add_forces(scene, assembler, f, motion, answer);
    add_body_forces(scene, assembler, f, motion, answer);
    add_drag_in_flow(assembler, f, motion, answer);
  }
  return answer;
}

}  // namespace netloft::results
