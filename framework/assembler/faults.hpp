// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/family.hpp"

#include <limits>
#include <string>

namespace netloft {

/// The element that could not be evaluated, and the reason.
struct ElementFault {
  int status = NETLOFT_OK;  // NETLOFT_OUTSIDE_DOMAIN or NETLOFT_ERROR
  std::size_t family = 0, element = 0;
  char message[256] = "";
};

/// The name of the element at fault: "net element 17"
std::string place_of(const ElementFault& fault, const ElementFamily& family, const Scene& scene);
/// The fault as a sentence: "net element 17 (priour/triangle): it has no area"
std::string sentence_of(const ElementFault& fault, const ElementFamily& family, const Scene& scene);

/// Stores the fault with the lowest element number among the tiles of one thread. The caller reports the
/// lowest element number of all threads, which does not depend on the number of threads.
class FaultNote {
 public:
  /// Gives the tile memory for an error message.
  void begin(netloft_tile& tile);
  /// Stores the fault of a tile, unless the fault of an earlier element is stored.
  void keep(std::size_t family, const netloft_tile& tile, int status);
  void clear() { *this = {}; }

  bool is_set() const { return fault_.status != NETLOFT_OK; }
  bool is_before(const FaultNote& other) const { return order_ < other.order_; }
  const ElementFault& fault() const { return fault_; }

 private:
  char message_[sizeof ElementFault::message] = "";
  ElementFault fault_;
  std::size_t order_ = std::numeric_limits<std::size_t>::max();
};

}  // namespace netloft
