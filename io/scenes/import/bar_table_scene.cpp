// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/import/bar_table.hpp"
#include "io/scenes/import/scene_text.hpp"

#include <algorithm>
#include <map>

namespace netloft::scenes {

namespace {

/// Writes the scene that a table of nodes and bars describes. The member functions are the steps, in the
/// order of execution.
class TableScene {
 public:
  TableScene(const BarTable& table, const std::string& mesh_name) : table_(table), mesh_name_(mesh_name) {}

  BarTableScene write(const std::vector<std::string>& head) {
    for (const auto& n : table_.nodes)
      mesh_.positions.insert(mesh_.positions.end(), n.at.begin(), n.at.end());
    for (const auto& text : head) scene_.comment(in_ascii(text));
    scene_.comment("A current is written into [water] as current = [0.8, 0, 0].");
    scene_.add("\n[water]\n");
    scene_.line("density", table_.density);
    scene_.line("gravity", table_.gravity);
    for (const auto& rope : table_.ropes) write_rope(rope);
    write_beds();
    write_weights();
    write_forces();
    write_holds();
    write_results();
    return {scene_.text(), std::move(mesh_)};
  }

 private:
  void write_rope(const TableRope& rope) {
    double length = 0;
    for (const auto& bar : rope.bars) length += bar.length;
    formats::MeshRegion region{formats::RegionKind::bars, rope.name};
    double at = 0;
    for (std::size_t i = 0; i < rope.bars.size(); ++i) {
      const auto& bar = rope.bars[i];
      region.nodes.insert(region.nodes.end(), bar.nodes.begin(), bar.nodes.end());
      region.numbers.push_back(at / length);
      at += bar.length;
      region.numbers.push_back(i + 1 == rope.bars.size() ? 1 : at / length);
    }
    mesh_.regions.push_back(std::move(region));
    scene_.begin_part(rope.name, "rope/bar");
    scene_.line("mesh", quoted(mesh_name_));
    scene_.line("length", length);
    InlineTable table;
    table.add("diameter", rope.diameter).add("EA", rope.EA).add("density", rope.density);
    if (rope.EA_compression) table.add("EA_compression", *rope.EA_compression);
    if (rope.EI > 0) table.add("EI", rope.EI);
    scene_.line("rope", table.text());
    if (rope.normal)
      scene_.line("drag", InlineTable()
                              .add("law", quoted("hydro/morison"))
                              .add("normal", *rope.normal)
                              .add("tangential", *rope.tangential)
                              .text());
  }

  /// Makes a set of nodes for each value of the property `what`, in the order of the table. Nodes whose value
  /// is zero or empty are left out.
  template <class Key, class What>
  std::vector<std::pair<Key, std::string>> sets_of(const char* name, What&& what) {
    std::vector<std::pair<Key, std::string>> sets;
    std::map<Key, std::size_t> known;
    for (std::uint32_t n = 0; n < table_.nodes.size(); ++n) {
      const Key key = what(n);
      if (key == Key{}) continue;
      const auto [at, is_new] = known.try_emplace(key, mesh_.sets.size());
      if (is_new) {
        sets.emplace_back(key, std::string(name) + std::to_string(sets.size() + 1));
        mesh_.sets.push_back({sets.back().second});
      }
      mesh_.sets[at->second].nodes.push_back(n);
    }
    return sets;
  }

  /// The stiffness of the bed under a node, collected from all ropes that meet at this node.
  struct BedUnder {
    double least = 0, most = 0;      // smallest and largest stiffness under these ropes [N/m²]
    double product = 0, metres = 0;  // sums over half bars of stiffness times length [N/m] and of length [m]
    bool is_of_two = false;          // whether ropes with different beds meet at the node
    void add(double stiffness, double length) {
      is_of_two = is_of_two || (stiffness > 0 && most > 0 && stiffness != most);
      least = metres > 0 ? std::min(least, stiffness) : stiffness;
      most = std::max(most, stiffness);
      product += stiffness * length;
      metres += length;
    }
    /// Stiffness of the bed under the node, averaged over the length of the half bars there [N/m²].
    double stiffness() const { return least == most ? most : product / metres; }
  };

  /// Writes the parts that model the bed, one for each stiffness. Each part is on all ropes whose bed has its
  /// stiffness. If ropes with different beds meet at a node, the parts are on sets of nodes instead, so that
  /// this node does not rest on two beds.
  void write_beds() {
    std::vector<BedUnder> under(table_.nodes.size());
    std::map<double, std::vector<std::string>> on;
    for (const auto& rope : table_.ropes) {
      if (rope.bed > 0) on[rope.bed].push_back(rope.name);
      for (const auto& bar : rope.bars)
        for (const auto node : bar.nodes) under[node].add(rope.bed, bar.length / 2);
    }
    if (std::ranges::any_of(under, &BedUnder::is_of_two)) {
      on.clear();
      for (const auto& [stiffness, set] :
           sets_of<double>("on-bed-", [&](std::uint32_t n) { return under[n].stiffness(); }))
        on[stiffness].push_back("*." + set);
    }
    int number = 0;
    for (const auto& [stiffness, names] : on) write_bed("bed-" + std::to_string(++number), stiffness, names);
  }

  void write_bed(const std::string& name, double stiffness, const std::vector<std::string>& on) {
    scene_.begin_part(name, "seabed/plane");
    scene_.line("on", quoted_list(on));
    scene_.line(
        "seabed",
        InlineTable().add("depth", table_.depth).add("stiffness", stiffness).add("softness", 0).text());
  }

  void write_weights() {
    using Weight = std::array<double, 4>;
    const auto sets = sets_of<Weight>("weight-", [&](std::uint32_t number) {
      const TableNode& n = table_.nodes[number];
      return Weight{n.mass, n.buoyancy, n.volume, n.drag_area};
    });
    for (const auto& [weight, set] : sets) {
      const auto& [mass, buoyancy, volume, drag_area] = weight;
      scene_.begin_part(set, "float/float");
      scene_.line("on", quoted("*." + set));
      scene_.line("each", 1);
      InlineTable table;
      table.add_unless_zero("mass", mass)
          .add_unless_zero("buoyancy", buoyancy)
          .add_unless_zero("volume", volume);
      if (drag_area > 0) table.add("area", drag_area).add("drag_coefficient", 1);
      scene_.line("float", table.text());
    }
  }

  void write_forces() {
    using Force = std::array<double, 3>;
    for (const auto& [force, set] :
         sets_of<Force>("force-", [&](std::uint32_t n) { return table_.nodes[n].force; })) {
      scene_.begin_part(set, "force/constant");
      scene_.line("on", quoted("*." + set));
      scene_.line("each", 1);
      scene_.line("force", InlineTable()
                               .add_unless_zero("x", force[0])
                               .add_unless_zero("y", force[1])
                               .add_unless_zero("z", force[2])
                               .text());
    }
  }

  void write_holds() {
    for (const auto& [axes, set] :
         sets_of<std::string>("held-", [&](std::uint32_t n) { return table_.nodes[n].hold; }))
      scene_.hold("*." + set, set, axes);
  }

  void write_results() {
    if (table_.results.empty()) return;
    scene_.add("\n[results]\n");
    for (const auto& r : table_.results)
      scene_.line(r.name, InlineTable().add("of", quoted(r.of)).add("take", quoted(r.take)).text());
  }

  const BarTable& table_;
  const std::string& mesh_name_;
  formats::InputMesh mesh_;
  SceneText scene_;
};

}  // namespace

BarTableScene scene_of(const BarTable& table, const std::vector<std::string>& head,
                       const std::string& mesh_name) {
  return TableScene(table, mesh_name).write(head);
}

}  // namespace netloft::scenes
