// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/svg/bar_chart.hpp"
#include "io/studies/sweep/sobol_indices.hpp"

namespace netloft::studies {

struct IndicesRequest {
  std::vector<std::string> at;       // held variables, such as "speed=3 kn"
  std::vector<std::string> figures;  // empty: all except those of single parts
};

/// A variable that has indices, and its range.
struct VariedVariable {
  std::string name, unit;
  double from = 0, to = 0;
  bool is_sampled = false;
};

struct FigureIndices {
  std::string name, unit;
  double mean = 0, deviation = 0;  // over all variables
  double off = 0;                  // root mean square error of predicting left-out points, over the deviation
  std::size_t points = 0;          // number of points used
  std::vector<SobolIndex> variables;  // in the order of StudyIndices::variables
  std::string why_not;                // the reason if there are no indices
};

/// How strongly the figures of a study depend on each of its variables.
struct StudyIndices {
  std::vector<std::pair<std::string, std::string>> held;  // variables and their values
  std::vector<VariedVariable> variables;
  double beyond = 0;         // fraction of the sample outside the points
  std::size_t left_out = 0;  // points without a stable equilibrium
  std::vector<FigureIndices> figures;
};

/// Sobol's indices (sobol_indices.hpp) of figures over the variables of a table, for the kriging response to
/// its points. Variables are independent: listed ones are uniform from the first to the last value, sampled
/// ones are distributed as their samples. The error is the root of the sum of squares of two parts: the error
/// of the sample, and that of the response,
///   2 ((k − 1)/k Σ_g (S_g − S)²)^½ + Σ_v max_l |S_l − S|                                    (1)
/// S_g are indices of the response without one of k groups of samples, k at most ten; S_l are those without a
/// value l of the listed variable v, l neither its first nor its last.
///
/// Reports faults of the request to `diagnostics`, and then returns nothing: unknown figures and variables,
/// variables that have to be held because they are no numbers or have only two values, and lists, which vary
/// no variable by itself. Throws StudyError with a sentence if no point is usable.
std::optional<StudyIndices> study_indices(const StudyTable& table, const IndicesRequest& request,
                                          formats::Diagnostics& diagnostics);

/// The indices as a text for people, as one JSON object, and as a bar chart.
std::string indices_text(const std::string& study, const StudyIndices& found);
std::string indices_json(const std::string& study, const StudyIndices& found);
formats::BarChart indices_bars(const StudyIndices& found);

}  // namespace netloft::studies
