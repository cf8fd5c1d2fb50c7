// SPDX-License-Identifier: BSD-3-Clause
#include "io/formats/hdf5/image.hpp"
#include "io/formats/text/csv.hpp"
#include "io/formats/text/printable.hpp"
#include "io/studies/sweep/study_table.hpp"

#include <cmath>
#include <limits>

namespace netloft::studies {

namespace {

std::string csv_heading(const std::string& name, const std::string& unit) {
  return formats::csv_field(unit.empty() || unit == "1" ? name : name + " [" + unit + "]");
}

std::string joined(const std::vector<std::string>& sentences) {
  std::string all;
  for (const auto& sentence : sentences) all += (all.empty() ? "" : "; ") + sentence;
  return all;
}

std::string value_field(const StudyColumn& column, const VariableValue& value) {
  return column.is_number && value.number ? formats::csv_number(*value.number)
                                          : formats::csv_field(value.text);
}

std::string row_csv(const StudyTable& table, const StudyRow& row) {
  std::string text =
      std::to_string(row.item) + "," + std::to_string(row.sample) + "," + std::to_string(row.point);
  for (std::size_t v = 0; v < row.values.size(); ++v)
    text += "," + value_field(table.columns[v], row.values[v]);
  const PointRecord& r = row.record;
  text += "," + formats::csv_field(r.status) + "," + formats::csv_field(r.stability) + "," +
          formats::csv_field(r.reason) + "," + formats::csv_field(r.start) + "," +
          formats::csv_field(joined(r.events)) + "," + std::to_string(r.iterations) + "," +
          std::to_string(r.factorisations);
  for (const double value : row.figures) text += "," + formats::csv_number(value);
  return text + "\n";
}

/// Writes columns of the table: one number or text for every row.
class Columns {
 public:
  Columns(formats::Tree& tree, const StudyTable& table) : tree_(tree), table_(table) {}

  template <class Take>
  void write_reals(const std::string& path, const std::string& unit, const std::string& doc,
                   const Take& take) {
    std::vector<double> values;
    for (const StudyRow& row : table_.rows) values.push_back(take(row));
    tree_.write_reals(path, values, unit, doc);
  }
  template <class Take>
  void write_ints(const std::string& path, const std::string& doc, const Take& take) {
    std::vector<std::int64_t> values;
    for (const StudyRow& row : table_.rows) values.push_back(static_cast<std::int64_t>(take(row)));
    tree_.write_ints(path, values, "1", doc);
  }
  template <class Take>
  void write_texts(const std::string& path, const std::string& doc, const Take& take) {
    std::vector<std::string> values;
    for (const StudyRow& row : table_.rows) values.push_back(formats::printable(take(row)));
    tree_.write_strings(path, values, doc);
  }

 private:
  formats::Tree& tree_;
  const StudyTable& table_;
};

void write_variables(Columns& columns, const StudyTable& table) {
  for (std::size_t v = 0; v < table.columns.size(); ++v) {
    const StudyColumn& c = table.columns[v];
    const std::string path = "/study/variables/" + c.variable.name;
    if (c.is_number)
      columns.write_reals(path, c.variable.unit.empty() ? "1" : c.variable.unit, "value of the variable",
                          [&](const StudyRow& row) {
                            return row.values[v].number.value_or(std::numeric_limits<double>::quiet_NaN());
                          });
    else
      columns.write_texts(path, "value of the variable",
                          [&](const StudyRow& row) { return row.values[v].text; });
  }
}

void write_outcomes(Columns& columns) {
  columns.write_texts("/study/status", "how the search for an equilibrium ended",
                      [](const StudyRow& row) { return row.record.status; });
  columns.write_texts("/study/stability", "whether small disturbances of the equilibrium grow",
                      [](const StudyRow& row) { return row.record.stability; });
  columns.write_texts("/study/reason", "a sentence about it",
                      [](const StudyRow& row) { return row.record.reason; });
  columns.write_texts("/study/start", "continued from the point before, or found anew",
                      [](const StudyRow& row) { return row.record.start; });
  columns.write_texts("/study/events", "folds and jumps on the way from the point before",
                      [](const StudyRow& row) { return joined(row.record.events); });
  columns.write_ints("/study/cost/iterations", "accepted steps",
                     [](const StudyRow& r) { return r.record.iterations; });
  columns.write_ints("/study/cost/factorisations", "factorisations, refused ones included",
                     [](const StudyRow& r) { return r.record.factorisations; });
  columns.write_reals("/study/cost/work", "1", "in Newton iterations of the scene as it is written",
                      [](const StudyRow& row) { return row.record.work; });
}

}  // namespace

std::string study_csv(const StudyTable& table) {
  std::string text = "item,sample,point";
  for (const StudyColumn& c : table.columns) text += "," + csv_heading(c.variable.name, c.variable.unit);
  text += ",status,stability,reason,start,events,iterations,factorisations";
  for (const StudyFigure& f : table.figures) text += "," + csv_heading(f.name, f.unit);
  text += "\n";
  for (const StudyRow& row : table.rows) text += row_csv(table, row);
  return text;
}

std::string study_hdf5(const Study& study, const StudyTable& table) {
  return formats::hdf5_image([&](formats::Tree& tree) {
    tree.set_attribute("/study", "format", 1);
    tree.set_attribute("/study", "name", std::string_view(study.name));
    tree.set_attribute("/study", "scene", std::string_view(study.scene));
    Columns columns(tree, table);
    columns.write_ints("/study/item", "item of the manifest, from 1",
                       [](const StudyRow& r) { return r.item; });
    columns.write_ints("/study/sample", "sample, from 1; 0: nothing was sampled",
                       [](const StudyRow& r) { return r.sample; });
    columns.write_ints("/study/point", "point of the item, from 1",
                       [](const StudyRow& r) { return r.point; });
    write_variables(columns, table);
    write_outcomes(columns);
    for (std::size_t f = 0; f < table.figures.size(); ++f)
      columns.write_reals("/study/figures/" + table.figures[f].name, table.figures[f].unit, "",
                          [&](const StudyRow& row) { return row.figures[f]; });
  });
}

std::string costs_csv(const Study& study, const std::filesystem::path& folder) {
  std::string text = "item,wall [s],cpu [s],host,started,program\n", unused;
  for (const StudyItem& item : study.items)
    if (const auto record = find_record(folder, item, unused))
      text += std::to_string(item.id) + "," + formats::csv_number(record->cost.wall_seconds) + "," +
              formats::csv_number(record->cost.cpu_seconds) + "," + formats::csv_field(record->cost.host) +
              "," + formats::csv_field(record->cost.started) + "," + formats::csv_field(record->program) +
              "\n";
  return text;
}

}  // namespace netloft::studies
