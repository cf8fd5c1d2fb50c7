// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/sweep/study_table.hpp"

#include <optional>

namespace netloft::studies {

/// A request for estimates at one place in the space of the variables.
struct EstimateRequest {
  /// "speed=2.7 kn", or several with commas between them. Every variable with listed values needs a value,
  /// and either all sampled variables or none.
  std::vector<std::string> at;
  std::vector<std::string> figures;  // empty: all figures except those of single parts
};

/// A number and the bound of its error.
struct WithError {
  double value = 0, error = 0;
};

/// A figure at the requested place.
struct EstimatedFigure {
  std::string name, unit;
  WithError value;                     // an estimate over samples: the median
  std::optional<WithError> low, high;  // an estimate over samples: the ends of the band (study_plots.hpp)
  std::size_t points = 0;              // number of points used
  std::size_t samples = 0;             // number of samples used
  std::string why_not;                 // the reason if there is no estimate
};

/// A row of the table that is left out because it has no stable equilibrium.
struct LeftOutRow {
  std::size_t item = 0, point = 0;
  std::string status, reason;
};

/// Estimates of figures at a place between the points of a table.
struct StudyEstimate {
  std::vector<std::pair<std::string, std::string>> at;  // variables and their values
  std::size_t samples = 0;                              // number of samples; 0: not an estimate over samples
  bool is_extrapolated = false;  // true: the place is outside the points with an equilibrium
  std::vector<EstimatedFigure> figures;
  std::vector<LeftOutRow> left_out;
  std::vector<std::string> events;  // folds and jumps at the points around the place
};

/// Estimates figures between the points of a table by kriging, an interpolation with an error
/// (solvers/fitting/kriging). If the request gives a variable one of its listed values, only rows with this
/// value count; along the other variables kriging interpolates. The error of an estimate y is
///   max(2 s, Σ_v max_G |y_G − y_{−G}|, 10⁻⁹ |y|)                                                    (1)
/// s is the standard deviation that kriging gives, 10⁻⁹ the relative tolerance of solves. The second term is
/// cross validation. A group G of points is left out. The figures y_G at those points of G that are nearest
/// to the place are compared with their estimates y_{−G} from all points outside G. A listed variable v has
/// up to two groups: the points at each of its two values nearest to the place, without its first and last
/// value. All sampled variables together count as one v. Its groups are the samples nearest to the place, one
/// more than there are sampled variables. Errors along different variables are added.
///
/// If the request gives no sampled variable, the result is a distribution over the samples. Each sample d is
/// estimated at the place, y_d ± e_d, with the correlation lengths of the medians at all points. The median
/// and the ends of the band are quantiles Q of these estimates; their error is
///   max(Q(y + e) − Q(y), Q(y) − Q(y − e))                                                         (2)
/// This is the largest error that errors of the samples within e_d can cause. A sample with fewer than three
/// points along a variable is left out.
///
/// Faults of the request are reported to `diagnostics`; there is then no result. Faults are unknown or
/// missing variables, wrong units, and places that lie outside the values of a variable, or between its
/// values if it has only two. Throws StudyError with a sentence if no selected point has a stable
/// equilibrium.
std::optional<StudyEstimate> estimate(const StudyTable& table, const EstimateRequest& request,
                                      formats::Diagnostics& diagnostics);

/// The indices of the `wanted` figures in the table; if none are named, of all figures except those of single
/// parts. Reports unknown names to `diagnostics`.
std::vector<std::size_t> choose_figures(const StudyTable& table, const std::vector<std::string>& wanted,
                                        formats::Diagnostics& diagnostics);

/// The estimate as text, and as one JSON object.
std::string estimate_text(const std::string& study, const StudyEstimate& estimate);
std::string estimate_json(const std::string& study, const StudyEstimate& estimate);

}  // namespace netloft::studies
