// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/svg/plot.hpp"
#include "io/studies/sweep/study_table.hpp"

#include <map>

namespace netloft::studies {

/// The choice of figures, axis and lines for the plots of a table.
struct PlotRequest {
  std::vector<std::string> figures;  // empty: all figures of the gear as a whole
  std::string over;  // variable on the axis; empty: the first one in the path, else the first number
  std::string by;    // variable with one line per value; empty: the next listed one
  std::map<std::string, std::string> at;  // values of other listed variables, written as in the table
};

/// The ends of bands over samples, as quantiles. Nine tenths of the samples lie between these.
inline constexpr double kBandLow = 0.05, kBandHigh = 0.95;

/// Makes one plot for each figure (a number that every point reports). A listed variable has given values; a
/// sampled variable has random values. If the variable on the axis is listed, lines are medians over the
/// samples and bands contain nine tenths of them. If it is sampled, every row is a marker. Listed variables
/// that are neither on the axis nor distinguished by lines are held at one value, which the title names.
/// Points without a stable equilibrium are left out; if some of the samples have none, the marker is hollow.
/// Throws StudyError with a sentence if a name is wrong or there is nothing to draw.
std::vector<formats::LinePlot> plots_of(const StudyTable& table, const PlotRequest& request);

}  // namespace netloft::studies
