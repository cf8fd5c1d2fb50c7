// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "solvers/fitting/model.hpp"

#include <limits>
#include <string>
#include <vector>

namespace netloft {

/// Prior knowledge of a parameter: a normal distribution, truncated at both ends.
struct Prior {
  double mean = 0, deviation = 1;
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
};

/// A measured value with its standard deviation.
struct Measurement {
  double value = 0, deviation = 1;
};

struct FitOptions {
  int iterations = 30;      // limit of the number of steps, including rejected steps
  double tolerance = 0.01;  // the fit ends if the expected decrease of S is smaller than this
};

/// A calibration by least squares, which finds the parameters θ of a model f(θ) that fit measurements y best:
///   S(θ) = Σ ((y_i − f_i)/σ_i)² + Σ ((θ_j − m_j)/s_j)²                                            (1)
///   (N + λ diag N) δ = −g,  N = JᵀJ + I,  g = Jᵀr + z,  z_j = (θ_j − m_j)/s_j, J = −(∂f/∂θ) s/σ       (2)
/// σ are the deviations of the measurements, m and s the means and deviations of the priors, r_i = (y_i −
/// f_i)/σ_i; δ is a step of θ in units of s, λ its damping. Steps are those of K. Levenberg, Quart. Appl.
/// Math. 2, 1944, and D. Marquardt, SIAM J. Appl. Math. 11, 1963, cut off at the ends of the range of the
/// prior; a parameter at an end is fixed if its step points outward. The posterior is the normal distribution
/// with
///   mean θ*, covariance N⁻¹ at λ = 0                                                              (3)
/// which is exact for a linear model. The prediction of a measurement that is not yet made has the variance
///   J_f N⁻¹ J_fᵀ + σ²,  J_f = (∂f/∂θ) s                                                           (4)
struct Fit {
  bool converged = false;
  std::string reason;                             // why the fit ended, as a sentence
  std::vector<double> parameters;                 // best parameters θ*
  std::vector<double> deviations;                 // standard deviations of the posterior
  std::vector<std::vector<double>> correlations;  // correlations of the posterior
  std::vector<bool> at_end;                       // whether θ*_j is at an end of the range of its prior
  std::vector<double> predictions;                // predictions f(θ*)
  std::vector<double> model_deviations;           // standard deviations of f, by (4) without σ²
  double misfit = 0, prior_misfit = 0;            // the two sums of (1)
  int steps = 0;
};

/// Fits `measured`. The model may predict additional values, which get deviations, too. If the model has no
/// solution at the means of the priors, or no slopes at a point of the iteration, `parameters` is empty. If
/// the fit is interrupted, the result is the best point at which slopes were computed, if there is such a
/// point.
Fit fit(Model& model, const std::vector<Prior>& priors, const std::vector<Measurement>& measured,
        const FitOptions& options = {});

}  // namespace netloft
