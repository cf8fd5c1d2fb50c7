// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/study_table.hpp"

#include "framework/judging/assessment.hpp"
#include "io/formats/files/whole_file.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace netloft::studies {

namespace {

/// The reason, recorded by a worker, why an item could not be computed; empty if there is none.
std::string failure_of(const std::filesystem::path& folder, const StudyItem& item) {
  try {
    const std::string text = formats::read_whole(failure_path(folder, item)).value_or("");
    return text.substr(0, text.find('\n'));
  } catch (const formats::ReadError& e) {
    return e.what();
  }
}

/// Collects the records of a study in a table. The member functions are the steps, in the order of execution.
class Collector {
 public:
  Collector(const Study& study, const std::filesystem::path& folder) : study_(study), folder_(folder) {
    table_.columns = study.columns;
  }

  StudyTable collect() {
    for (const StudyItem& item : study_.items) add_item(item);
    for (StudyRow& row : table_.rows) row.figures = sorted(row.record);
    if (programs_.size() > 1) say_versions();
    say_local();
    return std::move(table_);
  }

 private:
  void add_item(const StudyItem& item) {
    std::string fault;
    auto record = find_record(folder_, item, fault);
    if (record) ++programs_[record->program];
    if (!record) fault = why_missing(item, fault);
    for (std::size_t p = 0; p < item.points.size(); ++p) {
      StudyRow row{item.id, item.sample, p + 1, study_.values_of(item, item.points[p]), {}, {}};
      if (record)
        row.record = std::move(record->points[p]);
      else {
        row.record.status = "missing";
        row.record.reason = fault;
      }
      learn(row.record);
      table_.rows.push_back(std::move(row));
    }
  }

  std::string why_missing(const StudyItem& item, const std::string& fault) {
    ++table_.missing_items;
    const std::string failure = failure_of(folder_, item);
    const std::string why = !fault.empty() ? fault : !failure.empty() ? failure : "it has not been computed";
    table_.sentences.push_back("item " + std::to_string(item.id) + " is missing: " + why);
    return why;
  }

  void learn(const PointRecord& record) {
    for (const StudyFigure& figure : record.figures)
      if (places_.emplace(figure.name, table_.figures.size()).second)
        table_.figures.push_back({figure.name, figure.unit, std::numeric_limits<double>::quiet_NaN()});
  }

  std::vector<double> sorted(const PointRecord& record) const {
    std::vector<double> values(table_.figures.size(), std::numeric_limits<double>::quiet_NaN());
    for (const StudyFigure& figure : record.figures) values[places_.at(figure.name)] = figure.value;
    return values;
  }

  void say_versions() {
    std::string all;
    for (const auto& [program, items] : programs_)
      all += (all.empty() ? "" : ", ") + std::to_string(items) + " by " + program;
    table_.sentences.push_back("items were computed by several versions of Netloft: " + all);
  }

  void say_local() {
    const auto count = std::count_if(table_.rows.begin(), table_.rows.end(), [](const StudyRow& row) {
      return row.record.stability == name_of(Stability::local);
    });
    if (count > 0)
      table_.sentences.push_back("points at which a small part of the gear is unstable: " +
                                 std::to_string(count) + "; in the column `stability`, they are local");
  }

  const Study& study_;
  const std::filesystem::path& folder_;
  StudyTable table_;
  std::map<std::string, std::size_t> places_;    // indices of figures by name
  std::map<std::string, std::size_t> programs_;  // number of items by version of the program
};

}  // namespace

std::map<std::string, std::size_t> StudyTable::count_by_status() const {
  std::map<std::string, std::size_t> counts;
  for (const StudyRow& row : rows) ++counts[row.record.status];
  return counts;
}

StudyTable collect_table(const Study& study, const std::filesystem::path& folder) {
  return Collector(study, folder).collect();
}

}  // namespace netloft::studies
