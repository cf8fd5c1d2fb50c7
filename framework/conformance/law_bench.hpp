// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/conformance/bench.hpp"

namespace netloft::conformance {

/// Up to 64 flows past a twine or a screen, arrays [component][64] like those of a law.
struct Flows {
  std::uint32_t count = 0;
  std::vector<double> flow, direction, diameter, solidity;
};

/// The answer of a law. Rows that the law did not write are NaN.
struct LawAnswer {
  bool ok = false;
  std::string thrown;  // the exception that the law threw, if any
  std::vector<double> force, d_flow, d_direction, d_solidity;
};

/// The fixture of the law checks, with sampled parameters and flows. Speeds are from 1 cm/s to 5 m/s,
/// diameters from 1 mm to 10 cm, solidities from 0 to 0.9, a quarter of them zero. Among eight flows, one is
/// zero, one is along the twine (or the normal of the screen), and one is perpendicular to it. Two more are
/// parallel and perpendicular to it except for a millionth, and one has a thousandth of these speeds.
struct LawBench {
  LawBench(const LawType& type, const ConformanceOptions& options);

  LawAnswer evaluate(std::size_t part, const Flows& flows, bool derivatives) const;
  /// Calls the law with arrays that the caller provides. Returns false if the law failed or threw an
  /// exception.
  bool call(std::size_t part, const netloft_law_tile& flow, std::string& thrown) const;
  /// A flow in words: "parameters 3, flow 12 (along the direction)".
  std::string place(std::size_t part, std::size_t lane) const;
  /// The speed by which checks vary a flow [m/s].
  double reach(const Flows& flows, std::size_t lane) const;
  /// Largest force on each twine or screen, in flows of random directions at the speed reach() [N].
  std::vector<double> force_scale(std::size_t part, const Flows& flows);
  std::vector<double> random_field();

  const LawType& type;
  ConformanceOptions options;
  ParameterSampler sampler;
  std::vector<Values> values;
  std::vector<ParameterBlock> parameters;
  std::vector<std::string> faults;
  std::vector<Flows> tiles;  // flows for each set of parameters

 private:
  Flows sample();
};

/// The number (NaN) with which the arrays of an answer are filled before the law writes to them.
double not_written();

}  // namespace netloft::conformance
