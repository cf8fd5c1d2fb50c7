// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/law_watch.hpp"
#include "framework/scene/scene_plan.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <memory>
#include <string_view>
#include <utility>

namespace netloft {

class ChangedWater;

/// The node whose three coordinates are the rotation of a body. Rotation nodes are numbered after the nodes
/// of the scene.
inline std::uint32_t rotation_node(const Scene& scene, std::size_t body) {
  return static_cast<std::uint32_t>(scene.node_count() + body);
}

/// All elements of one type in a scene, made by their plugin from the nodes of the scene. Elements are in the
/// order of the parts and, within a part, in the order of its element list.
class ElementFamily {
 public:
  /// Some unknowns, such as the front of a catch, are shared by all elements of a part. They are the
  /// coordinates of an additional node for each part; these nodes are numbered from `first_global_node` on.
  /// Throws SceneError if parameters or data are wrong or the plugin refuses an element.
  ElementFamily(const Scene& scene, const FamilyPlan& plan, std::uint32_t first_global_node = 0);
  /// The drag of the elements of `base` in the water of the flow `flow`, both of which must outlive this
  /// object. The unknowns of the flow are the last node of each element.
  ElementFamily(const Scene& scene, const FamilyPlan& plan, const ElementFamily& base,
                const ElementFamily& flow);
  ~ElementFamily();
  ElementFamily(const ElementFamily&) = delete;
  ElementFamily& operator=(const ElementFamily&) = delete;

  const ElementType& type() const { return *type_; }
  std::size_t size() const { return part_.size(); }
  int nodes_per_element() const { return type_->nodes(); }
  /// Number of nodes of an element, including the node for the rotation of its body and, as the last one, the
  /// node for unknowns that its part shares, if it has them.
  int all_nodes_per_element() const { return type_->dofs() / 3; }
  std::uint32_t node(std::size_t element, int corner) const {
    assert(element < size() && corner >= 0 && corner < all_nodes_per_element());
    return nodes_[element * static_cast<std::size_t>(all_nodes_per_element()) +
                  static_cast<std::size_t>(corner)];
  }
  /// The scene part to which an element belongs.
  std::uint32_t part(std::size_t element) const { return parts_[part_[element]]; }
  const std::vector<std::uint32_t>& parts() const { return parts_; }
  /// Viscosity of the water at the parts of the family, divided by the viscosity of the scene's water.
  double viscosity_ratio() const { return viscosity_ratio_; }
  /// First element of each part, and one past the last.
  const std::vector<std::size_t>& part_begin() const { return part_begin_; }
  /// The elements of a scene part, from the first to one past the last; none if the part has no elements
  /// here.
  std::pair<std::size_t, std::size_t> elements_of(std::uint32_t scene_part) const {
    const auto at = static_cast<std::size_t>(std::ranges::find(parts_, scene_part) - parts_.begin());
    if (at == parts_.size()) return {};
    return {part_begin_[at], part_begin_[at + 1]};
  }
  const void* self() const { return self_; }
  /// The family whose drag these elements evaluate once more, in water that a flow changes; nullptr if this
  /// is an ordinary family.
  const ElementFamily* repeated() const;
  /// The arm of the body to which an element belongs: the length that multiplies rotations, so that the
  /// unknowns are lengths [m].
  double arm(std::size_t element) const {
    assert(element < arms_.size());
    return arms_[element];
  }
  /// Evaluates a term or the outputs on a tile, in a call that is recorded (plugin_call.hpp). If the plugin
  /// breaks a rule of the plugin interface, a term returns ERROR, and the outputs throw std::runtime_error.
  int evaluate(const netloft_term& term, netloft_tile& tile) const;
  int output(netloft_tile& tile, double* values) const;
  /// Computes the velocity of the water at up to 64 places. The elements must be a flow.
  int find_water(netloft_flow_tile& tile) const;

  /// The numbers of a table parameter of a scene part, in the memory that elements read; empty if the part
  /// has no such table.
  std::span<double> table(std::uint32_t scene_part, std::string_view parameter) const;
  /// Adds to `times` the times [s] at which parameters given over time have samples.
  void add_corners_in_time(std::vector<double>& times) const;

  /// The shared unknowns of a part: one node per part, none if the type has no shared unknowns.
  struct GlobalNode {
    std::uint32_t node;
    std::array<double, 3> start;
    std::uint8_t held;  // coordinates that are not unknowns
  };
  const std::vector<GlobalNode>& global_nodes() const { return global_nodes_; }

  const std::vector<netloft_term>& active_terms() const { return terms_; }
  /// The terms that act only if the gear moves. A static analysis needs them only for derivatives of the
  /// forces with respect to velocities or accelerations.
  const std::vector<netloft_term>& terms_of_motion() const { return terms_of_motion_; }
  /// One watch for each law that the elements call.
  const std::vector<std::unique_ptr<LawWatch>>& law_watches() const;
  /// Whether an active term has `trait`. Such traits declare which inputs of the host a term reads.
  bool reads(std::uint32_t trait) const {
    for (const auto& term : terms_)
      if (term.traits & trait) return true;
    return false;
  }

 private:
  void gather_parameters(const Scene& scene);
  void gather_laws(const Scene& scene, const FamilyPlan& plan);
  void gather_elements(const Scene& scene);
  void gather_nodes(const Scene& scene, std::uint32_t first_global_node);
  void add_body_of(const Scene& scene, std::uint32_t origin, const Part& part);
  void create(const Scene& scene);
  void gather_globals(const Scene& scene, std::uint32_t first_node);
  std::vector<double> gather_datum(const Scene& scene, const netloft_datum& datum) const;

  const ElementType* type_;
  std::vector<std::uint32_t> parts_;  // scene parts
  double viscosity_ratio_ = 1;
  std::vector<std::size_t> part_begin_;      // first element of each part, and one past the last
  std::vector<std::uint32_t> part_, nodes_;  // for each element: index in parts_; its nodes
  std::vector<double> arms_;                 // arm of each element on a body [m]
  std::vector<ParameterBlock> parameters_, law_parameters_;
  std::vector<netloft_bound_law> laws_;
  std::vector<std::unique_ptr<LawWatch>> watches_;
  std::vector<netloft_term> terms_, terms_of_motion_;
  std::vector<double> global_starts_;  // [part][global]
  std::vector<GlobalNode> global_nodes_;
  void* self_ = nullptr;
  std::unique_ptr<const ChangedWater> changed_water_;  // nullptr: the elements see the water of the scene
};

}  // namespace netloft
