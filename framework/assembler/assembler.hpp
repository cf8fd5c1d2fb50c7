// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/faults.hpp"
#include "framework/assembler/layout.hpp"
#include "framework/assembler/placement.hpp"
#include "framework/assembler/request.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace netloft {

class ElementReports;

/// Sums the energy, the residual and the matrix over all elements of a scene. Vectors over all degrees of
/// freedom ("dofs") have the order of `numbering()`. An evaluation allocates no memory.
class Assembler : public Placement {
 public:
  /// If the elements of another assembler, `like`, connect the same nodes, the layout and the tiles of `like`
  /// are used again, which halves the time of the construction. `like` may be destroyed afterwards.
  Assembler(const Scene& scene, const ScenePlan& plan, int threads, const Assembler* like = nullptr);
  ~Assembler();
  Assembler(const Assembler&) = delete;
  Assembler& operator=(const Assembler&) = delete;

  const SparsePattern& pattern() const { return layout_->pattern; }
  /// Length of the array of matrix values. The array stores whole 3 x 3 blocks of node pairs, and is
  /// therefore longer than the number of entries of the sparsity pattern.
  std::size_t value_slots() const;
  std::span<const std::unique_ptr<ElementFamily>> families() const { return families_; }
  /// Threads among which an evaluation is divided; 1 if the scene is too small to gain from more.
  int threads_used() const;

  /// Computes the sums of `request` at positions x (over all dofs). Returns false if an element could not be
  /// evaluated: see fault().
  bool evaluate(std::span<const double> x, const Request& request);
  /// Evaluates single terms and elements for reports.
  ElementReports& reports();
  const ElementFault& fault() const;
  /// The name of the element at fault: "net element 17".
  std::string fault_place(const Scene& scene) const;
  std::string fault_sentence(const Scene& scene) const;
  /// The name of a node: "net node 17", or "catch front" for unknowns that the elements of a part share.
  std::string node_name(const Scene& scene, std::uint32_t node) const;

  /// Writes the unknowns that the elements of a part share into the displacements u. Their values are those
  /// of another mesh of the same gear, whose assembler is `from` and whose positions are x.
  void take_shared_unknowns(const Assembler& from, std::span<const double> x, std::span<double> u) const;

  /// Accepts the positions x: every element updates its memory, for instance of the place where it sticks to
  /// the ground. An evaluation reads the memories and does not change them. The constructor stores the
  /// memories of the initial positions. Returns false and changes nothing if an element could not be
  /// evaluated: see fault().
  bool remember(std::span<const double> x, const Kinematics& motion = {});
  /// The memories of all elements in one array, so that a run can save them and a later run restore them.
  std::vector<double> memory() const;
  void set_memory(std::span<const double> kept);
  /// Updates the rates at which members (twines, ropes) stretch, after an accepted step that ends at `time`
  /// [s]. The damping of members depends on these rates. See (3) of mean_of_members.hpp, where ν is `memory`.
  /// Returns false if an element fails to write its members.
  bool remember_stretch(const StepEnds& ends, double memory, double time);

  /// Writes 3 x 3 blocks of the mass matrix, row by row [kg]: first a block for each node, along the axes of
  /// its unknowns, then a block for each body, which couples the origin of the body with its rotation.
  /// `coupled` receives the largest entry of the mass matrix that is in none of these blocks. Returns false
  /// if an element could not be evaluated: see fault().
  bool masses(std::span<const double> x, std::span<double> blocks, double& coupled);
  /// Length of `blocks` in masses().
  std::size_t mass_numbers() const { return 3 * numbering_.dofs() + 9 * bodies_.pairs().size(); }

 private:
  struct Elements;
  struct Parts;
  Assembler(const Scene& scene, const ScenePlan& plan, int threads, Elements elements);

  std::vector<std::unique_ptr<ElementFamily>> families_;
  std::shared_ptr<const Layout> layout_;
  std::unique_ptr<Parts> parts_;
};

}  // namespace netloft
