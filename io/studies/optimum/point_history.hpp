// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/sweep/record.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace netloft::studies {

/// The figures of a scene at one point. A point has a value for each variable.
struct KnownPoint {
  std::vector<double> parameters;
  std::string reason;                // why there is no equilibrium; empty if there is one
  std::vector<StudyFigure> figures;  // all figures at the equilibrium
  std::map<std::string, std::vector<double>> slopes = {};  // derivatives of figures, by their names
};

/// The points of an optimisation, stored in a file of JSON lines, so that no point is solved again after a
/// restart. Each line has the hash `inputs`, the values of the variables, and the version of the program.
/// Lines with other hashes and damaged lines are ignored, but stay in the file.
class PointHistory {
 public:
  /// Reads the file, if there is one. Throws formats::ReadError.
  PointHistory(std::filesystem::path file, std::string inputs);
  /// The stored point with these values; nullptr if there is none.
  const KnownPoint* find(const std::vector<double>& parameters) const;
  /// Stores a point, which replaces an earlier one with the same values, and writes the file. Throws
  /// formats::WriteError.
  void store(KnownPoint point);

 private:
  std::filesystem::path file_;
  std::string inputs_, others_;  // hash; lines that belong to other inputs
  std::vector<KnownPoint> points_;
};

}  // namespace netloft::studies
