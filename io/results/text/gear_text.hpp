// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/results/figures/run_result.hpp"

namespace netloft::results {

/// Whether figures are those of a net plan, beside those of rigid bodies, which come first.
bool are_of_plan(const std::vector<NamedScalar>& figures);

/// The figures of a gear as tables for people; empty if there are none. `is_half`: only one half of the gear
/// was modelled.
std::string gear_text(const std::vector<NamedScalar>& figures, bool is_half);

/// What a principal figure is called in a table, "headline height" for "mouth/headline_height"; empty: it is
/// none.
std::string principal_name(const std::string& figure);

/// The error of a number, of solver and mesh together; NaN unless both are known, because the error of the
/// mesh is by far the larger one as a rule.
double total_error(const NamedScalar& scalar);

/// The sentences of a note on meshes, each on a line of its own that is indented.
std::string mesh_note_text(std::string note);

/// That error as "± 1.3e-02", or "±?" where it is not known.
std::string error_text(const NamedScalar& scalar);

/// Both errors of a number in the form "± 2.1e-12 ± 1.3e-02 (order 1.1)": that of the solver and that of the
/// mesh.
std::string errors_text(const NamedScalar& scalar);

}  // namespace netloft::results
