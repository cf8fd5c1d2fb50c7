// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/sweep/study_table.hpp"

#include <optional>

namespace netloft::studies {

/// A request for figures at one place.
struct EstimateRequest {
  /// "speed=2.7 kn", or several with commas between them: a value for every variable with listed values, and
  /// for either all or none of the sampled variables.
  std::vector<std::string> at;
  std::vector<std::string> figures;  // empty: all except those of single parts
};

/// A number and the bound of its error.
struct WithError {
  double value = 0, error = 0;
};

/// A figure at the requested place.
struct EstimatedFigure {
  std::string name, unit;
  WithError value;                     // over samples: the median
  std::optional<WithError> low, high;  // over samples: the ends of the band in study_plots.hpp
  std::size_t points = 0;              // number of points used
  std::size_t samples = 0;             // number of samples used
  std::string why_not;                 // the reason if there is no estimate
};

/// A row of the table that is left out because it has no stable equilibrium.
struct LeftOutRow {
  std::size_t item = 0, point = 0;
  std::string status, reason;
};

/// Figures at a place between the points of a table.
struct StudyEstimate {
  std::vector<std::pair<std::string, std::string>> at;  // variables and their values
  std::size_t samples = 0;       // number of samples; 0: the estimate is not over samples
  bool is_extrapolated = false;  // true: the place is outside the points with an equilibrium
  std::vector<EstimatedFigure> figures;
  std::vector<LeftOutRow> left_out;
  std::vector<std::string> events;  // folds and jumps at the points around it
};

/// Estimates figures between the points of a table by kriging (solvers/fitting/kriging). If the request names
/// a listed value of a variable, only rows with this value count; along the other variables kriging
/// interpolates. The error of an estimate y is
///   max(2 s, Σ_v max_G |y_G − y_{−G}|, 10⁻⁹ |y|)                                                    (1)
/// s is the deviation of kriging; y_G are the figures of a group G of points, and y_{−G} their estimates from
/// all other points, where both are nearest to the place. For a listed variable v, the groups are its two
/// values nearest to the place, without its first and last; for the sampled variables together, the samples
/// nearest to the place, one more than there are such variables. Errors along variables are added, as for a
/// product of interpolations. 10⁻⁹ is the relative tolerance of solves.
///
/// Over samples, each sample is estimated at the place, y_d ± e_d, with the correlation lengths of the
/// medians at all points. The median and the ends of the band are quantiles Q of these estimates, so that
/// they are in order, with the error
///   max(Q(y + e) − Q(y), Q(y) − Q(y − e))                                                         (2)
/// which is the largest that errors within e_d can cause. A sample with fewer than three points along a
/// variable is left out.
///
/// Reports faults of the request to `diagnostics`, and then returns nothing: unknown or missing variables,
/// wrong units, places outside the values of a variable or between its only two. Throws StudyError with a
/// sentence if no selected point has a stable equilibrium.
std::optional<StudyEstimate> estimate(const StudyTable& table, const EstimateRequest& request,
                                      formats::Diagnostics& diagnostics);

/// Indices of figures in a table: the named ones, or without names all except those of single parts. Reports
/// unknown names to `diagnostics`.
std::vector<std::size_t> choose_figures(const StudyTable& table, const std::vector<std::string>& wanted,
                                        formats::Diagnostics& diagnostics);

/// The estimate as a text for people, and as one JSON object.
std::string estimate_text(const std::string& study, const StudyEstimate& estimate);
std::string estimate_json(const std::string& study, const StudyEstimate& estimate);

}  // namespace netloft::studies
