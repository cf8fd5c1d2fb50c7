// SPDX-License-Identifier: BSD-3-Clause
// Net plans of all topologies, drawn from the input: each must be meshed without a fault, or refused.
#include "tests/fuzz/topology_trial.hpp"

#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace netloft;
  fuzz::Choices choices(data, size);
  const gears::Fineness fineness = fuzz::draw_fineness(choices);
  const std::string text = fuzz::TopologyDrawer(choices).draw();
  const auto trial = fuzz::try_topology(text, fineness);
  if (trial.faults.empty()) return 0;
  std::fprintf(stderr, "%s\n%s\n", text.c_str(), trial.faults.front().c_str());
  std::abort();
}
