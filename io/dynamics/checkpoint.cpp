// SPDX-License-Identifier: BSD-3-Clause
#include "io/dynamics/checkpoint.hpp"

namespace netloft::io {

namespace {
const std::string kAt = "/netloft/checkpoint/";
}

void write_checkpoint(Tree& tree, const MarchState& s, const std::string& scene) {
  tree.write_reals(kAt + "time", std::vector<double>{s.t, s.h}, "s", "time reached, and the next step");
  tree.write_reals(kAt + "u", s.u, "m", "displacements of the unknowns");
  tree.write_reals(kAt + "v", s.v, "m/s", "velocities of the unknowns");
  tree.write_reals(kAt + "a", s.a, "m/s2", "accelerations, as the integrator left them");
  tree.write_reals(kAt + "memory", s.memory, "1", "state of the elements");
  tree.write_reals(kAt + "budget", s.budget, "J", "sums of the energy budget");
  tree.write_reals(kAt + "judged", s.judged, "J", "sums of the check that no energy is created");
  tree.write_real(kAt + "load", s.least_load, "N", "least load to which tolerances are relative");
  tree.write_ints(kAt + "counts",
                  std::vector<std::int64_t>{static_cast<std::int64_t>(s.outputs), s.steps, s.rejected}, "1",
                  "outputs, steps, steps rejected");
  tree.write_text(kAt + "scene", scene);
}

MarchState read_checkpoint(const Reader& reader, const std::string& scene) {
  if (!reader.has(kAt + "time") || !reader.has(kAt + "scene"))
    throw FileError("the file has no output from which to continue");
  if (reader.text(kAt + "scene") != scene)
    throw FileError("the file belongs to another scene, or to another command line");
  const auto time = reader.reals(kAt + "time");
  const auto counts = reader.integers(kAt + "counts");
  MarchState s;
  s.t = time.at(0), s.h = time.at(1);
  s.u = reader.reals(kAt + "u"), s.v = reader.reals(kAt + "v"), s.a = reader.reals(kAt + "a");
  s.memory = reader.reals(kAt + "memory"), s.budget = reader.reals(kAt + "budget");
  s.judged = reader.reals(kAt + "judged");
  s.least_load = reader.real(kAt + "load");
  s.outputs = static_cast<std::size_t>(counts.at(0)), s.steps = counts.at(1), s.rejected = counts.at(2);
  return s;
}

}  // namespace netloft::io
