// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/reading/hold_reader.hpp"

#include "io/formats/text/name_fault.hpp"
#include "io/formats/units/in_quotes.hpp"
#include "io/formats/work/long_work.hpp"
#include "io/scenes/reading/plausible.hpp"
#include "io/scenes/reading/read_bodies.hpp"
#include "io/scenes/reading/tow.hpp"

#include <algorithm>

namespace netloft::scenes {

void HoldReader::read() {
  Holder holder(out_.scene);
  for (auto& table : root_.tables("hold")) {
    const int errors_before = diagnostics_.errors();
    HoldEntry entry = read_hold(table);
    formats::report({"holding", entry.name, out_.holds.size(), "holds"});
    check_hold_name(entry, table);
    entry.course = read_course(table);
    if (table.kind("on") != formats::Kind::text && table.kind("on") != formats::Kind::array) continue;
    const auto nodes = find_held(entry, table);
    if (nodes.empty() || diagnostics_.errors() > errors_before) continue;
    out_.holds.push_back(holder.hold(entry, nodes, table));
    guide(entry, out_.holds.back(), table);
    if (out_.gear && out_.gear->times == 1) one_sided_.add(entry, table.place("on"));
  }
}

/// The nodes that a hold names; empty after an error.
std::vector<std::uint32_t> HoldReader::find_held(const HoldEntry& entry, formats::TableReader& table) {
  std::vector<std::uint32_t> nodes;
  std::size_t sets = 0;
  for (std::size_t i = 0; i < entry.on.size(); ++i)
    for (const auto& m : draft_.expand(mention_of_item(entry.on[i], table, "on", i))) {
      const auto set = draft_.find_nodes(m);
      if (!set || !draft_.is_sound[set->part]) return {};
      const auto own = draft_.scene_nodes(*set);
      if (const auto carried =
              std::find_if(own.begin(), own.end(), [&](auto n) { return body_that_carries(out_.scene, n); });
          carried != own.end()) {
        refuse_carried(m, *carried);
        return {};
      }
      nodes.insert(nodes.end(), own.begin(), own.end());
      ++sets;
    }
  if (sets > 1) drop_repeats(nodes);
  return nodes;
}

void HoldReader::refuse_carried(const Mention& m, std::uint32_t node) {
  const std::string body = body_that_carries(out_.scene, node)->name;
  diagnostics_.error(m.place,
                     m.path + ": " + formats::in_quotes(m.name) + " holds a point of the body " +
                         formats::in_quotes(body) + ", but the body carries this point",
                     "hold its origin, on = \"" + body + ".origin\"; turns = \"not\" in [bodies." + body +
                         "] holds its attitude");
}

/// Moves the nodes of a hold along its course.
void HoldReader::guide(const HoldEntry& entry, const Hold& hold, formats::TableReader& table) {
  if (entry.course.knots.empty()) return;
  guides_.push_back(table);
  const char* key = table.has("velocity") ? "velocity" : "displacement";
  check_speed_of_hold(entry.course, table, key);
  const bool is_turned = entry.frame || std::any_of(hold.nodes.begin(), hold.nodes.end(), [&](auto node) {
                           return out_.scene.frames.contains(node);
                         });
  if (is_turned) table.error(key, "cannot be combined with along or plane", "use axes for a hold that moves");
  out_.scene.guides.push_back({hold.nodes, hold.axes, entry.course});
}

void HoldReader::check_guides() {
  formats::TableReader analysis = root_.table("analysis", formats::Presence::optional);
  if (diagnostics_.where(analysis.place("kind")).starts_with("--set")) return;
  for (auto& hold : guides_)
    hold.error(hold.has("velocity") ? "velocity" : "displacement", "nothing moves in a static analysis",
               "kind = \"dynamic\" in [analysis], or leave it out");
  gear_.refuse_motions();
}

void HoldReader::check_hold_name(const HoldEntry& entry, formats::TableReader& table) {
  const char* key = table.has("name") ? "name" : "on";
  if (const std::string fault = formats::name_fault(entry.name); table.has("name") && !fault.empty())
    table.error("name", "the name of a hold, " + formats::in_quotes(entry.name) + ", " + fault);
  const auto [earlier, is_new] = hold_names_.emplace(entry.name, table.place(key));
  if (!is_new && !entry.name.empty())
    table.error(key,
                "there is a hold named " + formats::in_quotes(entry.name) + " already, at " +
                    diagnostics_.where(earlier->second),
                "give one of them a name of its own: name = \"…\"");
}

}  // namespace netloft::scenes
