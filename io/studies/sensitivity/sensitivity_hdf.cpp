// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sensitivity/sensitivity.hpp"

#include "io/formats/hdf5/image.hpp"

#include <algorithm>
#include <string>

namespace netloft::studies {

namespace {

const std::string kGroup = "/netloft/sensitivities/";

/// One column of a table.
template <class Row, class Of>
auto column_of(const std::vector<Row>& rows, const Of& of) {
  std::vector<std::decay_t<decltype(of(rows.front()))>> column;
  for (const Row& row : rows) column.push_back(of(row));
  return column;
}

void write_figures(formats::Tree& tree, const Sensitivities& found, const std::vector<std::size_t>& figures) {
  const auto column = [&](const auto& of) { return column_of(figures, of); };
  tree.write_strings(kGroup + "figures/name", column([&](std::size_t f) { return found.figures[f].name; }));
  tree.write_strings(kGroup + "figures/unit", column([&](std::size_t f) { return found.figures[f].unit; }));
  tree.write_reals(kGroup + "figures/value", column([&](std::size_t f) { return found.figures[f].value; }),
                   "figures/unit");
  tree.write_reals(kGroup + "figures/deviation",
                   column([&](std::size_t f) { return propagated_deviation(found, f); }), "figures/unit",
                   "standard deviation due to those of the numbers; 0: none is known");
}

void write_numbers(formats::Tree& tree, const std::vector<NumberEffect>& effects) {
  const auto column = [&](const auto& of) { return column_of(effects, of); };
  using Effect = const NumberEffect&;
  tree.write_strings(kGroup + "numbers/path", column([](Effect e) { return e.number.path; }));
  tree.write_strings(kGroup + "numbers/unit", column([](Effect e) { return e.number.unit; }));
  tree.write_reals(kGroup + "numbers/value", column([](Effect e) { return e.number.value; }), "numbers/unit");
  tree.write_reals(kGroup + "numbers/deviation", column([](Effect e) { return e.number.deviation; }),
                   "numbers/unit", "standard deviation; 0: not known");
  tree.write_strings(kGroup + "numbers/why_not", column([](Effect e) { return e.why_not; }),
                     "why there are no derivatives; empty: there are");
  tree.write_reals(kGroup + "numbers/fold_at", column([](Effect e) { return e.fold_at; }), "numbers/unit",
                   "value near which the equilibrium ends in a fold; NaN: not within a typical change");
  const auto count = [](const std::map<std::string, std::size_t>& by_part) {
    std::int64_t sum = 0;
    for (const auto& [part, number] : by_part) sum += static_cast<std::int64_t>(number);
    return sum;
  };
  tree.write_ints(kGroup + "numbers/switching_members",
                  column([&](Effect e) { return count(e.switches.members); }), "1",
                  "bars and twines that a typical change makes taut or slack, to first order");
  tree.write_ints(kGroup + "numbers/switching_nodes",
                  column([&](Effect e) { return count(e.switches.nodes); }), "1",
                  "nodes that touch or leave the ground by a typical change, to first order");
}

/// Writes a matrix with a row for each figure and a column for each number; NaN if there is no derivative.
template <class Of>
void write_table(formats::Tree& tree, const std::string& name, const std::vector<std::size_t>& figures,
                 const std::vector<NumberEffect>& effects, const std::string& unit, const std::string& doc,
                 const Of& of) {
  if (effects.empty()) return;
  std::vector<double> values;
  for (const std::size_t f : figures)
    for (const NumberEffect& effect : effects)
      values.push_back(effect.why_not.empty() ? of(effect, f) : results::NamedScalar::kUnknown);
  tree.write_matrix(kGroup + name, values, effects.size(), unit, doc);
}

void write_sides(formats::Tree& tree, const SwitchSides& sides) {
  const auto write = [&](const char* name, std::size_t count, const char* doc) {
    tree.write_int(kGroup + "frozen/" + name, static_cast<std::int64_t>(count), "1", doc);
  };
  write("members", sides.members, "bars and twines");
  write("slack", sides.slack, "those of them that are slack, in all derivatives");
  write("ground_nodes", sides.nodes, "nodes that may touch the ground");
  write("touching", sides.touching, "those of them that touch it, in all derivatives");
}

}  // namespace

std::string sensitivity_hdf(const Sensitivities& found, const std::vector<std::size_t>& figures,
                            const std::string& status) {
  return formats::hdf5_image([&](formats::Tree& tree) {
    tree.write_text(kGroup + "status", status, "outcome of the equilibrium");
    write_sides(tree, found.sides);
    write_figures(tree, found, figures);
    write_numbers(tree, found.effects);
    write_table(tree, "derivatives", figures, found.effects, "figures/unit per numbers/unit",
                "rows: figures, columns: numbers",
                [](const NumberEffect& effect, std::size_t f) { return effect.per_unit[f]; });
    const bool is_checked = std::ranges::any_of(
        found.effects, [](const NumberEffect& effect) { return !effect.by_long_step.empty(); });
    if (is_checked)
      write_table(tree, "depends_on_step", figures, found.effects, "1", "1: the derivative does",
                  [&](const NumberEffect& effect, std::size_t f) {
                    return depends_on_step(found, effect, f) ? 1.0 : 0.0;
                  });
  });
}

}  // namespace netloft::studies
