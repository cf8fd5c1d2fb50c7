// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/catalogue/catalogue.hpp"
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/recent.hpp"

#include <map>

namespace netloft::gears {

/// A part that was read from its table, and the messages about it.
template <class T>
struct TableRead {
  T part;
  std::vector<formats::Diagnostic> messages;
};

/// The last table of each part and its result, by the name of the part.
template <class T>
using TablesRead = std::map<std::string, Recent<formats::Value, const TableRead<T>>>;

/// A plan as an input of check_net() and rope_spans(). Two inputs are equal if all data that these functions
/// read are equal; materials, pieces, winches, the ship and positions of points may differ.
struct NetInput {
  explicit NetInput(const NetPlan& given) : plan(given) {}
  NetPlan plan;
  bool operator==(const NetPlan& other) const;
};

/// The messages of check_net() about a plan, and its rope spans, which are empty after an error.
struct NetCheck {
  std::vector<formats::Diagnostic> messages;
  std::vector<RopeSpan> spans;
};

/// Parts of a net plan, stored between readings of the plan, and the last checks of the net. Stored parts
/// depend on their tables and on the catalogue.
struct PlanMemory {
  std::shared_ptr<const Catalogue> catalogue;
  TablesRead<Panel> panels;
  TablesRead<Rope> ropes;
  Recent<NetInput, const NetCheck> checks{2};
};

}  // namespace netloft::gears
