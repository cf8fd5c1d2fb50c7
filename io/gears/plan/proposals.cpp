// SPDX-License-Identifier: BSD-3-Clause
#include "io/gears/plan/proposals.hpp"

#include "framework/parameters/nearest.hpp"
#include "io/formats/toml/spelled_value.hpp"
#include "io/gears/plan/outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <tuple>

namespace netloft::gears {

namespace {

constexpr std::size_t kMostRates = 3;  // rates that are proposed for one panel
/// Cutting rates in common use (FAO, Fisherman's Workbook, 1990, "cutting rates").
constexpr const char* kUsualRates[] = {"AB",   "AN",   "1N1B", "1N2B", "1N3B", "1N4B", "1N5B", "1N6B",
                                       "2N1B", "3N1B", "4N1B", "5N1B", "1T1B", "1T2B", "1T4B"};

bool lies_across(const Panel& panel) { return panel.stands == Standing::middle; }

std::string key_of_side(const Panel& panel, bool is_outer) {
  return lies_across(panel) ? "sides" : is_outer ? "outer" : "inner";
}

std::vector<Cut>& side_of(Panel& panel, bool is_outer) { return is_outer ? panel.outer : panel.inner; }
const std::vector<Cut>& side_of(const Panel& panel, bool is_outer) {
  return is_outer ? panel.outer : panel.inner;
}

/// Whether a side is written as one text, such as sides = "5B1P in".
bool is_one_text(const std::vector<Cut>& side, const std::string& key) {
  return side.size() == 1 && side[0].name == key;
}

/// Calls visit(is_outer, index of the cut) for all cuts of a panel.
void for_cuts(const Panel& panel, const std::function<void(bool, std::size_t)>& visit) {
  for (const bool is_outer : {true, false})
    for (std::size_t i = 0; i < side_of(panel, is_outer).size(); ++i) visit(is_outer, i);
}

std::string path_of_side(const Panel& panel, bool is_outer) {
  return path_of({"panels", panel.name, key_of_side(panel, is_outer)});
}

/// The path of a key of one cut in the list of a side.
std::string path_of_cut(const Panel& panel, bool is_outer, std::size_t which, const char* key) {
  return fmt::format("{}[{}].{}", path_of_side(panel, is_outer), which, key);
}

/// The path of the text with the rate of a cut.
std::string path_of_rate(const Panel& panel, bool is_outer, std::size_t which) {
  return is_one_text(side_of(panel, is_outer), key_of_side(panel, is_outer))
             ? path_of_side(panel, is_outer)
             : path_of_cut(panel, is_outer, which, "cut");
}

std::string written(const std::string& rate, int goes) {
  return goes == 0 ? rate : rate + (goes < 0 ? " in" : " out");
}

/// The panel after the extents of its cuts are computed again.
Panel settled(Panel panel) {
  settle(panel.outer, panel.depth);
  settle(panel.inner, panel.depth);
  return panel;
}

/// The number of meshes at the aft edge from the cuttings, minus the number in the plan.
double excess_of(const Panel& panel) { return aft_by_cuttings(panel) - panel.count(panel.aft); }

bool is_as_deep_as_the_panel(const Panel& panel, const std::vector<Cut>& side, const CheckLimits& limits) {
  double deep = 0;
  for (const auto& cut : side) deep += cut.deep;
  return side.empty() || std::abs(deep - panel.depth) <= limits.closing_meshes;
}

bool closes(const Panel& panel, const CheckLimits& limits) {
  return std::abs(excess_of(panel)) <= limits.closing_meshes &&
         is_as_deep_as_the_panel(panel, panel.outer, limits) &&
         is_as_deep_as_the_panel(panel, panel.inner, limits);
}

/// A number of meshes, rounded in the ways in which a net maker might write it; the roundest number first.
std::vector<double> roundings(double meshes) {
  std::vector<double> all;
  for (const double step : {1.0, 0.5, 0.1})
    if (const double rounded = step == 0.1 ? std::round(10 * meshes) / 10 : step * std::round(meshes / step);
        rounded >= 0 && std::find(all.begin(), all.end(), rounded) == all.end())
      all.push_back(rounded);
  return all;
}

/// A rate with the letters and in the order of the rate `written`: "2B1P" instead of "1N2B" next to "5B1P".
/// `text` is the usual spelling of the rate.
std::string spelled_like(const std::string& written, const CuttingRate& rate, const std::string& text) {
  if (text[0] == 'A' || written.empty()) return text;
  const bool has_points = rate.points > 0;
  const char* letter = has_points ? (written.find('P') != std::string::npos ? "P" : "N")
                                  : (written.find('M') != std::string::npos ? "M" : "T");
  const std::string bars = fmt::format("{}B", rate.bars);
  const std::string others = fmt::format("{}{}", has_points ? rate.points : rate.meshes, letter);
  const std::size_t letter_of_bars = written.find('B');
  const bool begins_with_bars =
      written[0] != 'A' && letter_of_bars != std::string::npos && letter_of_bars + 1 < written.size();
  return begins_with_bars ? bars + others : others + bars;
}

/// Makes proposals for a panel whose cuttings disagree with its aft count.
class Closing {
 public:
  Closing(const Panel& panel, const CheckLimits& limits) : panel_(panel), limits_(limits) {}

  Cures all() {
    add_counts(panel_.aft, "aft", excess_of(panel_));
    add_counts(panel_.fore, panel_.is_round ? "round" : "fore", -excess_of(panel_));
    add_number(path_of({"panels", panel_.name, "depth"}), panel_.depth,
               [](Panel& panel, double depth) { panel.depth = depth; });
    for_cuts(panel_, [&](bool is_outer, std::size_t i) { add_extent(is_outer, i); });
    add_rates();
    for (const bool is_outer : {true, false}) add_straight_run(is_outer);
    return likeliest_first();
  }

 private:
  struct Proposal {
    double miss;  // difference between cuttings and aft count that remains [meshes]
    formats::Cure cure;
    bool is_far = false;  // whether the new number has little to do with the old one
  };

  void add(double miss, formats::Cure cure, bool is_far = false) {
    proposals_.push_back({miss, std::move(cure), is_far});
  }

  static bool is_far(double now, double then) { return std::abs(then - now) > 0.5 * now; }

  /// The proposals; those that change a number little and close the panel exactly come first.
  Cures likeliest_first() {
    constexpr double kExact = 0.05;  // [meshes]
    const auto rank = [](const Proposal& p) { return std::tuple(p.is_far, p.miss > kExact); };
    std::stable_sort(proposals_.begin(), proposals_.end(),
                     [&](const Proposal& a, const Proposal& b) { return rank(a) < rank(b); });
    Cures cures;
    for (auto& proposal : proposals_) cures.push_back(std::move(proposal.cure));
    return cures;
  }

  void add_counts(const std::vector<MeshCount>& counts, const char* key, double more) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
      const double wanted = counts[i].meshes + more / (lies_across(panel_) && i > 0 ? 2 : 1);
      const bool is_alone = counts.size() == 1 && (counts[i].name == "fore" || counts[i].name == "aft");
      const std::string path = path_of({"panels", panel_.name, key});
      for (const double meshes : roundings(wanted)) {
        if (std::abs(meshes - wanted) > limits_.closing_meshes) continue;
        add(std::abs(meshes - wanted),
            set(is_alone ? path : fmt::format("{}[{}].meshes", path, i), as_number(meshes)),
            is_far(counts[i].meshes, meshes));
        break;
      }
    }
  }

  /// Proposes the value of a number on which the aft edge depends linearly.
  void add_number(const std::string& path, double now, const std::function<void(Panel&, double)>& put) {
    const auto with = [&](double value) {
      Panel panel = panel_;
      put(panel, value);
      return settled(std::move(panel));
    };
    const double slope = excess_of(with(now + 1)) - excess_of(with(now));
    if (std::abs(slope) < 1e-6) return;
    for (const double value : roundings(now - excess_of(panel_) / slope))
      if (value > 0 && closes(with(value), limits_))
        return add(std::abs(excess_of(with(value))), set(path, as_number(value)), is_far(now, value));
  }

  /// Proposes another depth or another number of meshes across for a cut that states it.
  void add_extent(bool is_outer, std::size_t which) {
    const Cut& cut = side_of(panel_, is_outer)[which];
    if (cut.said_deep)
      add_number(path_of_cut(panel_, is_outer, which, "depth"), *cut.said_deep,
                 [=](Panel& panel, double deep) { side_of(panel, is_outer)[which].said_deep = deep; });
    if (cut.said_across)
      add_number(path_of_cut(panel_, is_outer, which, "meshes"), *cut.said_across,
                 [=](Panel& panel, double across) { side_of(panel, is_outer)[which].said_across = across; });
  }

  /// A cut at another rate. `letters` is the number of letters that differ from the written rate.
  struct Recut : Proposal {
    std::size_t letters;
  };

  void add_rates() {
    std::vector<Recut> fitting;
    for_cuts(panel_, [&](bool is_outer, std::size_t i) {
      for (const char* rate : kUsualRates)
        for (const int goes : {-1, 1})
          if (const auto recut = this->recut(is_outer, i, rate, goes)) fitting.push_back(*recut);
    });
    std::stable_sort(fitting.begin(), fitting.end(), [](const Recut& a, const Recut& b) {
      return std::tuple(std::round(10 * a.miss), a.letters) < std::tuple(std::round(10 * b.miss), b.letters);
    });
    for (std::size_t k = 0; k < std::min(kMostRates, fitting.size()); ++k)
      proposals_.push_back(std::move(fitting[k]));
  }

  /// Changes one cut to another rate. nullopt if the panel does not close with this rate.
  std::optional<Recut> recut(bool is_outer, std::size_t which, const char* rate, int goes) const {
    Panel panel = panel_;
    Cut& cut = side_of(panel, is_outer)[which];
    const Cut before = cut;
    cut.rate = *parse_rate(rate);
    cut.goes = cut.rate.is_straight() ? 0 : goes;
    const std::string text = spelled_like(before.written, cut.rate, rate);
    const std::string after = written(text, cut.goes);
    panel = settled(std::move(panel));
    if ((parse_rate(rate)->is_straight() && goes < 0) || !closes(panel, limits_)) return std::nullopt;
    const std::string path = path_of_rate(panel_, is_outer, which);

    return Recut{{std::abs(excess_of(panel)), set(path, as_text(after)), false},
                 detail::edit_distance(before.written, text) + (before.goes != goes)};
  }

  /// For a side with a single cut, proposes a straight run before the cut. The cut then has its own rate or,
  /// if that does not fit, the usual rate that is just steep enough.
  void add_straight_run(bool is_outer) {
    const auto& side = side_of(panel_, is_outer);
    if (!is_one_text(side, key_of_side(panel_, is_outer))) return;
    const double wanted =
        side[0].goes * side[0].across - excess_of(panel_) / (lies_across(panel_) ? 2 : 1);  // [meshes]
    const int goes = wanted < 0 ? -1 : 1;
    const auto is_steep_enough = [&](const CuttingRate& rate) {
      return rate.half_meshes_deep() > 0 && rate.across(panel_.depth) > std::abs(wanted);
    };
    std::string best = side[0].goes == goes && is_steep_enough(side[0].rate) ? side[0].written : "";
    if (best.empty()) best = gentlest(is_steep_enough);
    if (!best.empty() && wanted != 0) add_run_before(is_outer, best, goes, std::abs(wanted));
  }

  /// Among the usual rates for which `is_fit` is true, the one that goes least across; an empty text if there
  /// is none.
  static std::string gentlest(const std::function<bool(const CuttingRate&)>& is_fit) {
    std::string best;
    double least = std::numeric_limits<double>::infinity();
    for (const char* rate : kUsualRates)
      if (const double across = parse_rate(rate)->across(1); is_fit(*parse_rate(rate)) && across < least) {
        best = rate;
        least = across;
      }
    return best;
  }

  void add_run_before(bool is_outer, const std::string& rate, int goes, double wanted) {
    for (const double straight : roundings(panel_.depth - parse_rate(rate)->deep(wanted))) {
      Panel panel = panel_;
      auto& side = side_of(panel, is_outer);
      side.insert(side.begin(), Cut{});
      side[0].rate = *parse_rate("AN");
      side[0].said_deep = straight;
      side[1].rate = *parse_rate(rate);
      side[1].goes = goes;
      panel = settled(std::move(panel));
      if (straight <= 0 || !closes(panel, limits_)) continue;
      const formats::Table run{{{"cut", {}, as_text("AN")}, {"depth", {}, as_number(straight)}}};
      const std::string text = spelled_like(side_of(panel_, is_outer)[0].written, *parse_rate(rate), rate);
      const formats::Table rest{{{"cut", {}, as_text(written(text, goes))}}};
      const formats::Array cuts{{formats::Value{{}, run}, formats::Value{{}, rest}}};
      return add(std::abs(excess_of(panel)), set(path_of_side(panel_, is_outer), {{}, cuts}));
    }
  }

  const Panel& panel_;
  const CheckLimits& limits_;
  std::vector<Proposal> proposals_;
};

/// The path of a count, and how many times it is contained in the meshes of the edge.
struct CountPlace {
  std::string path;
  double meshes, times;
};

/// The counts that belong to a fore or aft edge.
std::vector<CountPlace> counts_of(const EdgeSet& edge) {
  const Panel& panel = *edge.panel;
  const bool is_aft = edge.edges[0].kind == EdgeKind::aft;
  const auto& counts = is_aft ? panel.aft : panel.fore;
  const std::string path = path_of({"panels", panel.name,
                                    is_aft           ? "aft"
                                    : panel.is_round ? "round"
                                                     : "fore"});
  std::vector<CountPlace> places;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const bool is_part = std::any_of(edge.edges.begin(), edge.edges.end(),
                                     [&](const OutlineEdge& e) { return e.name == counts[i].name; });
    if (!is_part) continue;
    const bool is_alone = counts.size() == 1 && (counts[i].name == "fore" || counts[i].name == "aft");
    places.push_back({is_alone ? path : fmt::format("{}[{}].meshes", path, i), counts[i].meshes,
                      edge.is_across_middle() && i > 0 ? 2.0 : 1.0});
  }
  return places;
}

/// Proposals for a panel whose aft edge follows from its cuttings: other numbers, with which this edge has
/// `meshes` meshes.
Cures cures_of_following(Panel panel, double meshes) {
  if (meshes < 0) return {};
  panel.aft = {{"aft", std::round(meshes), {}}};
  Cures cures = cures_of_closing(panel, {});
  const std::string own = path_of({"panels", panel.name, "aft"}) + "=";
  std::erase_if(cures, [&](const formats::Cure& cure) { return cure.changes[0].starts_with(own); });
  return cures;
}

/// The places of the numbers that give the depth of a side, or of the cuts that belong to an edge.
std::vector<CountPlace> depths_of(const EdgeSet& edge) {
  const Panel& panel = *edge.panel;
  const bool is_outer = edge.edges[0].kind == EdgeKind::outer;
  const auto& side = side_of(panel, is_outer);
  std::vector<CountPlace> places;
  for (std::size_t i = 0; i < side.size(); ++i) {
    const bool is_part = std::any_of(edge.edges.begin(), edge.edges.end(),
                                     [&](const OutlineEdge& e) { return e.name == side[i].name; });
    if (!is_part) continue;
    if (side[i].said_deep)
      places.push_back({path_of_cut(panel, is_outer, i, "depth"), *side[i].said_deep, 1});
    else if (!side[i].said_across)
      places.push_back({path_of({"panels", panel.name, "depth"}), panel.depth / panel.pieces,
                        static_cast<double>(panel.pieces)});
  }
  return places;
}

}  // namespace

std::string path_of(std::initializer_list<std::string_view> keys) {
  std::string path;
  for (const std::string_view key : keys) path = formats::join_path(path, key);
  return path;
}

formats::Cure set(const std::string& path, const formats::Value& value, std::string note) {
  return {{path + "=" + formats::spell_value(value)}, std::move(note)};
}

formats::Value as_number(double number) {
  constexpr double kTenDigits = 1e10, kMostWhole = 1e15;
  const double rounded = std::round(number * kTenDigits) / kTenDigits;
  if (std::abs(rounded) < kMostWhole && rounded == std::round(rounded))
    return {{}, static_cast<std::int64_t>(rounded)};
  return {{}, rounded};
}

formats::Value as_metres(double metres) { return as_text(fmt::format("{:.7g} m", metres)); }

formats::Value as_text(std::string text) { return {{}, std::move(text)}; }

double millimetres_below(double metres) { return std::floor(1e3 * metres * (1 + 1e-12)) / 1e3; }
double millimetres_above(double metres) { return std::ceil(1e3 * metres * (1 - 1e-12)) / 1e3; }

std::vector<std::string> rates_near(double across, double deep) {
  constexpr int kMostInARate = 9;     // bars, points or meshes of a rate that somebody cuts
  constexpr double kHalfAMesh = 0.5;  // on one side; both sides together miss by the mesh that seams can hide
  struct Rate {
    double miss;
    int letters;
    std::string text;
  };
  std::vector<Rate> rates = {{across, 0, "AN"}};
  for (int bars = 1; bars <= kMostInARate; ++bars)
    for (int others = 0; others <= kMostInARate; ++others)
      for (const char letter : {'P', 'M'}) {
        const std::string text = others == 0 ? "AB" : fmt::format("{}B{}{}", bars, others, letter);
        if (std::ranges::find(rates, text, &Rate::text) != rates.end()) continue;
        rates.push_back({std::abs(parse_rate(text)->across(deep) - across), bars + others, text});
      }
  std::ranges::stable_sort(
      rates, {}, [&](const Rate& r) { return std::tuple(std::max(r.miss, kHalfAMesh), r.letters); });
  std::vector<std::string> texts;
  for (const Rate& rate : rates)
    if (texts.size() < kMostRates) texts.push_back(rate.text);
  return texts;
}

Cures cures_of_closing(const Panel& panel, const CheckLimits& limits) {
  return panel.has_corners ? Cures{} : Closing(panel, limits).all();
}

Cures cures_of_direction(const Panel& panel) {
  Cures cures;
  for (const bool is_straight : {false, true})
    for_cuts(panel, [&](bool is_outer, std::size_t i) {
      const auto& side = side_of(panel, is_outer);
      if (side[i].goes == 0 || panel.has_corners) return;
      const std::string other = side[i].written + (side[i].goes < 0 ? " out" : " in");
      cures.push_back(set(path_of_rate(panel, is_outer, i), as_text(is_straight ? "AN" : other)));
    });
  return cures;
}

Cures cures_of_depth(const Panel& panel, const std::vector<Cut>& side, const std::string& key) {
  Cures cures;
  double deep = 0;
  for (const auto& cut : side) deep += cut.deep;
  for (std::size_t i = 0; i < side.size(); ++i) {
    const double wanted = side[i].deep - deep + panel.depth;
    const std::string path = fmt::format("{}[{}].", path_of({"panels", panel.name, key}), i);
    if (wanted <= 0 || panel.has_corners) continue;
    if (side[i].said_deep)
      cures.push_back(set(path + "depth", as_number(wanted)));
    else if (side[i].said_across)
      cures.push_back(set(path + "meshes", as_number(std::round(10 * side[i].rate.across(wanted)) / 10)));
  }
  cures.push_back(
      set(path_of({"panels", panel.name, "depth"}), as_number(std::round(10 * deep / panel.pieces) / 10)));
  return cures;
}

Cures cures_of_rate(const Panel& panel, bool is_outer, std::size_t which, std::vector<std::string> rates) {
  const int goes = side_of(panel, is_outer)[which].goes;
  for (const char* rate : kUsualRates)
    if (std::find(rates.begin(), rates.end(), rate) == rates.end()) rates.emplace_back(rate);
  Cures cures;
  for (const auto& rate : rates)
    cures.push_back(set(path_of_rate(panel, is_outer, which), as_text(written(rate, goes))));
  return cures;
}

Cures cures_of_edge(const EdgeSet& edge, double more) {
  Cures cures;
  if (!edge.panel || edge.edges.empty() || edge.panel->has_corners) return cures;
  if (edge.edges[0].kind == EdgeKind::aft && !edge.panel->states_aft)
    return cures_of_following(*edge.panel, edge.panel->count(edge.panel->aft) + more);
  for (const auto& place : edge.is_side() ? depths_of(edge) : counts_of(edge)) {
    const double wanted = place.meshes + more / place.times;
    for (const double meshes : roundings(wanted))
      if (meshes > 0 && std::abs(meshes - wanted) <= 0.5) {
        cures.push_back(set(place.path, as_number(meshes)));
        break;
      }
  }
  return cures;
}

}  // namespace netloft::gears
