// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/formats/svg/plot.hpp"
#include "io/studies/sweep/study_table.hpp"

#include <map>

namespace netloft::studies {

/// Which part of a table is drawn, over what.
struct PlotRequest {
  std::vector<std::string> figures;  // empty: all that are numbers of the gear as a whole
  std::string over;                  // a variable; empty: the first of the path, or the first number
  std::string by;                    // a variable with a line for every value; empty: the next listed one
  std::map<std::string, std::string> at;  // values of other listed variables, as the table has them
};

/// The ends of the bands over samples: nine tenths of them lie between.
inline constexpr double kBandLow = 0.05, kBandHigh = 0.95;

/// A plot of each figure: lines are medians over the samples, bands have nine tenths of them. Over a variable
/// that is sampled there is a marker for every row. Listed variables that are neither on the axis nor told
/// apart by lines are held at one value, which the title says. Points without a stable equilibrium are left
/// out; where some of the samples have none, the marker is hollow. Throws StudyError with a sentence where a
/// name is wrong or there is nothing to draw.
std::vector<formats::LinePlot> plots_of(const StudyTable& table, const PlotRequest& request);

}  // namespace netloft::studies
