// SPDX-License-Identifier: BSD-3-Clause
#include "io/report/answer.hpp"

namespace netloft::io {

namespace {

void add_forces(const Scene& scene, Assembler& assembler, std::size_t f, const Kinematics& motion,
                Answer& answer) {
  const ElementFamily& family = *assembler.families()[f];
  std::vector<double> sums(3 * family.parts().size());
  for (std::size_t t = 0; t < family.active_terms().size(); ++t) {
    if (!assembler.sum_term(answer.x, f, t, sums, motion)) continue;
    for (std::size_t p = 0; p < family.parts().size(); ++p)
      answer.forces.push_back({scene.parts[family.parts()[p]].name,
                               family.active_terms()[t].name,
                               {0.0 - sums[3 * p], 0.0 - sums[3 * p + 1], 0.0 - sums[3 * p + 2]},
                               family.active_terms()[t].traits});
  }
}

}  // namespace

Answer ask_elements(const Scene& scene, Assembler& assembler, std::span<const double> x,
                    const Kinematics& motion) {
  Answer answer{{x.begin(), x.end()}, FamilyOutputs(assembler.families().size()), {}};
  for (std::size_t f = 0; f < answer.outputs.size(); ++f) {
    assembler.outputs(x, f, answer.outputs[f], motion);
    add_forces(scene, assembler, f, motion, answer);
  }
  return answer;
}

}  // namespace netloft::io
