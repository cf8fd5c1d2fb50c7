// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/runs/prepared_scene.hpp"
#include "io/runs/watch.hpp"
#include "io/studies/calibration/calibration_file.hpp"
#include "solvers/fitting/least_squares/least_squares.hpp"

namespace netloft::studies {

/// Told after every solve of a calibration: how many there were, and the name of the scene.
using OnSolve = std::function<void(std::size_t solves, const std::string& scene)>;

/// The figures that were measured, as the scenes of a calibration predict them: a scene is solved from the
/// equilibrium found before where that leads on, and anew where it does not. Slopes are differences over a
/// tenth of the prior's deviation to either side, within the range.
class SceneModel : public Model {
 public:
  /// `file` has been checked. Scenes are found from `folder`.
  SceneModel(const CalibrationFile& file, std::filesystem::path folder, Registry& registry, runs::Watch watch,
             OnSolve on_solve);
  ~SceneModel() override;

  std::optional<std::vector<double>> predict(const std::vector<double>& parameters) override;
  std::optional<std::vector<std::vector<double>>> slopes(const std::vector<double>& parameters) override;
  bool is_interrupted() const override { return watch_.interrupt && watch_.interrupt->load(); }

  int solves() const { return solves_; }
  /// The fault of the last scene without a result: "slow: not converged; largest residual …".
  const std::string& trouble() const { return trouble_; }
  /// Scenes whose equilibrium at the last prediction is not stable.
  std::vector<std::string> unstable() const;

 private:
  struct Solved;
  std::optional<std::vector<double>> figures(std::size_t scene, const std::vector<double>& parameters,
                                             Solved& from, bool keep);
  double step_to(std::size_t variable, double from, int side) const;

  const CalibrationFile& file_;
  std::filesystem::path folder_;
  Registry& registry_;
  runs::Watch watch_;
  OnSolve on_solve_;
  std::vector<runs::CaseSource> sources_;  // of each scene, without variables
  std::vector<Solved> last_;               // of each scene
  int solves_ = 0;
  std::string trouble_;
};

/// Words for `--set` that give a scene these values of the variables it has.
std::vector<std::string> overrides_of(const CalibrationFile& file, std::size_t scene,
                                      const std::vector<double>& parameters);

/// Opens every scene at the prior means of the variables, and at both ends of the interval of each variable.
/// Reports errors in keys, values and figures to `diagnostics`. Returns the measurements in the order of the
/// file, converted to the units of the figures. `on_budget` receives the processor time that a scene may take
/// for its figures [s].
struct CheckedCalibration {
  std::vector<Measurement> measured;
  std::vector<std::string> units;
  bool refused = false;
};
CheckedCalibration check_calibration(const CalibrationFile& file, const std::filesystem::path& folder,
                                     Registry& registry, formats::Diagnostics& diagnostics,
                                     const std::function<void(double)>& on_budget);

}  // namespace netloft::studies
