// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/sweep/study_file.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace netloft::studies {

/// One solve of a study.
struct StudyPoint {
  std::vector<std::string> set;       // "path=value", beside those of the study and of the item
  std::vector<VariableValue> values;  // of the variables in the path
};

/// The unit of work: a path of points that are solved one after the other, each from the one before. Items
/// know nothing of one another.
struct StudyItem {
  std::size_t id = 0;                 // from 1
  std::size_t sample = 0;             // from 1; 0: nothing is sampled
  std::vector<std::string> set;       // of all its points
  std::vector<VariableValue> values;  // of the variables that are not in the path
  std::vector<StudyPoint> points;
  std::string hash;  // of all that its results follow from
};

/// A variable as a column of tables.
struct StudyColumn {
  Variable variable;  // its name, unit and keys
  bool is_number = true, is_in_path = false, is_sampled = false;
};

/// A study that has been planned: what its manifest says, and all that workers need.
struct Study {
  std::string name;
  std::string scene;                 // path, from the folder of the study
  std::vector<std::string> set;      // of all points
  std::vector<std::string> figures;  // that are kept; empty: all
  std::vector<StudyColumn> columns;  // those in the path last
  std::string sampling;              // how samples were made; empty: nothing is sampled
  std::uint64_t seed = 0;
  std::vector<std::pair<std::string, std::string>>
      files;  // path and hash of all that the scenes are read from
  std::vector<StudyItem> items;

  std::size_t point_count() const;
  /// The values of one point, in the order of the columns.
  std::vector<VariableValue> values_of(const StudyItem& item, const StudyPoint& point) const;
};

/// The largest number of points that a study may have.
inline constexpr double kMostPoints = 1e7;

/// Number of points of a design, before there is any.
double count_points(const StudyFile& file);

/// Combines all values of a design: one item for each sample and each combination of listed values that are
/// not in the path, in the order of the file, samples fastest. A path goes to and fro, so that from one point
/// to the next one variable changes by one value. `files` are those that the scene is read from.
Study make_study(const StudyFile& file, const std::string& scene,
                 std::vector<std::pair<std::string, std::string>> files);

/// The hash of an item (fnv1a64): of the files, of the figures that are kept, of all that is set.
std::string hash_of(const Study& study, const StudyItem& item);

}  // namespace netloft::studies
