// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/report/run_result.hpp"

namespace netloft::io {

/// The figures of a gear as tables for people; empty if there are none. `is_half`: only one half of the gear
/// was modelled.
std::string gear_text(const std::vector<NamedScalar>& figures, bool is_half);

/// The errors of a number in the form "± 2.1e-12 ± 1.3e-02 (order 1.1)": that of the solver and, if
/// `with_mesh`, that of the mesh.
std::string errors_text(const NamedScalar& scalar, bool with_mesh);

}  // namespace netloft::io
