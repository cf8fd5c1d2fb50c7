// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/text/csv.hpp"
#include "io/results/text/result_text.hpp"

#include <fmt/format.h>

namespace netloft::results {

using formats::csv_field, formats::csv_number;

std::string result_csv(const Result& result) {
  std::string text = "name,value,unit,solver_error,mesh_error,doc\n";
  for (const auto* group : {&result.scalars, &result.figures})
    for (const auto& f : *group)
      text += fmt::format("{},{},{},{},{},{}\n", csv_field(f.name), csv_number(f.value), csv_field(f.unit),
                          csv_number(f.solver_error), csv_number(f.mesh_error), csv_field(f.doc));
  for (const auto& h : result.hold_forces)
    for (std::size_t axis = 0; axis < 3; ++axis)
      text += fmt::format("{},{},N,,,force of the hold on the gear\n",
                          csv_field("held/" + h.name + "/" + "xyz"[axis]), csv_number(h.force[axis]));
  return text;
}

}  // namespace netloft::results
