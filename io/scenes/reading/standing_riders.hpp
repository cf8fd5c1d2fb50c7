// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/draft.hpp"

namespace netloft::scenes {

/// Lets a part of elements of `type` stand on what `on` names, as nodes or as elements of its kind, and gives
/// it the data that it needs. Nodes of the scene are numbered.
void stand_on_others(const ElementType& type, formats::TableReader& table, Draft& draft, Part& rider);

}  // namespace netloft::scenes
