// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/check.hpp"
#include "io/gears/plan/names.hpp"
#include "io/gears/plan/proposals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace netloft::gears {

namespace {

/// One side of a seam, which consists of one or more edges, counted over the whole gear.
struct EdgeRow {
  std::string name;      // such as "bottom-wing.side + bottom-body.side"
  double meshes = 0;     // sum over port and starboard
  double stretched = 0;  // [m]
  int times = 1;
  double mesh = 0;  // [m]
  bool is_side = false, is_one_mesh_size = true, is_sound = true;
  int across_middle = 0;  // number of edges across the middle
};

EdgeRow read_edge_row(const NetPlan& plan, const std::vector<std::string>& names, const formats::Place& place,
                      const std::string& path, formats::Diagnostics& diagnostics) {
  EdgeRow row;
  for (const auto& name : names) {
    const EdgeSet set = find_edge(plan, name, place, path, diagnostics);
    if (set.edges.empty()) {
      row.is_sound = false;
      continue;
    }
    if (row.name.empty()) {
      row.times = set.times();
      row.mesh = set.panel->mesh;
      row.is_side = set.is_side();
    }
    row.name += (row.name.empty() ? "" : " + ") + name;
    row.meshes += set.times() * set.meshes();
    row.stretched += set.times() * set.stretched();
    row.is_one_mesh_size = row.is_one_mesh_size && set.panel->mesh == row.mesh;
    row.across_middle += set.is_across_middle();
  }
  row.is_sound = row.is_sound && !names.empty();
  return row;
}

/// Whether the two sides of a seam are compared by mesh counts. They are compared by lengths if sides of
/// panels are sewn to fore or aft edges, or to sides with another mesh size.
bool is_counted(const EdgeRow& a, const EdgeRow& b) {
  if (a.is_side != b.is_side) return false;
  return !a.is_side || (a.is_one_mesh_size && b.is_one_mesh_size && a.mesh == b.mesh);
}

/// The quantity that is compared between the two sides of a seam, over the whole gear.
struct Match {
  bool is_counted;
  double first, second;  // meshes, or length of twines [m]
  bool has_take_up;      // whether the plan states a take-up ratio
  double expected;       // the second amount over the first, as the plan states it
  double off() const { return second / first / expected - 1; }
};

/// Adds proposals of other counts for the edges of one side of a seam. Each proposal alone adds `more`
/// meshes, or metres of twine, to this side.
void add_cures_of_row(Cures& cures, const NetPlan& plan, const std::vector<std::string>& row, double more,
                      bool is_counted) {
  formats::Diagnostics silent;
  for (const auto& name : row) {
    const EdgeSet edge = find_edge(plan, name, {}, "", silent);
    const double now = edge.times() * (is_counted ? edge.meshes() : edge.stretched());
    if (now <= 0) continue;
    const Cures own = cures_of_edge(edge, edge.meshes() * more / now);
    cures.insert(cures.end(), own.begin(), own.end());
  }
}

/// The value of take_up with another number for one row.
formats::Value take_up_with(const Join& join, std::size_t row, double ratio) {
  if (join.edges.size() == 2) return as_number(ratio);
  formats::Array all;
  for (std::size_t k = 1; k < join.edges.size(); ++k)
    all.items.push_back(as_number(k == row ? ratio : join.take_up_of(k) > 0 ? join.take_up_of(k) : 1));
  return {{}, all};
}

/// Proposals for a seam whose first row and another one do not fit: other counts of their edges, or the
/// take-up ratio that fits them.
Cures cures_of_seam(const NetPlan& plan, const Join& join, std::size_t row, const Match& match) {
  Cures cures;
  if (join.edges.size() == 2)
    add_cures_of_row(cures, plan, join.edges[0], match.second / match.expected - match.first,
                     match.is_counted);
  add_cures_of_row(cures, plan, join.edges[row], match.expected * match.first - match.second,
                   match.is_counted);
  const double ratio = std::stod(fmt::format("{:.4g}", match.second / match.first));
  if (!join.path.empty())
    cures.push_back(set(join.path + ".take_up", take_up_with(join, row, ratio),
                        "if so many meshes of the edge are sewn to one mesh of the first"));
  return cures;
}

void say_mismatch(const formats::Place& place, const std::string& path, const EdgeRow& a, const EdgeRow& b,
                  const Match& match, const Cures& cures, const CheckLimits& limits,
                  formats::Diagnostics& diagnostics) {
  const int times = a.times == b.times ? a.times : 1;
  const auto measure = [&](const EdgeRow& row) {
    return match.is_counted ? in_meshes(row.meshes / times) + " meshes"
                            : in_metres(row.stretched / times) + " m of twine";
  };
  const std::string message =
      fmt::format("{}: {} has {}, but {} has {}, {}{}", path, a.name, measure(a), b.name, measure(b),
                  in_percent(match.off()),
                  match.has_take_up ? fmt::format(" of the take-up {:.3g}", match.expected) : "");
  if (std::abs(match.off()) > limits.joining_error)
    diagnostics.error(place, message, "", cures);
  else
    diagnostics.warning(place, message, "", cures);
}

void check_match(const NetPlan& plan, const Join& join, std::size_t row, const std::string& path,
                 const EdgeRow& a, const EdgeRow& b, const CheckLimits& limits,
                 formats::Diagnostics& diagnostics) {
  const bool counted = is_counted(a, b);
  const double take_up = join.take_up_of(row);
  const Match match = {counted, counted ? a.meshes : a.stretched, counted ? b.meshes : b.stretched,
                       take_up > 0, take_up > 0 ? take_up : 1};
  if (match.first <= 0 || match.second <= 0) return;
  const double excess = std::abs(match.second - match.expected * match.first);
  const double few = limits.joining_meshes * std::max(a.times, b.times) * (counted ? 1 : a.mesh);
  if (excess <= few || excess <= limits.joining * match.expected * match.first) return;
  const Cures cures = diagnostics.wants_cures() ? cures_of_seam(plan, join, row, match) : Cures{};
  say_mismatch(join.places[row], path, a, b, match, cures, limits, diagnostics);
}

/// Warns about edges sewn mesh to mesh whose mesh sizes differ so much that the wider meshes cannot open far.
void check_widths(const formats::Place& place, const std::string& path, const EdgeRow& a, const EdgeRow& b,
                  const CheckLimits& limits, formats::Diagnostics& diagnostics) {
  const double narrow = std::min(a.stretched, b.stretched), wide = std::max(a.stretched, b.stretched);
  if (!is_counted(a, b) || narrow <= 0 || narrow >= limits.bunching * wide) return;
  diagnostics.warning(
      place,
      fmt::format(
          "{}: {} is {} m wide when stretched, but {} {} m: the wider netting would be bunched, ratio {:.2g}",
          path, a.name, in_metres(a.stretched / a.times), b.name, in_metres(b.stretched / b.times),
          narrow / wide),
      "one mesh size may be that of one bar instead of two, or take_up may be missing");
}

/// Reports edges that the plan sews twice or hangs twice. Two names may contain the same edge: "body.fore"
/// contains "body.bosom".
class Ledger {
 public:
  explicit Ledger(const char* deed, const char* hint = "") : deed_(deed), hint_(hint) {}
  void enter(const EdgeSet& set, const formats::Place& place, const std::string& path,
             formats::Diagnostics& diagnostics) {
    for (const auto& edge : set.edges)
      if (const auto earlier = done_.find(name(set, edge)); earlier != done_.end()) {
        diagnostics.error(place,
                          fmt::format("{}: \"{}\" is {} twice, also at {}", path, earlier->first, deed_,
                                      diagnostics.where(earlier->second)),
                          hint_);
        break;
      }
    for (const auto& edge : set.edges) done_.emplace(name(set, edge), place);
  }

 private:
  static std::string name(const EdgeSet& set, const OutlineEdge& edge) {
    return set.panel->name + "." + edge.name;
  }
  const char *deed_, *hint_;
  std::map<std::string, formats::Place> done_;
};

/// Refuses an edge that is sewn to itself, unless it exists on both sides or crosses the middle.
void check_sewn_to_itself(const Join& join, const std::string& path, const EdgeRow& row,
                          formats::Diagnostics& diagnostics) {
  if (row.times != 2 && row.across_middle != 1)
    diagnostics.error(join.places[1],
                      fmt::format("{}: {} exists once and cannot be sewn to itself", path, row.name),
                      "only edges of a middle panel and edges of a pair can be sewn to themselves");
}

/// Refuses a row of edges if more than two of them lie across the middle. A row is sewn from the middle
/// outwards, and may return to the middle only once.
void check_ring(const Join& join, std::size_t k, const std::string& path, const EdgeRow& row,
                formats::Diagnostics& diagnostics) {
  if (row.across_middle > 2)
    diagnostics.error(
        join.places[k],
        fmt::format("{}: {}: {} edges of a row lie across the middle", path, row.name, row.across_middle),
        "join at most one upper and one lower edge that lie across the middle, with edges of pairs between "
        "them");
}

/// Length of rope that a hanging takes [m]: in the whole gear for a rope in the middle, on one side for a
/// rope of a pair.
double length_taken(const Hanging& hanging, const EdgeSet& edge, const Rope& rope) {
  const double once = hanging.length > 0 ? hanging.length : hanging.ratio * edge.stretched();
  return rope.stands == Standing::middle ? edge.times() * once : once;
}

/// Proposes the given ratios for a hanging, as lengths if the plan states a length.
Cures cures_of_hanging(const Hanging& hanging, double stretched, std::initializer_list<double> ratios) {
  Cures cures;
  for (const double ratio : ratios) {
    if (hanging.path.empty()) continue;
    const std::string note = fmt::format("which is a ratio of {:.3g}", ratio);
    if (hanging.length > 0)
      cures.push_back(set(hanging.path + ".length", as_metres(millimetres_below(ratio * stretched)), note));
    else
      cures.push_back(set(hanging.path + ".ratio", as_number(ratio)));
  }
  return cures;
}

void check_hanging(const Hanging& hanging, const EdgeSet& edge, const std::string& path,
                   const CheckLimits& limits, formats::Diagnostics& diagnostics) {
  const double stretched = edge.stretched();
  const double length = hanging.length > 0 ? hanging.length : hanging.ratio * stretched;
  const double ratio = length / stretched;
  const std::string said =
      fmt::format("{}: {} is {} m long when its meshes are stretched, but gets {} m of {}", path,
                  hanging.edge, in_metres(stretched), in_metres(length), hanging.rope);
  if (ratio > 1 + limits.stretching)
    diagnostics.error(hanging.place,
                      said + ": the netting would have to be stretched, " + in_percent(ratio - 1),
                      fmt::format("the edge takes at most {} m of rope", in_metres(stretched)),
                      cures_of_hanging(hanging, stretched, {1, 0.5}));
  else if (ratio < limits.bunching)
    diagnostics.warning(hanging.place,
                        said + fmt::format(": its meshes would be bunched, ratio {:.2g}", ratio),
                        "a hanging ratio is rarely below 0.3; the length may be that of one part of the edge",
                        cures_of_hanging(hanging, stretched, {0.5, 0.3}));
}

Cures cures_of_standing(const Rope& rope, const char* word, std::string note) {
  return {set(path_of({"ropes", rope.name, "stands"}), as_text(word), std::move(note))};
}

constexpr const char* kRunsAcross = "if the rope runs from one side to the other";
constexpr const char* kStandings =
    "a pair of ropes carries edges that exist twice, a rope in the middle carries edges of both sides";

/// Refuses an edge that exists on both sides but is hung on a single rope, and an edge that exists once but
/// is hung on a pair of ropes.
void check_times(const Hanging& h, const EdgeSet& edge, const Rope& rope, const std::string& path,
                 formats::Diagnostics& diagnostics) {
  const bool is_twice = edge.times() == 2;
  if (rope.stands == Standing::alone && is_twice)
    diagnostics.error(
        h.rope_place,
        fmt::format("{}: {} exists to port and to starboard, but {} only once", path, h.edge, rope.name),
        kStandings,
        {cures_of_standing(rope, "pair", "")[0], cures_of_standing(rope, "middle", kRunsAcross)[0]});
  if (rope.stands == Standing::pair && !is_twice)
    diagnostics.error(
        h.rope_place,
        fmt::format("{}: {} exists only once, but {} to port and to starboard", path, h.edge, rope.name),
        kStandings, cures_of_standing(rope, "middle", kRunsAcross));
}

std::string indexed(const char* key, std::size_t i) { return fmt::format("{}[{}]", key, i); }

double hung_on(const NetPlan& plan, const HangingsByRope& hangings, const Rope& rope) {
  double sum = 0;
  formats::Diagnostics silent;
  const auto [first, last] = hangings.equal_range(rope.name);
  for (auto h = first; h != last; ++h) {
    const EdgeSet edge = find_edge(plan, h->second->edge, {}, "", silent);
    if (!edge.edges.empty()) sum += length_taken(*h->second, edge, rope);
  }
  return sum;
}

/// Warns that edges take only a small part of a rope.
void say_loose(const Rope& rope, double hung, formats::Diagnostics& diagnostics) {
  diagnostics.warning(
      rope.place,
      fmt::format("{} is {} m long, but edges take only {} m of it: {} m carry no netting", rope.name,
                  in_metres(rope.length), in_metres(hung), in_metres(rope.length - hung)),
      "give length in metres, for the whole rope; a piece that leads on to other gear needs a rope of its "
      "own",
      {set(path_of({"ropes", rope.name, "length"}), as_metres(millimetres_above(hung)))});
}

/// Proposals for a rope that is too short: a longer rope, a smaller length of rope for one of its edges, or
/// fewer meshes along an edge that is hung with a ratio.
Cures cures_of_length(const NetPlan& plan, const HangingsByRope& hangings, const Rope& rope, double hung) {
  Cures cures = {set(path_of({"ropes", rope.name, "length"}), as_metres(millimetres_above(hung)))};
  formats::Diagnostics silent;
  const auto [first, last] = hangings.equal_range(rope.name);
  for (auto h = first; h != last; ++h) {
    const Hanging& hanging = *h->second;
    const EdgeSet edge = find_edge(plan, hanging.edge, {}, "", silent);
    const int times = rope.stands == Standing::middle ? edge.times() : 1;
    const double now = hanging.length > 0 ? hanging.length : hanging.ratio * edge.stretched();
    const double length = millimetres_below(now - (hung - rope.length) / times);
    if (hanging.path.empty() || edge.edges.empty() || length <= 0) continue;
    if (hanging.length > 0)
      cures.push_back(set(hanging.path + ".length", as_metres(length)));
    else
      cures.push_back(
          set(hanging.path + ".ratio", as_number(std::floor(1e4 * length / edge.stretched()) / 1e4)));
    if (hanging.length > 0) continue;
    const Cures counts = cures_of_edge(edge, edge.meshes() * (length / now - 1));
    cures.insert(cures.end(), counts.begin(), counts.end());
  }
  return cures;
}

void check_rope_length(const NetPlan& plan, const HangingsByRope& hangings, const Rope& rope,
                       const CheckLimits& limits, formats::Diagnostics& diagnostics) {
  const double hung = hung_on(plan, hangings, rope);
  const double missing = hung - rope.length;
  if (missing <= limits.rounding * rope.length) return;
  const std::string message =
      fmt::format("{} is {} m long, but edges take {} m of it: it is {} m too short", rope.name,
                  in_metres(rope.length), in_metres(hung), in_metres(missing));
  const std::string cure = "lengthen the rope, or give its edges less of it";
  const Cures cures = diagnostics.wants_cures() ? cures_of_length(plan, hangings, rope, hung) : Cures{};
  if (missing > limits.short_rope * rope.length)
    diagnostics.error(rope.place, message, cure, cures);
  else
    diagnostics.warning(rope.place, message, cure, cures);
}

/// Reports a single rope that ends at a point that exists on both sides.
void check_end(const NetPlan& plan, const Rope& rope, const std::string& end,
               formats::Diagnostics& diagnostics) {
  const std::string path = "ropes." + rope.name + ".between";
  if (find_point_owner(plan, end, rope.between_place, path, diagnostics).empty()) return;
  const bool is_once =
      rope.stands == Standing::alone || (rope.stands == Standing::middle && &end == &rope.between[0]);
  if (is_once && standing_of_point(plan, end) == Standing::pair)
    diagnostics.error(rope.between_place,
                      fmt::format("{}: {} exists to port and to starboard, but {} only once", path, end,
                                  rope.stands == Standing::middle ? "the middle of the rope" : "the rope"),
                      "a rope with stands = \"middle\" starts in the middle and ends on both sides",
                      cures_of_standing(rope, "pair", ""));
}

/// Reports a pair of ropes that both lead to the same point of a middle body, unless this point is in the
/// middle.
void check_end_aside(const NetPlan& plan, const Rope& rope, const std::string& end,
                     formats::Diagnostics& diagnostics) {
  const auto dot = end.find('.');
  const PlanBody* body = plan.find_body(end.substr(0, dot));
  if (rope.stands != Standing::pair || !body || body->stands != Standing::middle) return;
  const std::string name = end.substr(dot + 1);
  const BodyPoint* point = body->find_point(name);
  if (!point || point->y == 0) return;
  diagnostics.error(
      rope.between_place,
      fmt::format("ropes.{}.between: both ropes of the pair would lead to {}, {} m to {} of the middle",
                  rope.name, end, in_metres(std::abs(point->y)), point->y > 0 ? "starboard" : "port"),
      fmt::format("name two points of {} in its place, \"port-{}\" and \"starboard-{}\"; \"{}\" then means "
                  "one for each side",
                  body->name, name, name, end));
}

/// Sets of connected panels, ropes and points.
class Connections {
 public:
  void add(const std::string& name, const formats::Place& place) {
    parent_.push_back(parent_.size());
    index_.emplace(name, parent_.size() - 1);
    names_.push_back(name);
    places_.push_back(place);
  }
  void connect(const std::string& a, const std::string& b) {
    const auto i = index_.find(a), j = index_.find(b);
    if (i != index_.end() && j != index_.end()) parent_[root(i->second)] = root(j->second);
  }
  void report(formats::Diagnostics& diagnostics) {
    std::map<std::size_t, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < parent_.size(); ++i) groups[root(i)].push_back(i);
    std::size_t most = 0;
    for (const auto& [r, group] : groups) most = std::max(most, group.size());
    bool main_seen = false;
    for (const auto& [r, group] : groups)
      if (group.size() == most && !main_seen)
        main_seen = true;
      else
        say(group, diagnostics);
  }

 private:
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void say(const std::vector<std::size_t>& group, formats::Diagnostics& diagnostics) const {
    const std::string others =
        group.size() > 1 ? fmt::format(" and {} more are joined to each other only", group.size() - 1)
                         : " is joined to nothing";
    diagnostics.error(
        places_[group[0]], names_[group[0]] + others,
        "sew an edge with [[join]], hang one on a rope with [[hang]], or tie a rope to it with between");
  }
  std::vector<std::size_t> parent_;
  std::vector<std::string> names_;
  std::vector<formats::Place> places_;
  std::map<std::string, std::size_t> index_;
};

std::string owner(const std::string& name) { return name.substr(0, name.find('.')); }

/// The rows of a join. Edges that are sewn to themselves are read and entered once.
std::vector<EdgeRow> read_rows(const NetPlan& plan, const Join& join, const std::string& path, Ledger& sewn,
                               formats::Diagnostics& diagnostics) {
  std::vector<EdgeRow> rows;
  formats::Diagnostics silent;
  for (std::size_t k = 0; k < join.edges.size(); ++k) {
    if (k > 0 && join.is_to_itself()) {
      rows.push_back(rows[0]);
      break;
    }
    rows.push_back(read_edge_row(plan, join.edges[k], join.places[k], path, diagnostics));
    for (const auto& edge : join.edges[k])
      sewn.enter(find_edge(plan, edge, {}, "", silent), join.places[k], path, diagnostics);
  }
  return rows;
}

void connect_join(Connections& all, const Join& join) {
  const std::string first = join.edges[0].empty() ? "" : owner(join.edges[0][0]);
  for (const auto& row : join.edges)
    for (const auto& edge : row) all.connect(first, owner(edge));
}

}  // namespace

void check_joins(const NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics) {
  Ledger sewn("sewn", "one [[join]] takes all edges that meet in a seam: list them in its edges");
  for (std::size_t i = 0; i < plan.joins.size(); ++i) {
    const Join& join = plan.joins[i];
    const std::string path = join.path.empty() ? indexed("join", i) : join.path;
    const std::vector<EdgeRow> rows = read_rows(plan, join, path, sewn, diagnostics);
    if (!std::ranges::all_of(rows, &EdgeRow::is_sound)) continue;
    if (join.is_to_itself()) check_sewn_to_itself(join, path, rows[0], diagnostics);
    for (std::size_t k = 0; k < (join.is_to_itself() ? 1 : rows.size()); ++k)
      check_ring(join, k, path, rows[k], diagnostics);
    for (std::size_t k = 1; k < rows.size(); ++k) {
      check_match(plan, join, k, path, rows[0], rows[k], limits, diagnostics);
      check_widths(join.places[k], path, rows[0], rows[k], limits, diagnostics);
    }
  }
}

void check_hangings(const NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics) {
  Ledger hung("hung");
  for (std::size_t i = 0; i < plan.hangings.size(); ++i) {
    const Hanging& h = plan.hangings[i];
    const std::string path = h.path.empty() ? indexed("hang", i) : h.path;
    const EdgeSet edge = find_edge(plan, h.edge, h.edge_place, path, diagnostics);
    const Rope* rope = find_rope_or_say(plan, h.rope, h.rope_place, path, diagnostics);
    if (!rope || !rope->is_selvedge) hung.enter(edge, h.edge_place, path, diagnostics);
    if (edge.edges.empty()) continue;
    check_hanging(h, edge, path, limits, diagnostics);
    if (rope) check_times(h, edge, *rope, path, diagnostics);
  }
}

void check_rims(const NetPlan& plan, formats::Diagnostics& diagnostics) {
  for (const auto& body : plan.bodies) {
    if (body.rim.empty()) continue;
    const std::string path = path_of({"bodies", body.name, "rim", "edge"});
    const EdgeSet edge = find_edge(plan, body.rim, body.rim_place, path, diagnostics);
    if (edge.edges.empty() || (body.stands == Standing::pair) == (edge.times() == 2)) continue;
    const bool is_pair = body.stands == Standing::pair;
    diagnostics.error(body.rim_place,
                      fmt::format("{}: {} exists {}, but {} {}", path, body.rim,
                                  is_pair ? "once" : "to port and to starboard", body.name,
                                  is_pair ? "to port and to starboard" : "once"),
                      "",
                      {set(path_of({"bodies", body.name, "stands"}), as_text(is_pair ? "middle" : "pair"))});
  }
}

void check_loose_ropes(const NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics) {
  const HangingsByRope hangings = hangings_by_rope(plan);
  for (const auto& rope : plan.ropes)
    if (const double hung = hung_on(plan, hangings, rope); hung > 0 && hung < limits.loose_rope * rope.length)
      say_loose(rope, hung, diagnostics);
}

/// Refuses a second headline or footrope.
void check_roles(const NetPlan& plan, formats::Diagnostics& diagnostics) {
  std::map<std::string, const Rope*> first;
  for (const auto& rope : plan.ropes) {
    if (rope.role != "headline" && rope.role != "footrope") continue;
    const auto [earlier, is_new] = first.emplace(rope.role, &rope);
    if (!is_new)
      diagnostics.error(rope.role_place,
                        fmt::format("{}: {} is the {} already, at {}", rope.name, earlier->second->name,
                                    rope.role, diagnostics.where(earlier->second->role_place)),
                        "one of the two may have another role",
                        {set(path_of({"ropes", rope.name, "role"}), as_text("fishing-line")),
                         set(path_of({"ropes", rope.name, "role"}), as_text("ground-rope"))});
  }
}

void check_ropes(const NetPlan& plan, const CheckLimits& limits, formats::Diagnostics& diagnostics) {
  check_roles(plan, diagnostics);
  const HangingsByRope hangings = hangings_by_rope(plan);
  for (const auto& rope : plan.ropes) {
    check_rope_length(plan, hangings, rope, limits, diagnostics);
    for (const auto& end : rope.between)
      if (!end.empty()) {
        check_end(plan, rope, end, diagnostics);
        check_end_aside(plan, rope, end, diagnostics);
      }
  }
}

void check_connections(const NetPlan& plan, formats::Diagnostics& diagnostics) {
  Connections all;
  std::set<std::string> tied;  // the parts and points to which ropes lead
  for (const auto& rope : plan.ropes)
    for (const auto& end : rope.between) tied.insert(owner(end));
  for (const auto& panel : plan.panels) all.add(panel.name, panel.place);
  for (const auto& rope : plan.ropes) all.add(rope.name, rope.place);
  for (const auto& point : plan.points)
    if (!plan.find_body(owner(point.name))) all.add(point.name, point.place);
  for (const auto& body : plan.bodies)
    if (tied.contains(body.name) || !body.rim.empty())
      all.add(body.name, body.place);  // a scene may attach other bodies without ropes
  for (const auto& join : plan.joins) connect_join(all, join);
  for (const auto& hanging : plan.hangings) all.connect(owner(hanging.edge), hanging.rope);
  for (const auto& body : plan.bodies)
    if (!body.rim.empty()) all.connect(body.name, owner(body.rim));
  for (const auto& rope : plan.ropes)
    for (const auto& end : rope.between) all.connect(rope.name, owner(end));
  all.report(diagnostics);
}

}  // namespace netloft::gears
