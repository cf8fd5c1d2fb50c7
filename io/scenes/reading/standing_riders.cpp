// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/standing_riders.hpp"

#include "io/scenes/reading/outward.hpp"
#include "io/scenes/reading/own_data.hpp"
#include "io/scenes/reading/panels_in_row.hpp"
#include "io/scenes/reading/part_names.hpp"
#include "io/scenes/reading/riding.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace netloft::scenes {

namespace {

/// Makes the elements of one rider, a part on other parts. The member functions are the steps, in the order
/// of execution.
class RiderMaker {
 public:
  RiderMaker(const ElementType& type, formats::TableReader& table, Draft& draft, Part& rider)
      : type_(type),
        table_(table),
        draft_(draft),
        rider_(rider),
        on_nodes_(type.element.stencil == NETLOFT_NODE) {}

  void stand() {
    const int errors_before = table_.diagnostics().errors();
    read_names();
    if (table_.diagnostics().errors() > errors_before) return;
    std::set<std::string> named;
    for (std::size_t n = 0; n < names_.size(); ++n) {
      const Mention own = mention_of_item(names_[n], table_, "on", n);
      if (!named.insert(names_[n]).second)
        table_.diagnostics().error(own.place,
                                   own.path + ": " + formats::in_quotes(names_[n]) + " is named twice");
      for (const auto& one : draft_.expand(own))
        for (const auto& at : draft_.both_sides(one)) stand_on(at);
    }
    drop_repeats(nodes_);
    if (on_nodes_) stand_on_nodes();
    if (!corners_.empty()) stand_between_points();
    if (type_.element.stencil == NETLOFT_BAR_PAIR) stand_between_ropes();
    if (type_.element.stencil == NETLOFT_TRIANGLE) count_meshes_through_seams(panels_, rider_);
    if (type_.element.stencil == NETLOFT_TRIANGLE && declares(type_, datum::kOutward)) tell_outside();
    read_missing_data();
  }

 private:
  void tell_outside() {
    Outward outward = find_outward(panels_, draft_.out.scene.positions, rider_);
    rider_.data[datum::kOutward.name] = std::move(outward.of_triangles);
    if (outward.unknown < 2) return;
    table_.diagnostics().warning(
        table_.place("on"),
        rider_.name + ": has no inside, since " + std::to_string(outward.unknown) +
            " of its panels lie in one plane; it pushes each of them towards the side "
            "from which its corners appear counter-clockwise",
        "sketch the panels apart, or name only one panel in `on`");
  }

  bool is_of_plan(std::size_t part) const {
    return draft_.out.gear && std::ranges::count(draft_.out.gear->panels, part) > 0;
  }

  void read_names() {
    if (table_.kind("on") == formats::Kind::text)
      names_ = {table_.text("on", {})};
    else
      names_ = table_.texts(
          "on", {.doc = "parts, edges or points whose nodes or elements it uses", .count = {.least = 1}});
  }

  /// Makes elements on nodes: distributes `number` pieces over them, or puts `each` pieces on every node.
  void stand_on_nodes() {
    const formats::Range pieces = formats::between(0, 1e6);
    const double number = table_.real(
        "number", {.doc = "number of pieces, spread evenly along `on`", .range = pieces, .fallback = 1.0});
    if (!table_.has("each")) {
      if (!nodes_.empty()) ride_on_nodes(nodes_, carried(), number, rider_);
      return;
    }
    if (table_.has("number"))
      table_.error("each",
                   "is given beside number; pieces are either spread evenly along `on` or put on every node",
                   "leave one of them out");
    const double each = table_.real("each", {.doc = "pieces on every node", .range = pieces});
    ride_on_every_node(nodes_, each, rider_);
  }

  void stand_on(const Mention& at) {
    const std::string& name = at.name;
    const auto set = draft_.find_nodes(at);
    if (!set || !draft_.is_sound[set->part] || !draft_.types[set->part]) return;
    const bool is_whole = name.find('.') == std::string::npos;
    if (on_nodes_)
      add_nodes(*set);
    else if (type_.is_on_body())
      stand_on_body(*set, is_whole, at);
    else if (type_.element.stencil == NETLOFT_BAR_PAIR && is_whole && is_rope(set->part))
      ropes_.push_back(set->part);
    else if (!is_whole && type_.element.stencil == NETLOFT_BAR && is_rope(set->part))
      ride_on_bars_at(draft_.out.scene, set->part, draft_.node_elements(), draft_.scene_nodes(*set), rider_);
    else if (set->own.size() == 1 && is_one_of_corners())
      corners_.push_back(draft_.scene_nodes(*set)[0]);
    else if (!is_whole || !add_elements(set->part))
      table_.error("on", formats::in_quotes(name) + " is no whole part that " + type_.type + " can use");
  }

  /// Makes an element on the origin of a body. If the element type has the datum `arm` (the position of a
  /// point on the body), the element may also be on a named point of the body.
  void stand_on_body(const Joiner::Ends& set, bool is_whole, const Mention& at) {
    const auto& body = draft_.geometries[set.part].body;
    if (!body || !(is_whole || declares(type_, datum::kArm)))
      return table_.diagnostics().error(at.place,
                                        at.path + ": " + formats::in_quotes(at.name) + " is no rigid body" +
                                            (declares(type_, datum::kArm) ? " or point of one" : "") +
                                            ", but " + type_.type + " needs one",
                                        "name one of [bodies]");
    for (const auto own : is_whole ? std::vector{std::uint32_t{0}} : set.own) {
      rider_.nodes.push_back(draft_.out.parts[set.part].nodes[0]);
      rider_.data[datum::kSide.name].push_back(body->side);
      const std::array<double, 3> r = own == 0 ? std::array<double, 3>{} : body->r[own - 1];
      rider_.data[datum::kArm.name].insert(rider_.data[datum::kArm.name].end(),
                                           {r[0], body->side * r[1], r[2]});
    }
  }

  /// Whether `on` has as many names as an element has nodes, so that the names may be the nodes of one
  /// element.
  bool is_one_of_corners() const { return names_.size() == static_cast<std::size_t>(type_.nodes()); }

  void stand_between_points() {
    if (table_.diagnostics().errors()) return;
    if (!is_one_of_corners() || corners_.size() != names_.size())
      return table_.error("on", "names points beside whole parts; " + type_.type + " needs either " +
                                    std::to_string(type_.nodes()) + " points, or whole parts");
    rider_.nodes = corners_;
  }

  bool is_rope(std::size_t part) const { return draft_.types[part]->element.stencil == NETLOFT_BAR; }

  /// Makes elements on pairs of bars with a common node, one bar from each of two ropes.
  void stand_between_ropes() {
    if (table_.diagnostics().errors()) return;
    if (ropes_.size() != 2)
      return table_.error("on", "names " + std::to_string(ropes_.size()) + " ropes; " + type_.type +
                                    " connects two ropes that meet");
    const auto& parts = draft_.out.scene.parts;
    ride_on_meeting_bars(draft_.out.scene, ropes_[0], ropes_[1], draft_.node_elements(), rider_);
    if (rider_.nodes.empty())
      table_.error("on",
                   formats::in_quotes(parts[ropes_[0]].name) + " and " +
                       formats::in_quotes(parts[ropes_[1]].name) + " do not meet in a node",
                   "join them where they meet");
  }

  void add_nodes(const Joiner::Ends& set) {
    grounds_.emplace(set.part, grounds_.size());
    const auto nodes = draft_.scene_nodes(set);
    nodes_.insert(nodes_.end(), nodes.begin(), nodes.end());
  }

  /// The length of rope or twine that each node represents [m], in all parts that `on` names.
  std::vector<double> carried() const {
    std::vector<double> lengths;
    std::map<std::size_t, CarriedLength> of_part;
    for (const auto& [part, order] : grounds_)
      of_part.try_emplace(part, draft_.out.scene.parts[part], *draft_.types[part]);
    const NodeElements& elements = draft_.node_elements();
    std::vector<std::pair<std::size_t, std::size_t>> parts;  // parts at a node, each after its order in `on`
    for (const auto node : nodes_) {
      parts.clear();
      for (const auto& at : elements.at(node))  // part by part
        if (parts.empty() || parts.back().second != at.part)
          if (const auto ground = grounds_.find(at.part); ground != grounds_.end())
            parts.emplace_back(ground->second, at.part);
      std::ranges::sort(parts);
      double length = 0;
      for (const auto& [order, part] : parts) length += of_part.at(part).at(elements.at(node, part));
      lengths.push_back(length);
    }
    return lengths;
  }

  /// Copies the elements of a part if they have the shape (stencil) of the rider's elements, or else the
  /// triangles between the bars of a panel. Returns false if neither is possible.
  bool add_elements(std::size_t part) {
    panels_.push_back({rider_.nodes.size(), is_of_plan(part)});
    if (draft_.types[part]->element.stencil == type_.element.stencil)
      ride_on_elements(draft_.out.scene.parts[part], rider_);
    else if (type_.element.stencil == NETLOFT_TRIANGLE && !draft_.geometries[part].faces.nodes.empty())
      ride_on_elements(faces_of(part), rider_);
    else
      return false;
    return true;
  }

  Part faces_of(std::size_t part) const {
    Part faces;
    for (const auto own : draft_.geometries[part].faces.nodes)
      faces.nodes.push_back(draft_.out.parts[part].nodes[own]);
    faces.data = draft_.geometries[part].faces.data;
    return faces;
  }

  /// Reads data that the other parts do not have: one value for all elements.
  void read_missing_data() {
    const std::size_t elements = rider_.nodes.size() / static_cast<std::size_t>(type_.nodes());
    for (const auto& datum : type_.data)
      if (elements > 0 && !rider_.data.contains(datum.name))
        read_own_datum(type_, datum, elements, table_, rider_.data);
  }

  const ElementType& type_;
  formats::TableReader& table_;
  Draft& draft_;
  Part& rider_;
  bool on_nodes_;
  std::vector<std::string> names_;
  std::vector<std::uint32_t> nodes_;
  std::map<std::size_t, std::size_t> grounds_;  // for each part of these nodes: its order in `on`
  std::vector<PanelBelow> panels_;              // panels whose elements the rider copies
  std::vector<std::size_t> ropes_;              // indices of the ropes, for elements on pairs of bars
  std::vector<std::uint32_t> corners_;          // nodes of one element, as named in `on`
};

}  // namespace

void stand_on_others(const ElementType& type, formats::TableReader& table, Draft& draft, Part& rider) {
  RiderMaker(type, table, draft, rider).stand();
}

}  // namespace netloft::scenes
