// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace netloft {

/// The prediction at one point.
struct KrigingValue {
  double value = 0;      // prediction m of (3)
  double deviation = 0;  // standard deviation s of (4)
};

/// The parameters of the correlation between values at two points, (1) and (2) of Kriging.
struct KrigingScales {
  enum class Correlation { matern, gaussian };
  Correlation correlation = Correlation::matern;
  std::vector<double> lengths;  // ℓ, a number for each coordinate, over the extent of the points
  double scatter = 0;           // scatter ν of (1)
};

/// Universal kriging. Values y at n points x, of d coordinates each, are taken as the sum of a plane f β, f =
/// (1, x₁ … x_d), and of a stationary normal process with the covariance
///   cov(y(x), y(x')) = σ² (k(r) + ν [x = x']),   r² = Σ ((x_j − x'_j)/(ℓ_j w_j))²                  (1)
/// where ν is the scatter, w_j the extent of the points in coordinate j, and k the likelier of two
/// correlations,
///   k = (1 + √5 r + 5/3 r²) e^{−√5 r}   (Matérn's of order 5/2),   k = e^{−r²/2}                    (2)
/// A constant, f = 1, replaces the plane if there are less than 2 (d + 1) points or if the points are in a
/// plane. The prediction m at a point has the variance s². With K = k + ν I, F the rows f of all given
/// points, κ their correlations with the predicted point:
///   m = f β + κᵀ K⁻¹ (y − F β),   β = A⁻¹ Fᵀ K⁻¹ y,   A = Fᵀ K⁻¹ F                                  (3)
///   s² = σ² (1 + ν − κᵀ K⁻¹ κ + uᵀ A⁻¹ u),   u = f − Fᵀ K⁻¹ κ,
///   σ² = (y − F β)ᵀ K⁻¹ (y − F β)/(n − p),   p the length of f                                      (4)
/// ℓ and ν minimise the restricted likelihood, up to sign and constants,
///   (n − p) ln σ² + ln |K| + ln |A|                                                                 (5)
/// over at most 150 of the points, by a search along the axes of ln ℓ_j and ln ν. The values at a group G of
/// points minus their prediction from all other points are
///   Q_GG⁻¹ (Q y)_G,   Q = K⁻¹ − K⁻¹ F A⁻¹ Fᵀ K⁻¹                                                    (6)
/// Sources: T. J. Santner, B. J. Williams, W. I. Notz, The design and analysis of computer experiments, 2nd
/// ed., 2018, ch. 3; (6): O. Dubrule, Cross validation of kriging in a unique neighborhood, Mathematical
/// Geology 15, 1983.
class Kriging {
 public:
  /// There must be at least two points, all different, with a range above zero in every coordinate and finite
  /// values. If `known` is given, its scales replace the likeliest.
  Kriging(const std::vector<std::vector<double>>& points, const std::vector<double>& values,
          const KrigingScales* known = nullptr);
  ~Kriging();
  Kriging(const Kriging&) = delete;
  Kriging& operator=(const Kriging&) = delete;

  KrigingValue at(const std::vector<double>& point) const;
  /// Returns m alone, which takes n operations, whereas s takes n².
  double value_at(const std::vector<double>& point) const;
  /// Returns ℓ and ν, or nullopt if all values are equal.
  std::optional<KrigingScales> scales() const;

  /// Returns the values at a group of points minus their prediction from all other points, by (6) with ℓ and
  /// ν of all points. The group must not contain all points.
  std::vector<double> residuals_without(const std::vector<std::size_t>& group) const;

 private:
  class Model;
  std::unique_ptr<Model> model_;  // nullptr if all values are equal
  double mean_ = 0;
};

}  // namespace netloft
