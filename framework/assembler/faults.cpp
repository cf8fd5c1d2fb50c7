// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/faults.hpp"

#include <algorithm>
#include <cstring>

namespace netloft {

void FaultNote::begin(netloft_tile& tile) {
  message_[0] = 0;
  tile.message = message_;
  tile.message_size = sizeof message_;
}

void FaultNote::keep(std::size_t family, const netloft_tile& tile, int status) {
  const std::size_t element = tile.first + std::min(tile.lane_at_fault, tile.count - 1);
  if (element >= order_) return;
  order_ = element;
  fault_.status = status;
  fault_.family = family;
  fault_.element = element;
  std::memcpy(fault_.message, message_, sizeof message_);
}

std::string place_of(const ElementFault& fault, const ElementFamily& family, const Scene& scene) {
  std::size_t first = 0;
  for (const std::size_t begin : family.part_begin())
    if (begin <= fault.element) first = begin;
  return scene.parts[family.part(fault.element)].name + " element " + std::to_string(fault.element - first);
}

std::string sentence_of(const ElementFault& fault, const ElementFamily& family, const Scene& scene) {
  return place_of(fault, family, scene) + " (" + family.type().type +
         "): " + (fault.message[0] ? fault.message : "no force at this state");
}

}  // namespace netloft
