// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/toml/table_reader.hpp"
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/names.hpp"
#include "io/gears/plan/proposals.hpp"

#include <fmt/format.h>

#include <cmath>

namespace netloft::gears {

namespace {

/// A number in the table of a piece; 0 if it is not given.
double number_of(const Pieces& pieces, const char* key, const char* unit) {
  const formats::Table* table = pieces.piece.as<formats::Table>();
  if (!table || !table->find(key)) return 0;
  formats::Diagnostics silent;
  const double value = formats::TableReader(pieces.piece, silent)
                           .real(key, {.unit = unit, .range = formats::between(-1e12, 1e12)});
  return silent.errors() ? 0 : value;
}

/// Whether pieces are floats, which lie side by side along a rope. Other pieces are discs threaded on the
/// rope, which are wider than long.
bool is_float(const Pieces& pieces) { return number_of(pieces, "buoyancy", "N") > 0; }

/// Proposes another number of pieces, a multiple of `step`.
Cures cures_of_number(const Pieces& pieces, const std::string& path, double number, int step) {
  const double whole = step * std::floor(number / step);
  if (whole <= 0) return {};
  if (pieces.has_number) return {set(path, {{}, whole})};
  const bool is_along = !pieces.along.empty();
  return {set(path, as_text(fmt::format("{:g} {} {}", whole, is_along ? "along" : "at",
                                        is_along ? pieces.along : pieces.at)))};
}

void check_count(const Pieces& pieces, const std::string& path, bool is_on_both_sides,
                 formats::Diagnostics& diagnostics) {
  const int step = is_on_both_sides ? 2 : 1;
  if (pieces.number != std::round(pieces.number) && pieces.has_number)
    diagnostics.warning(pieces.spread_place,
                        fmt::format("{}: {:g} pieces can be computed but not rigged", path, pieces.number),
                        "", cures_of_number(pieces, path, pieces.number + step / 2.0, step));
  else if (pieces.number != std::round(pieces.number))
    diagnostics.error(pieces.spread_place,
                      fmt::format("{}: {:g} pieces, which is not a whole number", path, pieces.number),
                      "give pieces of another size a table of their own in [floats]",
                      cures_of_number(pieces, path, pieces.number + step / 2.0, step));
  else if (is_on_both_sides && std::fmod(pieces.number, 2) != 0 && diagnostics.errors() == 0)
    diagnostics.warning(pieces.spread_place,
                        fmt::format("{}: {:g} pieces on both sides together, {:g} on each side", path,
                                    pieces.number, pieces.number / 2),
                        "the number is that of the whole gear, to port and to starboard",
                        cures_of_number(pieces, path, pieces.number + 1, step));
}

/// Reports floats that do not fit on a rope: a warning if they do not fit in a row, an error if not even in
/// bunches.
void check_room(const Pieces& pieces, const std::string& path, double length, bool is_on_both_sides,
                const CheckLimits& limits, formats::Diagnostics& diagnostics) {
  const double diameter = number_of(pieces, "diameter", "m"), row = pieces.number * diameter;
  if (!is_float(pieces) || length <= 0 || row <= length) return;
  const std::string said =
      fmt::format("{}: {:g} floats of {} m side by side are {} m long, but {} is only {} m", path,
                  pieces.number, in_metres(diameter), in_metres(row), pieces.along, in_metres(length));
  const std::string cure = "more floats do not lie in a row there";
  const Cures cures = cures_of_number(pieces, path, length / diameter, is_on_both_sides ? 2 : 1);
  if (row > limits.crowded * length)
    diagnostics.error(pieces.spread_place, said, cure, cures);
  else
    diagnostics.warning(pieces.spread_place, said, cure, cures);
}

/// The total length in the whole gear along which pieces are spread [m]; 0 after an error.
double length_along(const NetPlan& plan, const Pieces& pieces, formats::Diagnostics& diagnostics,
                    const std::string& path) {
  if (pieces.is_along_edge()) {
    const EdgeSet edge = find_edge(plan, pieces.along, pieces.spread_place, path, diagnostics);
    return edge.times() * edge.stretched();
  }
  const Rope* rope = find_rope_or_say(plan, pieces.along, pieces.spread_place, path, diagnostics);
  return rope ? (rope->stands == Standing::pair ? 2 : 1) * rope->length : 0;
}

bool is_on_both_sides(const NetPlan& plan, const Pieces& pieces) {
  if (pieces.along.empty()) return standing_of_point(plan, pieces.at) == Standing::pair;
  if (!pieces.is_along_edge()) return standing_of(plan, pieces.along) == Standing::pair;
  formats::Diagnostics silent;
  return find_edge(plan, pieces.along, {}, "", silent).times() == 2;
}

}  // namespace

void check_pieces(const NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics) {
  for (const auto& pieces : plan.pieces) {
    const std::string path = path_of({"floats", pieces.name, pieces.has_number ? "number" : "spread"});
    const int errors_before = diagnostics.errors();
    double length = 0;
    if (pieces.along.empty())
      find_point_owner(plan, pieces.at, pieces.spread_place, path, diagnostics);
    else
      length = length_along(plan, pieces, diagnostics, path);
    if (diagnostics.errors() > errors_before) continue;
    const bool is_twice = is_on_both_sides(plan, pieces);
    check_count(pieces, path, is_twice, diagnostics);
    check_room(pieces, path, length, is_twice, limits, diagnostics);
  }
}

}  // namespace netloft::gears
