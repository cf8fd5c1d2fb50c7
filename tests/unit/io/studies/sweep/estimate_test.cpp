// SPDX-License-Identifier: BSD-3-Clause
#include "io/studies/sweep/estimate.hpp"

#include "io/studies/sweep/study_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

namespace netloft::studies {
namespace {

using Function = std::function<double(double speed, double depth, double friction)>;

/// A smooth function of speed and depth, as a headline height is, from 3 to 13.
double height(double speed, double depth, double friction = 0) {
  return 24 / (speed * std::sqrt(speed)) + 2 * std::sin(depth / 40) + friction * speed;
}

StudyColumn column(const std::string& name, const std::string& unit, bool sampled = false) {
  StudyColumn c;
  c.variable.name = name, c.variable.unit = unit, c.is_sampled = sampled, c.is_in_path = !sampled;
  return c;
}

StudyColumn gears() {
  StudyColumn c = column("gear", "");
  c.is_number = false;
  return c;
}

/// A table over speeds from 2 to 4 kn, depths from 50 to 150 m, and samples of a friction from 0 to 1.
class TableOfAGear {
 public:
  explicit TableOfAGear(const Function& f, std::size_t speeds = 5, std::size_t depths = 8,
                        std::size_t samples = 0) {
    table.columns = {column("speed", "kn"), column("depth", "m")};
    if (samples) table.columns.push_back(column("friction", "", true));
    table.figures = {{"gear/height", "m", 0}, {"gear/drag_by_part/net", "N", 0}};
    for (std::size_t sample = 1; sample <= std::max<std::size_t>(samples, 1); ++sample)
      for (std::size_t i = 0; i < speeds; ++i)
        for (std::size_t j = 0; j < depths; ++j)
          add(f, samples ? sample : 0, samples, share(i, speeds), share(j, depths));
  }

  StudyTable table;

 private:
  static double share(std::size_t i, std::size_t n) {
    return static_cast<double>(i) / static_cast<double>(n - 1);
  }

  void add(const Function& f, std::size_t sample, std::size_t samples, double across, double along) {
    const double speed = 2 + 2 * across, depth = 50 + 100 * along;
    const double friction = sample ? std::fmod(static_cast<double>(sample) * 0.6180339887, 1.0) : 0;
    StudyRow row{std::max<std::size_t>(sample, 1), sample, table.rows.size() + 1, {}, {},
                 {f(speed, depth, friction), 1}};
    row.values = {table.columns[0].variable.value_of(speed), table.columns[1].variable.value_of(depth)};
    if (samples) row.values.push_back(table.columns[2].variable.value_of(friction));
    row.record.status = "converged";
    table.rows.push_back(std::move(row));
  }
};

StudyEstimate estimated(const StudyTable& table, const std::vector<std::string>& at) {
  formats::Diagnostics diagnostics;
  auto found = estimate(table, {at, {}}, diagnostics);
  EXPECT_TRUE(found) << diagnostics.render(false);
  return found ? *found : StudyEstimate{};
}

WithError height_at(const StudyTable& table, double speed, double depth) {
  return estimated(table, {"speed=" + std::to_string(speed) + " kn", "depth=" + std::to_string(depth) + " m"})
      .figures.at(0)
      .value;
}

std::string refused(const StudyTable& table, const EstimateRequest& request) {
  formats::Diagnostics diagnostics;
  EXPECT_FALSE(estimate(table, request, diagnostics));
  return diagnostics.render(false);
}

TEST(Estimates, AreAFunctionOfTwoVariablesWithinTheirErrors) {
  const StudyTable table = TableOfAGear(height).table;
  int within = 0, all = 0;
  for (double speed = 2.05; speed < 4; speed += 0.15)
    for (double depth = 51; depth < 150; depth += 9, ++all) {
      const WithError found = height_at(table, speed, depth);
      within += std::abs(found.value - height(speed, depth)) <= found.error;
      EXPECT_LT(found.error, 0.25) << speed << " " << depth;  // heights differ by 10
    }
  EXPECT_EQ(within, all);
}
// The function has a kink in the middle of the table, as figures have where a gear comes off the ground.
TEST(Estimates, HaveLargeErrorsWhereFiguresBend) {
  const StudyTable table =
      TableOfAGear([](double speed, double, double) { return std::abs(speed - 3.2); }).table;
  int within = 0, all = 0;
  for (double speed = 2.05; speed < 4; speed += 0.05, ++all) {
    const WithError found = height_at(table, speed, 77);
    within += std::abs(found.value - std::abs(speed - 3.2)) <= found.error;
  }
  EXPECT_GE(within, 0.95 * all);  // an error of 2 s holds in 95 % of all cases
  EXPECT_GT(height_at(table, 3.2, 77).error, 0.05);
}
TEST(Estimates, AtAPointOfTheStudyAreItsFigure) {
  const StudyEstimate found = estimated(TableOfAGear(height).table, {"speed=2.5 kn,depth=50 m"});
  EXPECT_EQ(found.figures[0].value.value, height(2.5, 50));
  EXPECT_EQ(found.figures[0].value.error, 1e-9 * height(2.5, 50));
  EXPECT_EQ(found.figures[0].points, 1u);
}
TEST(Estimates, TakeUnitsAsScenesDo) {
  const StudyTable table = TableOfAGear(height).table;
  const auto at = [&](const std::string& speed) {
    return estimated(table, {"speed=" + speed, "depth=81 m"}).figures[0].value.value;
  };
  EXPECT_NEAR(at("1.5 m/s"), at(std::to_string(1.5 * 3600 / 1852) + " kn"), 1e-5);
}
TEST(Estimates, LeaveOutFiguresOfPartsUnlessNamed) {
  const StudyTable table = TableOfAGear(height).table;
  EXPECT_EQ(estimated(table, {"speed=2.7 kn,depth=80 m"}).figures.size(), 1u);
  formats::Diagnostics diagnostics;
  const auto found = estimate(table, {{"speed=2.7 kn,depth=80 m"}, {"gear/drag_by_part/net"}}, diagnostics);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->figures[0].value.value, 1);
}
TEST(Estimates, OverDrawsAreMedianAndBand) {
  const StudyTable table = TableOfAGear(height, 5, 5, 20).table;
  const StudyEstimate found = estimated(table, {"speed=2.7 kn,depth=80 m"});
  EXPECT_EQ(found.samples, 20u);
  std::vector<double> truth;
  for (std::size_t sample = 1; sample <= 20; ++sample)
    truth.push_back(height(2.7, 80, std::fmod(static_cast<double>(sample) * 0.6180339887, 1.0)));
  const EstimatedFigure& figure = found.figures[0];
  EXPECT_NEAR(figure.value.value, quantile_of(truth, 0.5), figure.value.error);
  EXPECT_NEAR(figure.low->value, quantile_of(truth, 0.05), figure.low->error);
  EXPECT_NEAR(figure.high->value, quantile_of(truth, 0.95), figure.high->error);
  EXPECT_LT(figure.value.error, 0.3);
  EXPECT_GT(figure.high->value - figure.low->value, 2);
}
// Most samples fall at a step, and some stay above it. A fit to the medians would swing at the step, beyond
// the ends of a band that is fitted by itself.
TEST(Estimates, HaveTheirMedianWithinTheirBandWhateverDrawsDo) {
  const auto step = [](double speed, double, double friction) {
    return friction > 0.85 || speed < 3.2 ? 1.0 : 0.0;
  };
  const StudyTable table = TableOfAGear(step, 6, 5, 12).table;
  for (double speed = 2.02; speed < 4; speed += 0.07)
    for (const char* depth : {"53 m", "80 m", "143 m"}) {
      const EstimatedFigure figure =
          estimated(table, {"speed=" + std::to_string(speed) + " kn", std::string("depth=") + depth})
              .figures[0];
      EXPECT_LE(figure.low->value, figure.value.value) << speed << " " << depth;
      EXPECT_LE(figure.value.value, figure.high->value) << speed << " " << depth;
      EXPECT_EQ(figure.samples, 12u);
    }
}
TEST(Estimates, LeaveOutADrawOfWhichTooFewPointsAreKnown) {
  StudyTable table = TableOfAGear(height, 5, 5, 20).table;
  for (StudyRow& row : table.rows)
    if (row.sample == 3 && *row.values[0].number > 2.6) row.record.status = "not converged";
  EXPECT_EQ(estimated(table, {"speed=2.7 kn,depth=80 m"}).figures[0].samples, 19u);
}
TEST(Estimates, OfOneDrawAreOfItsNumbers) {
  const StudyTable table = TableOfAGear(height, 5, 5, 20).table;
  const StudyEstimate found = estimated(table, {"speed=2.7 kn,depth=80 m,friction=0.33"});
  EXPECT_EQ(found.samples, 0u);
  EXPECT_NEAR(found.figures[0].value.value, height(2.7, 80, 0.33), found.figures[0].value.error);
  EXPECT_LT(found.figures[0].value.error, 0.3);
}
TEST(Estimates, LeaveOutAndNameWhatHasNoEquilibrium) {
  StudyTable table = TableOfAGear(height).table;
  for (const std::size_t r : {9u, 20u}) {
    table.rows[r].record.status = "not converged", table.rows[r].record.reason = "it was a bad day";
    table.rows[r].figures[0] = 1e6;
  }
  const StudyEstimate found = estimated(table, {"speed=2.7 kn", "depth=80 m"});
  ASSERT_EQ(found.left_out.size(), 2u);
  EXPECT_EQ(found.left_out[0].point, 10u);
  EXPECT_EQ(found.left_out[0].reason, "it was a bad day");
  EXPECT_NEAR(found.figures[0].value.value, height(2.7, 80), found.figures[0].value.error);
  EXPECT_LT(found.figures[0].value.error, 1);
  EXPECT_NE(estimate_text("s", found).find("item 1, point 10: not converged: it was a bad day"),
            std::string::npos);
}
TEST(Estimates, BeyondTheHullOfWhatConvergedAreExtrapolations) {
  StudyTable table = TableOfAGear(height).table;
  for (StudyRow& row : table.rows)
    if (*row.values[0].number > 3 && *row.values[1].number > 100) row.record.status = "missing";
  EXPECT_FALSE(estimated(table, {"speed=2.7 kn,depth=80 m"}).is_extrapolated);
  const StudyEstimate beyond = estimated(table, {"speed=3.9 kn,depth=145 m"});
  EXPECT_TRUE(beyond.is_extrapolated);
  EXPECT_NE(estimate_text("s", beyond).find("extrapolation"), std::string::npos);
}
TEST(Estimates, OfAPointWithoutEquilibriumAreRefused) {
  StudyTable table = TableOfAGear(height).table;
  table.rows[0].record = {"not converged", "unknown", "it folds", "anew", {}, 0, 0, 0, {}};
  formats::Diagnostics diagnostics;
  try {
    estimate(table, {{"speed=2 kn,depth=50 m"}, {}}, diagnostics);
    FAIL();
  } catch (const StudyError& e) {
    EXPECT_NE(std::string(e.what()).find("item 1, point 1: not converged: it folds"), std::string::npos);
  }
}
TEST(Estimates, SayOfFoldsBesideThem) {
  StudyTable table = TableOfAGear(height).table;
  table.rows[10].record.events = {"a fold"};  // the row of 2.5 kn and 79 m
  EXPECT_EQ(estimated(table, {"speed=2.7 kn,depth=75 m"}).events,
            (std::vector<std::string>{"item 1, point 11: a fold"}));
  EXPECT_TRUE(estimated(table, {"speed=3.7 kn,depth=75 m"}).events.empty());
}
TEST(Estimates, AreOfTheGearThatIsNamed) {
  StudyTable table = TableOfAGear(height).table;
  const std::size_t rows = table.rows.size();
  table.columns.push_back(gears());
  for (std::size_t r = 0; r < rows; ++r) {
    table.rows[r].values.push_back({"a", {}});
    StudyRow other = table.rows[r];
    other.values[2].text = "b", other.figures[0] += 100;
    table.rows.push_back(other);
  }
  EXPECT_NEAR(estimated(table, {"speed=2.7 kn,depth=80 m,gear=b"}).figures[0].value.value,
              100 + height(2.7, 80), 0.2);
  EXPECT_NE(refused(table, {{"speed=2.7 kn,depth=80 m,gear=c"}, {}}).find("its values are a, b"),
            std::string::npos);
}
TEST(Estimates, OfWrongPlacesAreRefusedAllAtOnce) {
  const StudyTable table = TableOfAGear(height).table;
  const std::pair<const char*, const char*> wrong[] = {
      {"sped=2 kn", "did you mean \"speed\"?"},
      {"sped=2 kn", "speed is missing"},
      {"sped=2 kn", "depth is missing"},
      {"speed=2 m,depth=80 m", "--at speed"},
      {"speed=5 kn,depth=80 m", "speed = 5 kn is outside [2, 4] kn"},
      {"speed=3,depth=80 m", "a number is expected like those of the range, such as 1 kn"},
      {"speed=nan kn,depth=80 m", "speed"},
      {"speed", "write it as --at NAME=VALUE"},
  };
  for (const auto& [at, answer] : wrong)
    EXPECT_NE(refused(table, {{at}, {}}).find(answer), std::string::npos) << at << "\n"
                                                                          << refused(table, {{at}, {}});
  EXPECT_NE(
      refused(table, {{"speed=2.7 kn,depth=80 m"}, {"gear/heigt"}}).find("did you mean \"gear/height\"?"),
      std::string::npos);
  EXPECT_NE(refused(TableOfAGear(height, 2).table, {{"speed=2.7 kn,depth=80 m"}, {}})
                .find("between the only two values"),
            std::string::npos);
  EXPECT_NE(refused(TableOfAGear(height, 3, 3, 8).table, {{"speed=2.7 kn,depth=80 m,friction=7"}, {}})
                .find("friction = 7 is outside"),
            std::string::npos);
}
TEST(Estimates, AreInJson) {
  StudyTable table = TableOfAGear(height).table;
  table.rows[9].record.status = "missing";
  const auto json = nlohmann::json::parse(estimate_json("s", estimated(table, {"speed=2.7 kn,depth=80 m"})));
  EXPECT_EQ(json["at"]["speed"], "2.7 kn");
  EXPECT_EQ(json["left_out"][0]["status"], "missing");
  EXPECT_EQ(json["figures"]["gear/height"]["unit"], "m");
  EXPECT_GT(json["figures"]["gear/height"]["error"], 0);
}

}  // namespace
}  // namespace netloft::studies
