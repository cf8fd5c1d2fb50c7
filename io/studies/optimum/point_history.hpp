// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/studies/sweep/record.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace netloft::studies {

/// The figures of a scene at one point, which is a value of each variable.
struct KnownPoint {
  std::vector<double> parameters;
  std::string reason;                // why there is no equilibrium; empty if there is one
  std::vector<StudyFigure> figures;  // all figures at the equilibrium
  std::map<std::string, std::vector<double>> slopes = {};  // derivatives of figures, by their names
};

/// The points of an optimisation, stored in a file of JSON lines, so that no point is solved twice if the
/// program is started again. Each line has the hash `inputs` of the scene, its values and the version of the
/// program. Lines with other hashes and damaged lines are not used, but kept.
class PointHistory {
 public:
  /// Reads the file, if there is one. Throws formats::ReadError.
  PointHistory(std::filesystem::path file, std::string inputs);
  /// nullptr: nothing is known there.
  const KnownPoint* find(const std::vector<double>& parameters) const;
  /// Stores a point, in place of an earlier one with the same values, and writes the file. Throws
  /// formats::WriteError.
  void store(KnownPoint point);

 private:
  std::filesystem::path file_;
  std::string inputs_, others_;  // hash; lines that belong to other inputs
  std::vector<KnownPoint> points_;
};

}  // namespace netloft::studies
