// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/catalogue/catalogue.hpp"
#include "io/gears/plan/net_plan.hpp"
#include "io/gears/plan/recent.hpp"

#include <map>

namespace netloft::gears {

/// A part that was read from its table, and the messages about it.
template <class T>
struct TableRead {
  T part;
  std::vector<formats::Diagnostic> messages;
};

/// The last table of each part, by the name of the part, and what was read from it.
template <class T>
using TablesRead = std::map<std::string, Recent<formats::Value, const TableRead<T>>>;

/// Parts of a net plan that are stored between readings of the plan. They depend on their tables and on the
/// catalogue.
struct PlanMemory {
  std::shared_ptr<const Catalogue> catalogue;
  TablesRead<Panel> panels;
  TablesRead<Rope> ropes;
};

}  // namespace netloft::gears
