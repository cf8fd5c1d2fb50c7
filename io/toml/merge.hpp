// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/toml/value.hpp"

namespace netloft::io {

/// Lays `over` upon `base`: tables merge key by key, `[[hold]]` appends to the tables there are, everything
/// else replaces. Each value keeps the place where it was written.
void merge(Value& base, Value over);

}  // namespace netloft::io
