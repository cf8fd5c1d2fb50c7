// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/meshing/division.hpp"
#include "io/gears/plan/net_plan.hpp"
#include "io/scenes/reading/gear_steps.hpp"
#include "io/scenes/reading/plan_elements.hpp"
#include "io/scenes/reading/read_bodies.hpp"

#include <map>
#include <optional>
#include <set>
#include <utility>

namespace netloft::scenes {

/// Name of the hold that keeps the middle of half a gear on the plane of symmetry.
inline constexpr const char* kPlaneOfSymmetry = "plane of symmetry";

/// Name of the hold of the blocks of the ship.
inline constexpr const char* kShip = "ship";

/// Makes the parts of a scene from its net plan: panels of triangles and ropes of bars, joined as in the
/// plan, with floats and weights. The virtual members are the steps of GearSteps, in their order.
class GearParts : public GearSteps {
 public:
  /// Reads `[gear]` and `[elements]`. `plan` must have no errors.
  GearParts(const gears::NetPlan& plan, formats::TableReader& root, const ElementChoice& choice, Draft& draft,
            GearMemory& memory);

  bool divide(const std::shared_ptr<gears::Division>& like) override;
  void read_undivided(PartReader& parts) override;
  const gears::Ship* ship() const override { return plan_.ship ? &*plan_.ship : nullptr; }
  bool has_name(const std::string& name) const override;
  void read_parts(PartReader& parts) override;
  bool is_seam(formats::TableReader& join) const override;
  void join(Joiner& joiner) const override;
  void add_pieces() override;
  std::vector<std::pair<std::string, formats::Value>> contacts(
      const std::set<std::uint32_t>& carried) const override;
  bool sinks_into_bed(const std::set<std::uint32_t>& carried) const override;
  std::optional<Bag> bag(std::string& why_not) const override;
  void add_holds() override;
  void follow_holds() override;
  void refuse_motions() const override;
  void complete_winches(Registry& registry) const override;

 private:
  const gears::GearMesh& mesh() const { return division_->mesh(); }
  bool is_carried(const std::string& rope, const std::set<std::uint32_t>& carried) const;
  bool is_carried_at(const std::string& point, const std::set<std::uint32_t>& carried) const;

  void read_bodies(PartReader& parts);
  void insert_names();
  void add_netting(const gears::GearPanel& panel, Geometry geometry, const std::vector<std::uint32_t>& nodes);
  void add_rope(const gears::GearRope& rope, const gears::RopeMesh& mesh);
  bool read_pieces(const gears::GearPieces& pieces, Part& part) const;
  void add_part(std::string_view kind, const std::string& name, const std::string& path,
                formats::Value numbers, bool is_of_catalogue, Geometry geometry,
                const std::vector<std::uint32_t>& nodes);
  /// The initial guess for the position of a body.
  BodyOfPlan place_of(const gears::GearBody& body) const;
  /// Connects the ropes that end at a body: the points of the body become the ends of these ropes. `part` is
  /// the index of the body's part.
  void tie(const gears::GearBody& body, std::size_t part);
  /// Hangs an edge of netting on the rim of a body: the nodes of the edge become points of the body.
  void hang_on_rim(std::size_t part);
  void check_rim_length(const BodyRim& rim);
  std::map<std::uint32_t, double> nodes_round(const BodyRim& rim) const;
  /// Makes a node of the gear a node of a body, and its initial position that on the body.
  void tie_point(std::size_t part, std::size_t own_node, std::uint32_t gear_node);
  void add_parts();
  /// Records that a part has a node of the gear.
  void own(std::uint32_t gear_node, const Joiner::OwnNode& node);
  const gears::RopeMesh* rope_of_role(const std::string& role, std::string& why_not) const;
  bool is_wing(const gears::GearPanel& panel) const;
  void hold_middle();
  void hold_blocks();
  void name_points();
  void put_pieces(const gears::GearPieces& pieces);
  std::map<std::uint32_t, double> carried_by(const gears::GearPieces& pieces) const;
  void name_lines(GearInScene& gear) const;
  void set_winches();
  std::string point_name(const std::string& name) const;
  std::uint32_t scene_node(std::uint32_t gear_node) const;

  const gears::NetPlan& plan_;
  Draft& draft_;
  formats::Diagnostics& diagnostics_;
  formats::Place place_;  // place of `[gear]`
  gears::Gear gear_;
  std::set<std::string> names_;           // names of everything in the gear
  std::optional<PlanElements> elements_;  // nullopt until `[elements]` is read
  GearMemory& memory_;
  gears::Fineness fineness_;
  bool is_sound_ = false;                      // false after an error in `[gear]` or `[elements]`
  std::shared_ptr<gears::Division> division_;  // nullptr before divide() and after an error
  std::shared_ptr<const DividedPanels> panels_;
  // Coordinates that the points of bodies give to the initial shape.
  std::vector<gears::KnownCoordinate> known_;
  std::vector<double> start_;  // initial positions, 3 per node of the gear
  /// For each node of the gear: the first part that has this node, whose positions the node gets, and the
  /// number of the node within this part; nullopt as long as no part has the node.
  std::vector<std::optional<Joiner::OwnNode>> first_;
  // Nodes of the gear as nodes of further parts, not the first one.
  std::vector<std::pair<std::uint32_t, Joiner::OwnNode>> others_;
};

}  // namespace netloft::scenes
