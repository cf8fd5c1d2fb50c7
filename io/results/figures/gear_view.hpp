// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/vec3.hpp>

#include <functional>
#include <optional>
#include <unordered_map>

#include "framework/registry/element_outputs.hpp"
#include "io/results/figures/gear_figures.hpp"

namespace netloft::results {

using Vector = Vec3<double>;

/// Gives access to a response (outputs and forces of elements) by parts of the gear: for example, positions
/// along a rope or outputs of a panel.
class GearView {
 public:
  /// The arguments must outlive this object.
  GearView(const scenes::LoadedScene& loaded, const Assembler& assembler, const Response& answer);

  const scenes::LoadedScene& loaded() const { return loaded_; }
  const scenes::GearInScene& gear() const { return *loaded_.gear; }
  const Assembler& assembler() const { return assembler_; }
  const Response& answer() const { return answer_; }
  double times() const { return gear().times; }
  bool is_half() const { return gear().times == 2; }

  const std::string& name(std::uint32_t part) const { return loaded_.scene.parts[part].name; }
  /// The index of the part that is the rope with this name; nullptr if there is none.
  const std::uint32_t* find_rope(const std::string& name) const;

  Vector at(std::uint32_t node) const;
  /// Nodes of a rope from its start to its end.
  const std::vector<std::uint32_t>& nodes_of(std::uint32_t rope) const { return loaded_.parts[rope].nodes; }
  /// Unstretched lengths of the rope's bars [m]; all 1 if its elements have no such data.
  std::vector<double> rest_lengths(std::uint32_t rope) const;
  /// The middle of a rope that runs from port to starboard. In a half gear the rope starts there.
  Vector middle_of(std::uint32_t rope) const;

  /// One output of all elements of a part, in their order; empty if the elements have no output with this
  /// name and unit.
  std::vector<double> output(std::uint32_t part, const KnownOutput& known) const;
  /// For each element of the part, its first output that is a tension [N].
  std::vector<double> tensions(std::uint32_t part) const;
  /// The largest tension of the twines of a bar in a panel [N]; NaN if the elements have no such output.
  double largest_twine_tension(std::uint32_t panel) const;
  /// A condition on a force, such as PartForce::is_drag.
  using Kind = std::function<bool(const PartForce&)>;
  /// Sum of the forces on a part that meet a condition [N]; in a half gear, on the modelled half.
  Vector force(const std::string& part, const Kind& is_of_kind) const;
  bool has_force(const std::string& part, const Kind& is_of_kind) const;

  /// Unit vector of the current at a place; in still water it points aft (along x).
  Vector current_at(const Vector& place) const;

 private:
  const std::vector<const PartForce*>& forces_on(const std::string& part) const;
  template <class IsWanted>
  std::vector<double> first_output(std::uint32_t part, const IsWanted& is_wanted) const;

  const scenes::LoadedScene& loaded_;
  const Assembler& assembler_;
  const Response& answer_;
  std::unordered_map<std::string, std::vector<const PartForce*>> forces_;  // by part
};

/// The force on the whole gear, from the force on the modelled part: half of the gear (`times` = 2) or the
/// whole gear (`times` = 1).
Vector whole_of(const Vector& modelled, double times);

/// Height of the seabed at a place [m]: of the scene's bed or, if the scene has none, of the bed that the
/// parameters of a part describe; nullopt without a bed.
std::optional<double> bed_below(const Vector& place, const Scene& scene);

void add_mouth_figures(const GearView& gear, std::vector<Figure>& figures);
/// Adds figures of the water inside the bag, if a flow (ext/flow.h) computes how much the bag slows it.
void add_water_figures(const GearView& gear, std::vector<Figure>& figures);
void add_rope_figures(const GearView& gear, std::vector<Figure>& figures);
/// Adds figures of pairs of bodies. These use the figures that add_body_figures() must have added before.
void add_pair_figures(const GearView& gear, std::vector<Figure>& figures);
void add_towing_figures(const GearView& gear, std::vector<Figure>& figures);
void add_force_figures(const GearView& gear, std::vector<Figure>& figures);
void add_ground_figures(const GearView& gear, std::vector<Figure>& figures);
void add_netting_figures(const GearView& gear, std::vector<Figure>& figures);
/// Adds figures of rigid bodies; works for every scene with rigid bodies, with or without a net plan.
void add_body_figures(const scenes::LoadedScene& loaded, const Assembler& assembler, const Response& answer,
                      std::vector<Figure>& figures);

}  // namespace netloft::results
