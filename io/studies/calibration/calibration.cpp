// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/calibration/calibration.hpp"

#include "framework/balance/statistics.hpp"

namespace netloft::studies {

namespace {

/// A model with the figures of `model` in another order.
class Reordered : public Model {
 public:
  Reordered(SceneModel& model, const std::vector<std::size_t>& order) : model_(model), order_(order) {}
  std::optional<std::vector<double>> predict(const std::vector<double>& parameters) override {
    return in_order(model_.predict(parameters));
  }
  std::optional<std::vector<std::vector<double>>> slopes(const std::vector<double>& parameters) override {
    return in_order(model_.slopes(parameters));
  }
  bool is_interrupted() const override { return model_.is_interrupted(); }

 private:
  template <class Rows>
  std::optional<Rows> in_order(const std::optional<Rows>& rows) const {
    if (!rows) return std::nullopt;
    Rows ordered;
    for (const std::size_t row : order_) ordered.push_back((*rows)[row]);
    return ordered;
  }

  SceneModel& model_;
  const std::vector<std::size_t>& order_;
};

std::vector<std::size_t> fitted_first(const CalibrationFile& file) {
  std::vector<std::size_t> order;
  for (const bool held_back : {false, true})
    for (std::size_t m = 0; m < file.measured.size(); ++m)
      if (file.measured[m].is_held_back == held_back) order.push_back(m);
  return order;
}

}  // namespace

double Calibration::width() const { return normal_quantile((1 + file.confidence) / 2); }

Calibration calibrate(CalibrationFile file, const CheckedCalibration& checked,
                      const std::filesystem::path& folder, Registry& registry, const runs::Watch& watch,
                      const OnSolve& on_solve) {
  Calibration done;
  done.file = std::move(file);
  done.measured = checked.measured;
  done.units = checked.units;
  done.order = fitted_first(done.file);
  std::vector<Prior> priors;
  for (const auto& v : done.file.variables)
    priors.push_back(
        {v.prior_mean(), v.prior_deviation(), v.variable.interval->low, v.variable.interval->high});
  std::vector<Measurement> fitted;
  for (const std::size_t row : done.order)
    if (!done.file.measured[row].is_held_back) fitted.push_back(done.measured[row]);
  const double before = cpu_seconds();
  SceneModel scenes(done.file, folder, registry, watch, on_solve);
  Reordered model(scenes, done.order);
  done.fit = fit(model, priors, fitted);
  done.cpu_seconds = cpu_seconds() - before;
  done.is_interrupted = scenes.is_interrupted() && !done.fit.converged;
  done.solves = scenes.solves();
  done.unstable = scenes.unstable();
  if (!done.fit.converged) done.trouble = scenes.trouble();
  return done;
}

}  // namespace netloft::studies
