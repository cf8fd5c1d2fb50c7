// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include "io/studies/sweep/record.hpp"

namespace netloft::studies {

/// One row of the table: a point and its results.
struct StudyRow {
  // Numbers of the item, of its sample and of the point, from 1; sample 0: nothing was sampled.
  std::size_t item = 0, sample = 0, point = 0;
  std::vector<VariableValue> values;  // values of the variables, by column
  PointRecord record;                 // record of the point; "missing" as its status: the item is missing
  std::vector<double> figures;        // value of each figure of the table; NaN if the point does not have it
};

/// All points of a study with their results, in the order of the manifest.
struct StudyTable {
  std::vector<StudyColumn> columns;
  std::vector<StudyFigure> figures;  // names and units of the figures; `value` is not used
  std::vector<StudyRow> rows;
  // Sentences about items that are missing, damaged, or from several versions, and about points that are
  // locally unstable.
  std::vector<std::string> sentences;
  std::size_t missing_items = 0;
  std::map<std::string, std::size_t> count_by_status() const;
};

/// Reads the records of all items in the folder of a study. If the record of an item is missing or damaged,
/// its points become rows whose status says so.
StudyTable collect_table(const Study& study, const std::filesystem::path& folder);

/// The table as comma-separated values, a row for every point.
std::string study_csv(const StudyTable& table);

/// The table as an HDF5 file (STUDY.md). Equal tables give equal bytes.
std::string study_hdf5(const Study& study, const StudyTable& table);

/// Costs of the items and their machines as comma-separated values, a row for every item with a record.
std::string costs_csv(const Study& study, const std::filesystem::path& folder);

}  // namespace netloft::studies
