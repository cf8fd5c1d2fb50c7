// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/python/module/opened_scene.hpp"
#include "io/results/figures/make_result.hpp"
#include "io/results/file/write_result.hpp"
#include "io/runs/tangent.hpp"
#include "io/studies/sensitivity/sensitivity.hpp"

#include <exception>
#include <functional>
#include <map>
#include <optional>

namespace netloft::python {

/// How a scene is solved.
struct SolveRequest {
  std::vector<double> start = {};  // initial positions of the nodes, 3 per node [m]; empty: those of the
                                   // scene
  std::shared_ptr<const runs::PreparedScene> like = {};  // a scene whose mesh topology is used; nullptr: none
  bool with_mesh_errors = false;                         // solve on two more meshes to estimate mesh errors
  std::function<void(const IterationRecord&)> on_iteration = {};
};

/// An output of the elements of one part, such as the tension of the bars of a rope.
struct PartOutput {
  std::string name, unit, doc;
  std::vector<double> values;  // one per element
};

/// The elements of one type in one part.
struct PartElements {
  std::string part, type;
  std::size_t corners = 0;           // nodes per element
  std::vector<std::uint32_t> nodes;  // [element][corner]
  std::vector<PartOutput> outputs;
};

/// The exact tangent K [N/m] at the answer, in compressed columns; only the lower triangle if symmetric.
struct TangentMatrix {
  std::vector<double> values;
  const SparsePattern& pattern;
};

/// A scene, and the point at which the search for its equilibrium ended.
class Answer {
 public:
  /// Solves the scene. `interrupt` ends the search with the state so far. Throws WrongScene, and
  /// std::invalid_argument if the start does not fit.
  Answer(const OpenedScene& source, const SolveRequest& request, const std::atomic<bool>& interrupt);

  const std::shared_ptr<runs::PreparedScene>& scene() const { return scene_; }
  const results::Result& result() const { return result_; }
  const Solution& solution() const { return solution_; }
  /// Positions of the nodes, 3 per node [m].
  const std::vector<double>& points() const { return points_; }
  const std::vector<PartElements>& elements() const { return elements_; }
  /// The last exception that a solver or a strategy in Python raised; nullptr if there was none.
  const std::exception_ptr& raised() const { return raised_; }

  /// The residual over the unknowns at displacements u [N]. Throws std::invalid_argument if forces are not
  /// defined there, or if u has the wrong length.
  std::vector<double> residual(const std::vector<double>& u);
  TangentMatrix tangent();
  /// K⁻¹ b, or K⁻ᵀ b if `transposed`. K is factorised at the first call. Throws std::invalid_argument if b
  /// has the wrong length or K cannot be factorised.
  std::vector<double> solve(const std::vector<double>& b, bool transposed);
  /// The derivatives of all figures with respect to these numbers (paths as for `--to`), or with respect to
  /// all numbers of the scene if there are no paths.
  studies::Sensitivities sensitivities(const std::vector<std::string>& paths, bool with_long_step,
                                       const std::atomic<bool>& interrupt);
  /// Writes the result file that `netloft run` writes.
  void write(const std::filesystem::path& path);

 private:
  void require_unknowns(const std::vector<double>& values, const char* what) const;
  void find_elements();
  void find_mesh_errors(const std::atomic<bool>& interrupt);

  std::shared_ptr<runs::PreparedScene> scene_;
  Solution solution_;
  results::Result result_;
  std::vector<double> points_;
  std::vector<PartElements> elements_;
  std::string started_;
  std::exception_ptr raised_;
  std::vector<std::string> command_;        // the command line that solves the same scene
  std::unique_ptr<runs::Tangent> tangent_;  // nullptr until first used
};

}  // namespace netloft::python
