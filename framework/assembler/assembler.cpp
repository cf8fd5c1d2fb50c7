// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/assembler.hpp"

#include "framework/assembler/carried_nodes.hpp"
#include "framework/assembler/changed_water.hpp"
#include "framework/assembler/element_memory.hpp"
#include "framework/assembler/masses.hpp"
#include "framework/assembler/reports.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <utility>

namespace netloft {

namespace {

/// Whether a family (all elements of one type) can be left out. It can if all its terms are off and its
/// elements (such as bending) only add forces to elements of another type (such as bars).
bool is_idle(const Scene& scene, const FamilyPlan& family) {
  return scene.parts[family.parts[0]].companion &&
         std::none_of(family.terms.begin(), family.terms.end(), [](const TermPlan& t) { return t.on; });
}

const ElementFamily& family_of_part(std::uint32_t part,
                                    std::span<const std::unique_ptr<ElementFamily>> families) {
  return **std::ranges::find_if(
      families, [&](const auto& family) { return std::ranges::count(family->parts(), part) > 0; });
}

/// If a flow (ext/flow.h) changes the water of a family in `bases`, adds a family that evaluates the drag in
/// the changed water.
void add_drag_in_flows(const Scene& scene,
                       const std::vector<std::pair<const FamilyPlan*, const ElementFamily*>>& bases,
                       std::vector<std::unique_ptr<ElementFamily>>& families) {
  for (const auto& base : bases) {
    const FamilyPlan& plan = *base.first;
    const auto is_there = [&](const TermPlan& t) { return t.on && is_in_changed_water(plan, t); };
    if (std::ranges::any_of(plan.terms, is_there))
      families.push_back(
          std::make_unique<ElementFamily>(scene, plan, *base.second, family_of_part(*plan.flow, families)));
  }
}

/// Makes the families (all elements of one type each) that have active terms, in the order of the plan, then
/// the families for the drag in flows. The nodes of unknowns that a part shares are numbered after the nodes
/// of the scene and the nodes of the bodies' rotations.
std::vector<std::unique_ptr<ElementFamily>> make_families(const Scene& scene, const ScenePlan& plan) {
  std::vector<std::unique_ptr<ElementFamily>> families;
  std::vector<std::pair<const FamilyPlan*, const ElementFamily*>> bases;
  std::size_t nodes = scene.node_count() + scene.bodies.size();
  for (const auto& family : plan.families) {
    if (is_idle(scene, family)) continue;
    families.push_back(std::make_unique<ElementFamily>(scene, family, static_cast<std::uint32_t>(nodes)));
    bases.emplace_back(&family, families.back().get());
    nodes += families.back()->global_nodes().size();
  }
  add_drag_in_flows(scene, bases, families);
  return families;
}

/// Returns a scene that has all nodes but no parts: the nodes of `scene`, one node for the rotation of each
/// body, and the nodes of the families' shared unknowns.
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

}  // namespace

/// The objects that carry out the steps of an evaluation.
struct Assembler::Parts {
  Parts(const Scene& scene, const ScenePlan& plan, int threads, ElementTiles made, std::size_t dofs,
        Bodies& bodies, const Frames& frames)
      : tiles(std::move(made)),
        elements(scene, plan, tiles, threads),
        carried(bodies, elements, plan.tangent, dofs),
        reports(elements, bodies, frames) {}
  ElementTiles tiles;
  TileEvaluator elements;
  CarriedNodes carried;
  ElementReports reports;
};

/// The families of a scene (all elements of one type each), with all nodes that they use and the layout of
/// matrix values. If another assembler has the same layout, its tiles `tiles_like` are used again.
struct Assembler::Elements {
  Elements(const Scene& scene, const ScenePlan& plan, const Assembler* like)
      : families(make_families(scene, plan)), nodes(with_global_nodes(scene, families)) {
    if (like && is_layout_of(*like->layout_, like->families_, families, nodes, plan.symmetric)) {
      layout = like->layout_;
      tiles_like = &like->parts_->tiles;
    } else {
      layout = make_layout(families, nodes, plan.symmetric);
    }
  }
  ElementTiles make_tiles(Families own, const Numbering& numbering) const {
    return tiles_like ? tiles_of(own, *tiles_like)
                      : make_element_tiles(own, nodes, numbering, layout->blocks, layout->pattern);
  }
  std::vector<std::unique_ptr<ElementFamily>> families;
  Scene nodes;
  std::shared_ptr<const Layout> layout;
  const ElementTiles* tiles_like = nullptr;
};

Assembler::Assembler(const Scene& scene, const ScenePlan& plan, int threads, const Assembler* like)
    : Assembler(scene, plan, threads, Elements(scene, plan, like)) {}

Assembler::Assembler(const Scene& scene, const ScenePlan& plan, int threads, Elements made)
    : Placement(scene, made.nodes, made.layout->blocks, plan.symmetric),
      families_(std::move(made.families)),
      layout_(made.layout),
      parts_(std::make_unique<Parts>(scene, plan, threads, made.make_tiles(families_, numbering_),
                                     numbering_.dofs(), bodies_, frames_)) {
  remember(start());
}

Assembler::~Assembler() = default;

std::size_t Assembler::value_slots() const { return parts_->tiles.values; }
int Assembler::threads_used() const { return parts_->elements.threads_used(); }
ElementReports& Assembler::reports() { return parts_->reports; }

bool Assembler::evaluate(std::span<const double> x, const Request& request) {
  assert(is_over_dofs(x));
  assert((request.matrix == MatrixKind::none) == !request.values && "a matrix is asked for with its values");
  assert((request.residual || !request.gradient) && "a gradient is computed together with a residual");
  assert((!request.between || !request.gradient) && "mean forces of a step are not a gradient");
  for (double* forces : {request.residual, request.gradient})
    if (forces) std::fill_n(forces, numbering_.dofs(), 0.0);
  if (request.values) std::fill_n(request.values, value_slots(), 0.0);
  if (!parts_->elements.run(x, request) || !parts_->carried.pass_on(x, request)) return false;
  for (double* forces : {request.residual, request.gradient})
    if (forces) frames_.turn(forces);
  if (request.values) frames_.turn_matrix(request.values);
  if (request.energy) *request.energy = parts_->elements.energy();
  return true;
}

const ElementFault& Assembler::fault() const { return parts_->elements.fault(); }

std::string Assembler::fault_place(const Scene& scene) const {
  return place_of(fault(), *families_[fault().family], scene);
}

std::string Assembler::fault_sentence(const Scene& scene) const {
  return sentence_of(fault(), *families_[fault().family], scene);
}

std::string Assembler::node_name(const Scene& scene, std::uint32_t node) const {
  if (node < scene.node_count()) return scene.node_name(node);
  if (const std::size_t body = node - scene.node_count(); body < scene.bodies.size())
    return scene.bodies[body].name + " attitude";
  for (const auto& family : families_)
    for (std::size_t p = 0; p < family->global_nodes().size(); ++p)
      if (family->global_nodes()[p].node == node)
        return scene.parts[family->parts()[p]].name + " " + family->type().globals[0].name;
  return "no node";
}

namespace {

/// Returns the nodes of the unknowns that the elements of a part share, by element type and part.
std::map<std::pair<std::string, std::uint32_t>, std::uint32_t> shared_nodes(const Assembler& assembler) {
  std::map<std::pair<std::string, std::uint32_t>, std::uint32_t> nodes;
  for (const auto& family : assembler.families())
    for (std::size_t p = 0; p < family->global_nodes().size(); ++p)
      nodes[{family->type().type, family->parts()[p]}] = family->global_nodes()[p].node;
  return nodes;
}

}  // namespace

void Assembler::take_shared_unknowns(const Assembler& from, std::span<const double> x,
                                     std::span<double> u) const {
  const auto others = shared_nodes(from);
  for (const auto& [part, node] : shared_nodes(*this)) {
    const auto other = others.find(part);
    if (other == others.end()) continue;
    for (int axis = 0; axis < 3; ++axis)
      if (const std::size_t at = numbering_.dof(node, axis).at(); at < u.size())
        u[at] = x[from.numbering().dof(other->second, axis).at()] - start()[at];
  }
}

bool Assembler::remember(std::span<const double> x, const Kinematics& motion) {
  assert(is_over_dofs(x));
  return netloft::remember(parts_->elements, x, motion);
}

std::vector<double> Assembler::memory() const { return read_memory(parts_->elements); }
void Assembler::set_memory(std::span<const double> kept) { write_memory(parts_->elements, kept); }

bool Assembler::remember_stretch(const StepEnds& ends, double memory, double time) {
  return parts_->elements.mean_forces().remember(ends, memory, time);
}

bool Assembler::masses(std::span<const double> x, std::span<double> blocks, double& coupled) {
  assert(is_over_dofs(x) && blocks.size() == mass_numbers());
  std::fill(blocks.begin(), blocks.end(), 0.0);
  MassBlocks masses{blocks.first(3 * numbering_.dofs()), blocks.subspan(3 * numbering_.dofs())};
  const bool done = add_masses(parts_->elements, bodies_.pairs(), x, masses);
  coupled = masses.coupled;
  if (!done) return false;
  if (!bodies_.empty()) bodies_.hand_on_masses(x, masses.nodes, masses.between);
  for (const auto& [node, Q] : axes_) turn_mass(Q, &blocks[9 * std::size_t{node}]);
  return true;
}

}  // namespace netloft
