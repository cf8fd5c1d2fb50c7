// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/between.hpp"
#include "framework/assembler/memory.hpp"
#include "framework/assembler/placement.hpp"
#include "framework/assembler/riders.hpp"
#include "framework/assembler/workers.hpp"

#include <memory>
#include <span>

namespace netloft {

enum class MatrixKind { none, exact, convex, metric };

/// The motion of a scene during an evaluation: rates over all dofs (null at rest), the factors of the matrix
/// cu ∂r/∂x + cv ∂r/∂v + ca ∂r/∂a, and the low-order part of the positions if it is known.
struct Kinematics {
  double time = 0;                          // [s]
  const double *v = nullptr, *a = nullptr;  // [m/s], [m/s²]
  double cu = 1, cv = 0, ca = 0;
  const double* x_low = nullptr;  // over all dofs: low-order part of the positions [m]
};

/// What an evaluation adds up. Null or none: not wanted, not computed.
struct Request {
  double* energy = nullptr;        // one number [J]
  bool conservative_only = false;  // leave out forces that have no energy: the residual is its gradient
  std::uint32_t without = 0;       // terms with any of these traits are left out
  double* residual = nullptr;      // over all dofs: unknowns, then reactions of held ones, +dE/dx [N]
  double* gradient = nullptr;      // beside the residual: its part from forces that have an energy [N]
  MatrixKind matrix = MatrixKind::none;
  double* values = nullptr;  // Assembler::value_slots() long [N/m]
  Kinematics motion = {};
  const StepEnds* between = nullptr;  // mean forces of this step, whose middle the positions are
};

/// The element that could not be evaluated, and the reason.
struct ElementFault {
  int status = NETLOFT_OK;  // NETLOFT_OUTSIDE_DOMAIN or NETLOFT_ERROR
  std::size_t family = 0, element = 0;
  char message[256] = "";
};

/// The sum over all families of a scene. It gathers positions, evaluates active terms on tiles of 64
/// elements, those of all families on the same nodes, and scatters. Vectors over all dofs are in the order of
/// `numbering()`. Evaluation allocates nothing.
class Assembler : public Placement {
 public:
  Assembler(const Scene& scene, const ScenePlan& plan, int threads);
  ~Assembler();
  Assembler(const Assembler&) = delete;
  Assembler& operator=(const Assembler&) = delete;

  const SparsePattern& pattern() const { return pattern_; }
  std::size_t value_slots() const { return value_slots_; }
  std::span<const std::unique_ptr<ElementFamily>> families() const { return families_; }
  /// Threads among which an evaluation is divided; 1 if the scene is too small to gain from more.
  int threads_used() const;

  /// Evaluates at positions x (over all dofs). Returns false if an element could not be evaluated: see
  /// fault().
  bool evaluate(std::span<const double> x, const Request& request);
  const ElementFault& fault() const { return fault_; }
  /// The name of a node: "net node 17", or "catch front" for shared unknowns of a part.
  std::string node_name(const Scene& scene, std::uint32_t node) const;
  /// The name of the element at fault: "net element 17".
  std::string fault_place(const Scene& scene) const;
  std::string fault_sentence(const Scene& scene) const;

  /// Makes every element remember positions x as the last accepted step. Evaluations do not change this
  /// memory. At first the elements remember the start. If it returns false, nothing has changed: see fault().
  bool remember(std::span<const double> x, const Kinematics& motion = {});
  /// The memory of all elements, one after another, so that it can be saved and restored.
  std::vector<double> memory() const;
  void set_memory(std::span<const double> kept);
  /// Makes members remember how fast they were stretched in an accepted step, (4) of between.hpp. False: an
  /// element does not tell its members.
  bool remember_stretch(const StepEnds& ends, double memory, double time);

  /// Force of one active term alone, as a residual over all dofs. Returns false on failure: see fault().
  bool evaluate_term(std::span<const double> x, std::size_t family, std::size_t term,
                     std::span<double> residual, const Kinematics& motion = {});
  /// Energy of one active term alone [J]; zero if it has none. Returns false on failure: see fault().
  bool term_energy(std::span<const double> x, std::size_t family, std::size_t term, double& energy,
                   const Kinematics& motion = {});
  /// Masses of the nodes along their own axes: nine numbers each, row by row [kg], and behind them of each
  /// body nine numbers between its origin and its rotation. `coupled` is the largest entry between other
  /// nodes; these blocks leave such entries out. Returns false on failure: see fault().
  bool masses(std::span<const double> x, std::span<double> blocks, double& coupled);
  /// Numbers in `blocks` of masses().
  std::size_t mass_numbers() const { return 3 * numbering_.dofs() + 9 * bodies_.pairs().size(); }
  /// Force of one active term summed per part of the family, +dE/dx [N]: 3 numbers per part.
  bool sum_term(std::span<const double> x, std::size_t family, std::size_t term, std::span<double> sums,
                const Kinematics& motion = {});
  /// What the elements ask of laws at positions x, and how much of it lies outside the ranges that these were
  /// measured in: one entry per family and law, without those that have no range.
  std::vector<LawUse> find_law_use(std::span<const double> x, const Kinematics& motion = {});
  /// The same of the forces on some nodes alone, in `groups`: per node of the scene the number of a group, or
  /// none, a negative one. 3 numbers for every part and group.
  bool sum_term_at(std::span<const double> x, std::size_t family, std::size_t term,
                   std::span<const std::int32_t> groups, std::size_t group_count, std::span<double> sums,
                   const Kinematics& motion = {});
  /// Outputs of a family: [output][element], NaN where an output could not be computed; the result is then
  /// false.
  bool outputs(std::span<const double> x, std::size_t family, std::vector<std::vector<double>>& values,
               const Kinematics& motion = {});

  /// Positions of a tile's nodes, [dof][64] [m].
  struct EndsOfTile {
    const double *before, *after, *middle;
  };

  /// A term with an energy in one lane of a step, (2) of between.hpp.
  struct MeanOfLane {
    double way[12] = {}, force[12] = {}, later[12] = {}, g[12] = {};  // Δ, ∇E(x), ∇E(x₁), P Δ
    double work = 0, square = 0, mu = 0;  // ∇E·Δ, g·g, μ; zero: nothing is missing
  };

 private:
  struct Workspace;
  Assembler(const Scene& scene, const ScenePlan& plan, int threads,
            std::vector<std::unique_ptr<ElementFamily>> families);
  /// `nodes` are those of the scene and of the families' shared unknowns.
  Assembler(const Scene& scene, const Scene& nodes, const ScenePlan& plan, int threads,
            std::vector<std::unique_ptr<ElementFamily>>&& families);
  Assembler(const Scene& scene, const Scene& nodes, const NodeBlocks& blocks, const ScenePlan& plan,
            int threads, std::vector<std::unique_ptr<ElementFamily>>&& families);
  void make_memories(bool between);
  bool run_group(const FamilyGroup& group, std::span<const double> x, const Request& request);
  void run_tile(const FamilyGroup& group, std::size_t tile, std::span<const double> x, const Request& request,
                Workspace& w);
  bool call_families(const FamilyGroup& group, std::size_t tile, bool with_energy, const Request& request,
                     Workspace& w);
  int call_terms(const ElementFamily& family, bool with_energy, netloft_tile& tile, const Request& request,
                 Workspace& w);
  int call_each(const ElementFamily& family, const std::vector<netloft_term>& terms, bool with_energy,
                netloft_tile& tile, const Request& request, Workspace& w);
  int call_matrix_term(const ElementFamily& family, const netloft_term& term, netloft_tile& tile,
                       MatrixKind kind, Workspace& w);
  void scatter(const FamilyGroup& group, std::size_t tile, const Request& request, Workspace& w);
  void scatter_gradient(const Tiling& tiling, std::size_t tile, double* gradient, Workspace& w);
  void scatter_matrix(const Tiling& tiling, std::size_t tile, double* values, Workspace& w);
  const FamilyGroup& group_of(std::size_t family) const;
  void gather(const FamilyGroup& group, std::size_t tile, std::span<const double> x, const Kinematics& motion,
              Workspace& w) const;
  netloft_tile make_tile(std::size_t family, std::size_t tile, const Kinematics& motion, Workspace& w) const;
  bool hand_on(std::span<const double> x, const Request& request);
  bool run_carried(std::span<const double> x, const Request& request);
  bool find_rate_matrices(std::span<const double> x, Request request, BodyMatrices& matrices);
  void gather_current(const Tiling& tiling, std::size_t tile, double time, Workspace& w) const;
  void fill_current(double time, Workspace& w) const;
  void gather_positions(const Tiling& tiling, std::size_t tile, const double* x, double* to) const;
  void gather_ends(const FamilyGroup& group, std::size_t tile, const StepEnds& ends, Workspace& w) const;
  int add_mean_forces(std::size_t family, std::size_t tile, const netloft_tile& t, const Request& request,
                      Workspace& w);
  int add_mean_of_members(std::size_t family, std::size_t tile, const netloft_tile& t, const Request& request,
                          Workspace& w);
  int add_mean_of_energy(const ElementFamily& f, const netloft_term& term, const netloft_tile& t,
                         const Request& request, Workspace& w);
  MeanOfLane read_mean(const ElementFamily& f, const netloft_term& term, std::size_t lane,
                       const Workspace& w) const;
  void add_mean_of_lane(const ElementFamily& f, const netloft_term& term, const netloft_tile& t,
                        const Request& request, bool has_slope, std::size_t lane, Workspace& w);
  bool remember_stretch(std::size_t family, const FamilyGroup& group, std::size_t tile, const StepEnds& ends,
                        double memory, double time);
  void gather_waves(const Tiling& tiling, std::size_t tile, double time, Workspace& w) const;
  void gather_bed(const Tiling& tiling, std::size_t tile, Workspace& w) const;
  template <class Evaluate, class Visit>
  bool visit_tiles(std::span<const double> x, const Kinematics& motion, std::size_t family,
                   const Evaluate& evaluate, const Visit& visit);
  bool remember_family(std::size_t family, std::span<const double> x, const Kinematics& motion);
  bool add_masses(std::span<const double> x, std::size_t family, std::span<double> blocks, double& coupled);
  void report(std::size_t family, const netloft_tile& tile, int status, Workspace& w);
  bool collect_faults();

  SceneWater water_;
  Current current_;
  std::shared_ptr<const WaterField> waves_;  // null in statics, too
  std::array<double, 3> ground_;
  SeaBed bed_;
  bool ground_passes_;
  TangentChoice tangent_;
  std::vector<std::unique_ptr<ElementFamily>> families_;
  SparsePattern pattern_;
  std::vector<FamilyGroup> groups_;
  std::vector<Memory> memories_;       // per family
  std::vector<Memory> stretch_rates_;  // per family, of members [m/s]; empty but for mean forces of steps
  std::size_t value_slots_ = 0;
  std::vector<double> tile_energy_, body_forces_, damping_values_, mass_values_;
  Workers workers_;
  std::vector<std::unique_ptr<Workspace>> workspaces_;
  ElementFault fault_;
};

}  // namespace netloft
