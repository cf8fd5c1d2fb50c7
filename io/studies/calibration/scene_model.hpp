// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"
#include "io/studies/calibration/calibration_file.hpp"
#include "solvers/fitting/least_squares/least_squares.hpp"

namespace netloft::studies {

/// Called after every solve of a calibration with the number of solves and the name of the scene.
using OnSolve = std::function<void(std::size_t solves, const std::string& scene)>;

/// Predicts the measured figures with the scenes of a calibration. Each scene is solved from its previous
/// equilibrium, or by a new search if that fails. Slopes are derivatives at the equilibrium of the scene
/// (sensitivity.hpp).
class SceneModel : public Model {
 public:
  /// Requires a `file` that was checked (check_calibration). Paths of scenes are relative to `folder`.
  SceneModel(const CalibrationFile& file, std::filesystem::path folder, Registry& registry, runs::Watch watch,
             OnSolve on_solve);
  ~SceneModel() override;

  std::optional<std::vector<double>> predict(const std::vector<double>& parameters) override;
  std::optional<std::vector<std::vector<double>>> slopes(const std::vector<double>& parameters) override;
  bool is_interrupted() const override { return watch_.interrupt && watch_.interrupt->load(); }

  int solves() const { return solves_; }
  /// Why the last scene without a result has none: "slow: not converged; largest residual …".
  const std::string& trouble() const { return trouble_; }
  /// Names of the scenes with an unstable equilibrium at the last prediction.
  std::vector<std::string> unstable() const;

 private:
  struct Solved;
  std::optional<std::vector<double>> figures(std::size_t scene, const std::vector<double>& parameters);
  bool add_slopes(std::size_t scene, const std::vector<double>& parameters,
                  std::vector<std::vector<double>>& rows);

  const CalibrationFile& file_;
  std::filesystem::path folder_;
  Registry& registry_;
  runs::Watch watch_;
  OnSolve on_solve_;
  std::vector<runs::CaseSource> sources_;  // source of each scene, without variables
  std::vector<Solved> last_;               // last solution of each scene
  int solves_ = 0;
  std::string trouble_;
};

/// Arguments of `--set` that set the variables of a scene to these values.
std::vector<std::string> overrides_of(const CalibrationFile& file, std::size_t scene,
                                      const std::vector<double>& parameters);

/// The measurements in the order of the calibration file, converted to the units of their figures.
struct CheckedCalibration {
  std::vector<Measurement> measured;
  std::vector<std::string> units;
  bool refused = false;
};
/// Opens every scene to find errors before any scene is solved: at the prior means of the variables, and at
/// both ends of the interval of each variable. Errors in keys, values and figures are reported to
/// `diagnostics`. `on_budget` receives the processor time allowed for the figures of a scene [s].
CheckedCalibration check_calibration(const CalibrationFile& file, const std::filesystem::path& folder,
                                     Registry& registry, formats::Diagnostics& diagnostics,
                                     const std::function<void(double)>& on_budget);

}  // namespace netloft::studies
