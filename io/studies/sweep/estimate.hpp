// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/sweep/study_table.hpp"

#include <optional>

namespace netloft::studies {

/// The place at which figures are estimated.
struct EstimateRequest {
  /// "speed=2.7 kn", or several with commas between: every variable with listed values, and of those that are
  /// sampled all or none.
  std::vector<std::string> at;
  std::vector<std::string> figures;  // empty: all but those of single parts
};

/// A number, and what it may be wrong by.
struct WithError {
  double value = 0, error = 0;
};

/// A figure at the place asked for.
struct EstimatedFigure {
  std::string name, unit;
  WithError value;                     // over samples: their median
  std::optional<WithError> low, high;  // over samples: the ends of the band of study_plots.hpp
  std::size_t points = 0;              // it follows from so many
  std::size_t samples = 0;             // over so many
  std::string why_not;                 // there is no estimate
};

/// A row of the table that would count if it had a stable equilibrium.
struct LeftOutRow {
  std::size_t item = 0, point = 0;
  std::string status, reason;
};

/// Figures at a place between the points of a table.
struct StudyEstimate {
  std::vector<std::pair<std::string, std::string>> at;  // variables and their values
  std::size_t samples = 0;                              // over so many; 0: one place
  bool is_extrapolated = false;                         // it lies beyond the points that have an equilibrium
  std::vector<EstimatedFigure> figures;
  std::vector<LeftOutRow> left_out;
  std::vector<std::string> events;  // folds and jumps at the points around it
};

/// Estimates figures between the points of a table by kriging (solvers/fitting/kriging). Of a variable that
/// is asked for at one of its listed values only rows with that value count; the others are asked for between
/// their values. The error of an estimate y is
///   max(2 s, Σ_v max_G |y_G − y_{−G}|, 10⁻⁹ |y|)                                                    (1)
/// s the deviation of kriging; y_G the figures of a level G of variable v, and y_{−G} what all other points
/// say of them, where they are nearest to the place. Levels are the two values of v that are nearest to the
/// place and neither its first nor its last; of the sampled variables together, the samples nearest to it,
/// one more than there are variables. Errors along variables add up, as those of a product of interpolations
/// do. 10⁻⁹ is what solves converge to.
///
/// Over samples, each sample is estimated at the place, y_d ± e_d, with the lengths of correlation of the
/// medians at all points; the median and the ends of the band are quantiles Q of these, so that they are in
/// order, with the error
///   max(Q(y + e) − Q(y), Q(y) − Q(y − e))                                                         (2)
/// which is as large as errors of e_d can make it. A sample with fewer than three points along a variable is
/// left out.
///
/// Faults of the request go to `diagnostics`, and there is no estimate then: variables that are
/// not there or are missing, wrong units, places beyond the values of a variable or between its only two.
/// Throws StudyError with a sentence if none of the points that would count has a stable equilibrium.
std::optional<StudyEstimate> estimate(const StudyTable& table, const EstimateRequest& request,
                                      formats::Diagnostics& diagnostics);

/// Places of figures in a table: those that are named, or without names all but those of single parts. Names
/// that are not there go to the diagnostics.
std::vector<std::size_t> choose_figures(const StudyTable& table, const std::vector<std::string>& wanted,
                                        formats::Diagnostics& diagnostics);

/// For people, and as one JSON object.
std::string estimate_text(const std::string& study, const StudyEstimate& estimate);
std::string estimate_json(const std::string& study, const StudyEstimate& estimate);

}  // namespace netloft::studies
