// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/svg/bar_chart.hpp"
#include "io/studies/sweep/sobol_indices.hpp"

namespace netloft::studies {

struct IndicesRequest {
  std::vector<std::string> at;       // held variables, such as "speed=3 kn"
  std::vector<std::string> figures;  // empty: all figures except those of single parts
};

/// A variable for which indices are found, and its range.
struct VariedVariable {
  std::string name, unit;
  double from = 0, to = 0;
  bool is_sampled = false;
};

struct FigureIndices {
  std::string name, unit;
  double mean = 0, deviation = 0;  // mean and deviation over the variables' space
  double off = 0;          // root mean square error of the response at left-out points, over deviation
  std::size_t points = 0;  // number of points used
  std::vector<SobolIndex> variables;  // indices in the order of StudyIndices::variables
  std::string why_not;                // the reason if there are no indices
};

/// How strongly the figures of a study depend on each of its variables.
struct StudyIndices {
  std::vector<std::pair<std::string, std::string>> held;  // variables and their values
  std::vector<VariedVariable> variables;
  double beyond = 0;         // fraction of the variables' space that is outside the region of the points
  std::size_t left_out = 0;  // points without a stable equilibrium
  std::vector<FigureIndices> figures;
};

/// Computes Sobol's indices (sobol_indices.hpp): the fraction of a figure's variance that each variable of a
/// table causes. The figure as a function of the variables is called the response; kriging interpolates it
/// between the points. Variables are independent: listed ones are uniform from the first to the last value,
/// sampled ones are distributed as their samples. The error of an index S is the root of the sum of squares
/// of two parts. One part is the error of sobol_indices(), the other is the error of the response,
///   2 ((k − 1)/k Σ_g (S_g − S)²)^½ + Σ_v max_l |S_l − S|                                    (1)
/// S_g are the indices without one of k ≤ 10 groups of samples. S_l are the indices without the points at a
/// value l of the listed variable v, which is neither its first nor its last value.
///
/// Faults of the request are reported to `diagnostics`; there is then no result. Faults are unknown figures
/// and variables; variables that must be held at a value because they are no numbers or have only two values;
/// and lists of values that change together, so that no variable varies by itself. Throws StudyError with a
/// sentence if no point is usable.
std::optional<StudyIndices> study_indices(const StudyTable& table, const IndicesRequest& request,
                                          formats::Diagnostics& diagnostics);

/// The indices as text, as one JSON object, and as a bar chart.
std::string indices_text(const std::string& study, const StudyIndices& found);
std::string indices_json(const std::string& study, const StudyIndices& found);
formats::BarChart indices_bars(const StudyIndices& found);

}  // namespace netloft::studies
