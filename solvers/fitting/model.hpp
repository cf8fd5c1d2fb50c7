// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <vector>

namespace netloft {

/// A model f(θ) that predicts numbers from parameters θ.
class Model {
 public:
  virtual ~Model() = default;
  /// Returns f(θ), or nullopt if the model has no solution. The next call of `slopes` uses this solution.
  virtual std::optional<std::vector<double>> predict(const std::vector<double>& parameters) = 0;
  /// Returns ∂f/∂θ at θ, a row per prediction, or nullopt if the model has no solution near θ.
  virtual std::optional<std::vector<std::vector<double>>> slopes(const std::vector<double>& parameters) = 0;
  virtual bool is_interrupted() const { return false; }
};

}  // namespace netloft
