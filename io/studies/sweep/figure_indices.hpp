// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/svg/bar_chart.hpp"
#include "io/studies/sweep/sobol_indices.hpp"

namespace netloft::studies {

struct IndicesRequest {
  std::vector<std::string> at;       // "speed=3 kn": variables that are held
  std::vector<std::string> figures;  // empty: all but those of single parts
};

/// A variable that counts, and where it varies.
struct VariedVariable {
  std::string name, unit;
  double from = 0, to = 0;
  bool is_sampled = false;
};

struct FigureIndices {
  std::string name, unit;
  double mean = 0, deviation = 0;  // over all variables
  double off = 0;                  // root mean square of what points left out are off by, over the deviation
  std::size_t points = 0;          // it follows from so many
  std::vector<SobolIndex> variables;  // in the order of StudyIndices::variables
  std::string why_not;                // there are no indices
};

/// Which variables of a study its figures follow from.
struct StudyIndices {
  std::vector<std::pair<std::string, std::string>> held;  // variables and their values
  std::vector<VariedVariable> variables;
  double beyond = 0;         // part of the sample that lies beyond the points
  std::size_t left_out = 0;  // points without a stable equilibrium
  std::vector<FigureIndices> figures;
};

/// Sobol's indices (sobol_indices.hpp) of figures over the variables of a table, by the response that kriging
/// makes of its points. Variables are independent of one another: those with listed values are uniform from
/// the first to the last, those that are sampled are distributed as their samples. Errors have two parts, the
/// root of whose squares is summed up: that of the sample, and that of the response,
///   2 ((k − 1)/k Σ_g (S_g − S)²)^½ + Σ_v max_l |S_l − S|                                    (1)
/// S_g are indices of the response without one of k groups of samples, at most ten of them, and S_l without a
/// value l of the listed variable v that is neither its first nor its last.
///
/// Faults of the request go to `diagnostics`, and there is no result then: figures and variables
/// that are not there, variables that have to be held because they are no numbers or have only two values,
/// lists, which vary no variable by itself. Throws StudyError with a sentence where no point counts.
std::optional<StudyIndices> study_indices(const StudyTable& table, const IndicesRequest& request,
                                          formats::Diagnostics& diagnostics);

/// For people, as one JSON object, and as bars.
std::string indices_text(const std::string& study, const StudyIndices& found);
std::string indices_json(const std::string& study, const StudyIndices& found);
formats::BarChart indices_bars(const StudyIndices& found);

}  // namespace netloft::studies
