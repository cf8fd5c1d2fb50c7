// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/assembler.hpp"

#include "framework/assembler/riders.hpp"
#include "framework/assembler/workspace.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace netloft {

namespace {

// With fewer tiles of one colour than this, threads cost more than they save (bench_assembly).
constexpr std::size_t kSerialBelow = 8;

/// Whether a family of riders can be left out because all of its terms are off.
bool is_idle(const Scene& scene, const FamilyPlan& family) {
  return scene.parts[family.parts[0]].companion &&
         std::none_of(family.terms.begin(), family.terms.end(), [](const TermPlan& t) { return t.on; });
}

/// Makes the families that have active terms, in the order of the plan. Nodes for their shared unknowns are
/// numbered after those of the scene and the rotations of its bodies.
std::vector<std::unique_ptr<ElementFamily>> make_families(const Scene& scene, const ScenePlan& plan) {
  std::vector<std::unique_ptr<ElementFamily>> families;
  std::size_t nodes = scene.node_count() + scene.bodies.size();
  for (const auto& family : plan.families) {
    if (is_idle(scene, family)) continue;
    families.push_back(std::make_unique<ElementFamily>(scene, family, static_cast<std::uint32_t>(nodes)));
    nodes += families.back()->global_nodes().size();
  }
  return families;
}

/// The nodes of the scene, without its parts, followed by the rotations of its bodies and by those of the
/// families' shared unknowns.
Scene with_global_nodes(const Scene& scene, std::span<const std::unique_ptr<ElementFamily>> families) {
  Scene all;
  all.positions = scene.positions;
  all.held = scene.held;
  all.frames = scene.frames;
  all.bodies = scene.bodies;
  all.carried = scene.carried;
  if (!scene.bodies.empty()) all.carried.resize(scene.node_count());
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    RigidBody& body = all.bodies[b];
    body.rotation_node = rotation_node(scene, b);
    for (const double turn : body.rotation) all.positions.push_back(body.arm() * turn);
    all.held.push_back(body.held_rotation);
    all.carried.push_back(false);
  }
  for (const auto& family : families)
    for (const auto& shared : family->global_nodes()) {
      all.positions.insert(all.positions.end(), shared.start.begin(), shared.start.end());
      all.held.push_back(shared.held);
      if (!all.carried.empty()) all.carried.push_back(false);
    }
  return all;
}

std::size_t widest_element(std::span<const std::unique_ptr<ElementFamily>> families) {
  std::size_t dofs = 0;
  for (const auto& family : families) dofs = std::max(dofs, static_cast<std::size_t>(family->type().dofs()));
  return dofs;
}

/// What only slides on a ground that passes has no past to remember.
Memory make_memory(const ElementFamily& family, std::size_t tiles, bool ground_passes) {
  const bool reads = std::ranges::any_of(family.active_terms(), [&](const netloft_term& term) {
    return term.traits & NETLOFT_READS_STATE && !(ground_passes && term.traits & NETLOFT_READS_GROUND);
  });
  return {tiles, reads ? family.type().element.state_width : 0};
}

}  // namespace

Assembler::Assembler(const Scene& scene, const ScenePlan& plan, int threads)
    : Assembler(scene, plan, threads, make_families(scene, plan)) {}

Assembler::Assembler(const Scene& scene, const ScenePlan& plan, int threads,
                     std::vector<std::unique_ptr<ElementFamily>> families)
    : Assembler(scene, with_global_nodes(scene, families), plan, threads, std::move(families)) {}

Assembler::Assembler(const Scene& scene, const Scene& nodes, const ScenePlan& plan, int threads,
                     std::vector<std::unique_ptr<ElementFamily>>&& families)
    : Assembler(scene, nodes, make_blocks(families, nodes, plan.symmetric), plan, threads,
                std::move(families)) {}

Assembler::Assembler(const Scene& scene, const Scene& nodes, const NodeBlocks& blocks, const ScenePlan& plan,
                     int threads, std::vector<std::unique_ptr<ElementFamily>>&& families)
    : Placement(scene, nodes, blocks, plan.symmetric),
      water_(scene.water),
      current_(scene.current),
      waves_(plan.kind == AnalysisKind::dynamics ? scene.waves : nullptr),
      ground_(scene.ground),
      bed_(scene.bed),
      ground_passes_(scene.ground != std::array<double, 3>{}),
      tangent_(plan.tangent),
      families_(std::move(families)),
      pattern_(make_pattern(blocks, numbering_, plan.symmetric)),
      workers_(threads) {
  groups_ = find_family_groups(families_);
  std::size_t tiles = 0;
  for (FamilyGroup& group : groups_) {
    const ElementFamily& first = *families_[group.families.front()];
    group.tiling = make_tiling(first, nodes, numbering_, blocks, plan.symmetric, pattern_.slots + 9 * tiles);
    group.first_tile = tiles;
    tiles += group.tiling.tiles;
  }
  make_memories(plan.between);
  if (!bodies_.empty())
    for (FamilyGroup& group : groups_) group.carried_tiles = find_carried_tiles(group.tiling, nodes.carried);
  value_slots_ = pattern_.slots + 9 * tiles;
  tile_energy_.resize(tiles);
  for (std::size_t w = 0; w < workers_.size(); ++w)
    workspaces_.push_back(std::make_unique<Workspace>(widest_element(families_), plan,
                                                      current_.flows() || waves_, waves_ != nullptr));
  remember(start());
}

Assembler::~Assembler() = default;

void Assembler::make_memories(bool between) {
  for (std::size_t f = 0; f < families_.size(); ++f) {
    const std::size_t tiles = group_of(f).tiling.tiles;
    const netloft_element& element = families_[f]->type().element;
    memories_.push_back(make_memory(*families_[f], tiles, ground_passes_));
    stretch_rates_.emplace_back(tiles, between && element.members ? element.member_count : 0);
  }
}

/// The geometric term of a body needs forces, so they are evaluated even if the caller did not ask for them.
/// To keep those of the last evaluation at the same x instead would save less than 0.2 % of a search for an
/// equilibrium with otter boards (83-112-at-sea-66m, with 2000 and 8000 nodes) and 1.4 % of a motion with
/// them (dynamics/83-112-in-motion).
bool Assembler::hand_on(std::span<const double> x, const Request& request) {
  if (bodies_.empty()) return true;
  double* residual = request.residual;
  const bool exact = request.values && request.matrix == MatrixKind::exact;
  Request again{.without = request.without, .motion = request.motion, .between = request.between};
  if (!residual && exact) {
    body_forces_.assign(numbering_.dofs(), 0.0);
    again.residual = residual = body_forces_.data();
    if (!run_carried(x, again)) return false;
  }
  BodyMatrices matrices{request.values};
  if (exact && request.motion.v && tangent_ == TangentChoice::exact &&
      !find_rate_matrices(x, again, matrices))
    return false;
  const Kinematics& m = request.motion;
  const BodyMotion motion{m.v, m.a, m.cu, m.cv, m.ca};
  bodies_.hand_on(x, motion, residual, matrices, exact);
  if (request.gradient) bodies_.hand_on(x, motion, request.gradient, {}, false);
  if (request.values && request.matrix == MatrixKind::metric) bodies_.resist_turning(request.values);
  return true;
}

/// Evaluates tiles with carried nodes alone: nothing else depends on how bodies are turned.
bool Assembler::run_carried(std::span<const double> x, const Request& request) {
  for (const FamilyGroup& group : groups_)
    for (const std::uint32_t tile : group.carried_tiles) run_tile(group, tile, x, request, *workspaces_[0]);
  return collect_faults();
}

/// What turns the rates of carried nodes has turns their forces.
bool Assembler::find_rate_matrices(std::span<const double> x, Request request, BodyMatrices& matrices) {
  request.residual = nullptr;
  request.matrix = MatrixKind::exact;
  request.motion.cu = request.motion.cv = request.motion.ca = 0;
  damping_values_.assign(value_slots_, 0.0);
  mass_values_.assign(value_slots_, 0.0);
  request.values = damping_values_.data();
  request.motion.cv = 1;
  if (!run_carried(x, request)) return false;
  request.values = mass_values_.data();
  request.motion.cv = 0;
  request.motion.ca = 1;
  if (!run_carried(x, request)) return false;
  matrices.damping = damping_values_.data();
  matrices.mass = mass_values_.data();
  return true;
}

const FamilyGroup& Assembler::group_of(std::size_t family) const {
  return *std::find_if(groups_.begin(), groups_.end(), [&](const FamilyGroup& group) {
    return std::find(group.families.begin(), group.families.end(), family) != group.families.end();
  });
}

int Assembler::threads_used() const {
  for (const FamilyGroup& group : groups_)
    for (std::size_t c = 0; c + 1 < group.tiling.colour_begin.size(); ++c)
      if (group.tiling.colour_begin[c + 1] - group.tiling.colour_begin[c] >= kSerialBelow)
        return static_cast<int>(workers_.size());
  return 1;
}

bool Assembler::evaluate(std::span<const double> x, const Request& request) {
  assert(is_over_dofs(x));
  assert((request.matrix == MatrixKind::none) == !request.values && "a matrix is asked for with its values");
  assert((request.residual || !request.gradient) && "a gradient is found beside a residual");
  assert((!request.between || !request.gradient) && "mean forces of a step are the gradient of nothing");
  for (double* forces : {request.residual, request.gradient})
    if (forces) std::fill_n(forces, numbering_.dofs(), 0.0);
  if (request.values) std::fill_n(request.values, value_slots_, 0.0);
  for (const FamilyGroup& group : groups_)
    if (!run_group(group, x, request)) return false;
  if (!hand_on(x, request)) return false;
  for (double* forces : {request.residual, request.gradient})
    if (forces) frames_.turn(forces);
  if (request.values) frames_.turn_matrix(request.values);
  if (request.energy) {
    *request.energy = 0;
    for (const double e : tile_energy_) *request.energy += e;
  }
  return true;
}

bool Assembler::run_group(const FamilyGroup& group, std::span<const double> x, const Request& request) {
  const Tiling& tiling = group.tiling;
  const auto run = [&](std::size_t begin, std::size_t end) {
    workers_.run(end - begin, kSerialBelow, [&](std::size_t worker, std::size_t i) {
      run_tile(group, tiling.order[begin + i], x, request, *workspaces_[worker]);
    });
  };
  if (!request.residual && !request.values)
    run(0, tiling.tiles);  // nothing is scattered, so no two tiles can write to the same entry
  else
    for (std::size_t c = 0; c + 1 < tiling.colour_begin.size(); ++c)
      run(tiling.colour_begin[c], tiling.colour_begin[c + 1]);
  return collect_faults();
}

void Assembler::run_tile(const FamilyGroup& group, std::size_t tile, std::span<const double> x,
                         const Request& request, Workspace& w) {
  gather(group, tile, x, request.motion, w);
  if (request.between) gather_ends(group, tile, *request.between, w);
  if (request.energy) std::fill_n(w.energy, kLanes, 0.0);
  w.force.begin();
  w.packed_tangent.begin();
  w.square_tangent.begin();
  if (!call_families(group, tile, true, request, w)) return;
  if (request.gradient) scatter_gradient(group.tiling, tile, request.gradient, w);
  if (!request.conservative_only && !call_families(group, tile, false, request, w)) return;
  scatter(group, tile, request, w);
}

}  // namespace netloft
