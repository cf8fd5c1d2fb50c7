// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/assembler.hpp"
#include "framework/assembler/workspace.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

namespace netloft {

void Assembler::report(std::size_t family, const netloft_tile& t, int status, Workspace& w) {
  // The earliest element is reported, no matter which thread met it.
  const std::size_t element = t.first + std::min(t.lane_at_fault, t.count - 1);
  if (element >= w.fault_order) return;
  w.fault_order = element;
  w.fault.status = status;
  w.fault.family = family;
  w.fault.element = element;
  std::memcpy(w.fault.message, w.message, sizeof w.message);
}

bool Assembler::collect_faults() {
  Workspace* first = nullptr;
  for (auto& w : workspaces_)
    if (w->fault.status != NETLOFT_OK && (!first || w->fault_order < first->fault_order)) first = w.get();
  if (!first) return true;
  fault_ = first->fault;
  for (auto& w : workspaces_) {
    w->fault = {};
    w->message[0] = 0;
    w->fault_order = std::numeric_limits<std::size_t>::max();
  }
  return false;
}

std::string Assembler::node_name(const Scene& scene, std::uint32_t node) const {
  if (node < scene.node_count()) return scene.node_name(node);
  if (const std::size_t body = node - scene.node_count(); body < scene.bodies.size())
    return scene.bodies[body].name + " attitude";
  for (const auto& family : families_)
    for (std::size_t p = 0; p < family->global_nodes().size(); ++p)
      if (family->global_nodes()[p].node == node)
        return scene.parts[family->parts()[p]].name + " " + family->type().globals[0].name;
  return "no node";
}

std::string Assembler::fault_place(const Scene& scene) const {
  const ElementFamily& f = *families_[fault_.family];
  std::size_t first = 0;
  for (const std::size_t begin : f.part_begin())
    if (begin <= fault_.element) first = begin;
  return scene.parts[f.part(fault_.element)].name + " element " + std::to_string(fault_.element - first);
}

std::string Assembler::fault_sentence(const Scene& scene) const {
  return fault_place(scene) + " (" + families_[fault_.family]->type().type +
         "): " + (fault_.message[0] ? fault_.message : "no force at this state");
}

}  // namespace netloft
