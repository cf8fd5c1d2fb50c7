// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/sweep/study_file.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace netloft::studies {

/// A point of a study: values of the variables at which the scene is solved.
struct StudyPoint {
  std::vector<std::string> set;       // "path=value"; applied after `set` of the study and of the item
  std::vector<VariableValue> values;  // values of the variables in the path
};

/// The unit of work: a path of points that are solved one after another, each from the previous one. Items
/// are independent of one another.
struct StudyItem {
  std::size_t id = 0;                 // number of the item, from 1
  std::size_t sample = 0;             // number of the sample, from 1; 0 if nothing is sampled
  std::vector<std::string> set;       // overrides for all its points
  std::vector<VariableValue> values;  // values of the variables outside the path
  std::vector<StudyPoint> points;
  std::string hash;  // hash of all inputs that determine the item's results
};

/// A variable of the study, which is a column of its table.
struct StudyColumn {
  Variable variable;  // has the name, the unit and the keys
  bool is_number = true, is_in_path = false, is_sampled = false;
};

/// A planned study: the content of its manifest, and all that workers need.
struct Study {
  std::string name;
  std::string scene;                 // path relative to the folder of the study
  std::vector<std::string> set;      // overrides for all points
  std::vector<std::string> figures;  // figures to record; empty: all
  std::vector<StudyColumn> columns;  // variables in the path come last
  std::string sampling;              // how the samples were made; empty if nothing is sampled
  std::uint64_t seed = 0;
  std::vector<std::pair<std::string, std::string>> files;  // path and hash of all files of the scenes
  std::vector<StudyItem> items;

  std::size_t point_count() const;
  /// The values of one point, in the order of the columns.
  std::vector<VariableValue> values_of(const StudyItem& item, const StudyPoint& point) const;
};

/// The largest number of points that a study may have.
inline constexpr double kMostPoints = 1e7;

/// Number of points of a study file, counted without making them.
double count_points(const StudyFile& file);

/// Makes the items and points of a study by combining the values of the variables of its file. There is one
/// item for each combination of a sample and listed values outside the path, in the order of the file;
/// samples change fastest. The points of an item are the combinations of values in the path. From one point
/// to the next, only one variable changes, to a neighbouring value. `files` are the files of the scene.
Study make_study(const StudyFile& file, const std::string& scene,
                 std::vector<std::pair<std::string, std::string>> files);

/// The hash of an item (fnv1a64) over the files, the recorded figures and all overrides.
std::string hash_of(const Study& study, const StudyItem& item);

}  // namespace netloft::studies
