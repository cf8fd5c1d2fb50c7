// SPDX-License-Identifier: BSD-3-Clause
#include "framework/balance/work.hpp"

#include <gtest/gtest.h>

#include "solvers/factorisation/kept_analyses.hpp"
#include "solvers/factorisation/make_factorisation.hpp"
#include "tests/support/sample_scenes.hpp"
#include "tests/unit/framework/assembler/sketch.hpp"
#include "tests/verification/solving.hpp"

namespace netloft::test {
namespace {

/// A factorisation that reports the size of its factor, and counts its analyses.
class Sized final : public Factorisation {
 public:
  Sized(double flops, double entries, int& analyses)
      : flops_(flops), entries_(entries), analyses_(analyses) {}
  std::string description() const override { return "sized"; }
  void analyse(const SparsePattern&) override { ++analyses_; }
  FactorResult factorise(std::span<const double>) override { return {}; }
  void solve(std::span<const double>, std::span<double>) override {}
  void solve_transposed(std::span<const double>, std::span<double>) override {}
  double factor_flops() const override { return flops_; }
  double factor_entries() const override { return entries_; }

 private:
  double flops_, entries_;
  int& analyses_;
};

MakeFactorisation sized(double flops, double entries, int& analyses) {
  return [=, &analyses](MatrixClass) { return std::make_unique<Sized>(flops, entries, analyses); };
}

/// Three bars in a row, with one term each, without weight and water.
Scene three_bars() {
  Sketch s;
  s.scene.water.gravity = s.scene.water.density = 0;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0, 0), c = s.node(2, 0, 0), d = s.node(3, 0, 0);
  s.rope("rope", {a, b, c, d}, 1);
  return s.scene;
}

TEST(WorkModel, AddsUpWhatWasCounted) {
  const WorkModel model{.factorisation = 100, .solution = 20, .matrix = 8, .residual = 4, .unit = 10};
  Statistics statistics;
  statistics.factorisations = 1, statistics.solves = 2, statistics.matrices = 5, statistics.residuals = 3;
  EXPECT_DOUBLE_EQ(model.of(statistics), (100 + 40 + 40 + 12) / 10.0);
  statistics.energies = 3;
  EXPECT_DOUBLE_EQ(model.of(statistics), 19.2) << "energies beside residuals cost nothing";
  statistics.energies = 5;
  EXPECT_DOUBLE_EQ(model.of(statistics), 20.0) << "energies alone cost what residuals do";
}

TEST(WorkModel, HasOneNewtonIterationOfTheSceneForItsUnit) {
  Assembled a(three_bars());
  const WorkModel model = make_work_model(a.assembler, make_factorisation);
  Statistics statistics;
  statistics.factorisations = statistics.solves = statistics.matrices = statistics.residuals = 1;
  EXPECT_DOUBLE_EQ(model.of(statistics), 1);
}

// The factor takes F = 1000 operations and has N = 100 entries. There are 3 bars of 6 degrees of freedom with
// one term.
TEST(WorkModel, FollowsFromTheFactorAndTheElements) {
  int analyses = 0;
  Assembled a(three_bars());
  ASSERT_EQ(a.assembler.families().size(), 1u);
  ASSERT_EQ(a.assembler.families()[0]->active_terms().size(), 1u);
  const WorkModel model = make_work_model(a.assembler, sized(1000, 100, analyses));
  EXPECT_EQ(model.factorisation, 1000 + 20 * 100);
  EXPECT_EQ(model.solution, 20 * 100);
  EXPECT_EQ(model.residual, 4 * 3 * 36);
  EXPECT_EQ(model.matrix, 12 * 3 * 36);
}

TEST(WorkModel, LeavesItsAnalysisToTheSolver) {
  int analyses = 0;
  Assembled a(three_bars());
  const MakeFactorisation make = keep_analyses(sized(1000, 100, analyses));
  make_work_model(a.assembler, make);
  make(MatrixClass::positive_definite)->analyse(a.assembler.pattern());
  EXPECT_EQ(analyses, 1);
}

// The estimate is the count for nested dissection of a square grid with nine neighbours per node. It is an
// upper limit for panels of triangles, and small panels have less fill-in.
TEST(WorkModel, EstimatesAFactorThatDoesNotTellItsSize) {
  plugins();
  int analyses = 0;
  for (const int cells : {16, 64}) {
    Assembled a(sample::hanging_panel(cells, 34));
    const WorkModel known = make_work_model(a.assembler, make_factorisation),
                    estimated = make_work_model(a.assembler, sized(0, 0, analyses));
    EXPECT_GT(estimated.factorisation, 0.5 * known.factorisation) << cells;
    EXPECT_LT(estimated.factorisation, 10 * known.factorisation) << cells;
  }
}

TEST(WorkModel, CostsSomethingWhereNothingIsUnknown) {
  Sketch s;
  const auto a = s.node(0, 0, 0, kAllAxes), b = s.node(1, 0, 0, kAllAxes);
  s.rope("rope", {a, b}, 1);
  Assembled all_held(s.scene);
  EXPECT_GT(make_work_model(all_held.assembler, make_factorisation).unit, 0);
}

}  // namespace
}  // namespace netloft::test
