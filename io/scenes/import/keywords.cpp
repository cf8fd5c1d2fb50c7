// SPDX-License-Identifier: BSD-3-Clause
#include "io/scenes/import/keywords.hpp"

#include "io/formats/units/degrees.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace netloft::scenes::femnet {

namespace {

constexpr int kMostTableRows = 10000;  // limit of rows; a larger number is an error

/// Keywords without effect on the results of an import. A * at the beginning or the end of a name stands for
/// any letters.
constexpr const char* kIdle[] = {"Auto_convergence",
                                 "convergence_parameters",
                                 "link_*",
                                 "Meshing_*",
                                 "color_*",
                                 "no_visible_*",
                                 "*_plan",
                                 "plan_cable",
                                 "panel_cutting",
                                 "node_position",
                                 "paraview",
                                 "nrj",
                                 "haul"};
/// Keywords that change the drawing. They have no effect if the gear has a mesh already.
constexpr const char* kOfMesher[] = {"type_noeud_*", "rope_X",       "add_*",   "rot_*",
                                     "homothety",    "translation*", "symmetr*"};
/// Keywords for a motion, which have no effect at rest.
constexpr const char* kOfMotion[] = {"hauling_*", "speed_type_node*", "wave_*", "winch_*", "time_*"};
/// Keywords that change the results and have no counterpart in a scene.
constexpr const char* kMissing[] = {"catch_gravity",
                                    "catch2_volume",
                                    "catch",
                                    "tarp",
                                    "slider",
                                    "cable_contact",
                                    "deck",
                                    "ballast2",
                                    "foil",
                                    "openfoam",
                                    "tab_drag_filt",
                                    "elem_noeud",
                                    "current_reduction",
                                    "spheric_limit",
                                    "water_speed_depth",
                                    "wind"};

bool is_like(std::string_view name, std::string_view pattern) {
  if (pattern.ends_with('*')) return name.starts_with(pattern.substr(0, pattern.size() - 1));
  if (pattern.starts_with('*')) return name.ends_with(pattern.substr(1));
  return name == pattern;
}

template <std::size_t N>
bool is_one_of(std::string_view name, const char* const (&patterns)[N]) {
  return std::any_of(std::begin(patterns), std::end(patterns),
                     [&](const char* p) { return is_like(name, p); });
}

/// Reads the tail of a gear file. Each keyword that changes the gear has a member function of its name.
class KeywordReader {
 public:
  KeywordReader(DonScanner& in, GearFile& gear, formats::Diagnostics& diagnostics)
      : in_(in), gear_(gear), diagnostics_(diagnostics) {}

  void read() {
    for (auto word = in_.word(); !word.empty() && !in_.has_failed(); word = in_.word()) {
      if (word != "input") continue;
      at_ = in_.place_of_word();
      if (in_.has_one_separator())
        read_keyword(std::string(in_.word()));
      else
        diagnostics_.warning(
            at_, "this word is not followed by exactly one blank, so that FEMNET does not see the keyword",
            "the import does not read it, either; write one blank behind it if it is meant");
    }
  }

 private:
  using Step = void (KeywordReader::*)();
  struct Known {
    const char* name;
    Step step;
  };

  void read_keyword(const std::string& name) {
    static constexpr Known known[] = {{"water_density", &KeywordReader::water_density},
                                      {"moving_bottom", &KeywordReader::moving_bottom},
                                      {"sphere_element", &KeywordReader::sphere_element},
                                      {"sphere_element2", &KeywordReader::sphere_element2},
                                      {"EI_flexion_cable", &KeywordReader::bend_cable},
                                      {"link_flexion_elem2", &KeywordReader::clamp},
                                      {"netting2ropes", &KeywordReader::netting_to_ropes},
                                      {"drag_forces_type", &KeywordReader::drag_type},
                                      {"spheric_knot", &KeywordReader::knot},
                                      {"neutral_angle", &KeywordReader::neutral_angle},
                                      {"EI_flexion", &KeywordReader::bend_twines},
                                      {"foil2", &KeywordReader::foil},
                                      {"cable_tension_constant", &KeywordReader::constant_tension},
                                      {"hauling_cable4", &KeywordReader::drum},
                                      {"speed_type_node2", &KeywordReader::node_motion},
                                      {"wave_model", &KeywordReader::wave_model},
                                      {"link", &KeywordReader::link},
                                      {"type_noeud_XYZ_SUPINF", &KeywordReader::type_box}};
    name_ = name;
    name_place_ = in_.place_of_word();
    for (const auto& k : known)
      if (name == k.name) return (this->*k.step)();
    if (is_one_of(name, kMissing)) return leave_out("is not modelled here");
    if (is_one_of(name, kOfMotion)) return leave_to_motion();
    if (is_one_of(name, kOfMesher)) return leave_to_mesher();
    if (!is_one_of(name, kIdle)) note("is not known, and not read");
  }

  void note(const std::string& text) { add(Finding::Kind::note, text); }
  void leave_out(const std::string& text) { add(Finding::Kind::left_out, text); }
  void add(Finding::Kind kind, const std::string& text) {
    gear_.findings.push_back({name_place_, kind, "keyword " + name_.substr(0, 40), text});
  }

  void leave_to_mesher() {
    gear_.of_mesher.push_back({name_place_, Finding::Kind::left_out, "keyword " + name_.substr(0, 40),
                               "changes the drawing; the import uses the drawing as the file has it"});
  }

  void leave_to_motion() {
    gear_.of_motion.push_back({name_place_, Finding::Kind::left_out, "keyword " + name_.substr(0, 40),
                               "motion of this kind is not known here"});
  }

  double number() { return in_.next_real(("an argument of " + name_).c_str()); }

  /// The panel, cable or node type whose number follows in the text; nullptr after an error.
  template <class T>
  T* one_of(std::vector<T>& all, const char* what) {
    const int number = in_.next_integer(("an argument of " + name_).c_str());
    if (in_.has_failed()) return nullptr;
    if (number >= 1 && static_cast<std::size_t>(number) <= all.size())
      return &all[static_cast<std::size_t>(number) - 1];
    in_.fail(name_place_, name_ + ": there is no " + what + " " + std::to_string(number),
             all.empty() ? "there are none" : "there are 1 to " + std::to_string(all.size()));
    return nullptr;
  }
  Panel* panel() { return one_of(gear_.panels, "panel"); }
  Cable* cable() { return one_of(gear_.cables, "cable"); }

  void water_density() { gear_.environment.water_density = number(); }
  void moving_bottom() { gear_.environment.bed_moves = true; }
  void wave_model() { gear_.environment.wave_model = in_.next_integer("an argument of wave_model"); }
  void link() { gear_.link_distance = number(); }

  /// Reads the arguments of a box: the code 13, x1 x2 y1 y2 z1 z2, type. Other codes mean half-spaces, which
  /// only FEMNET's mesher uses.
  void type_box() {
    const int code = in_.next_integer("a code of type_noeud_XYZ_SUPINF");
    if (code != 13 || gear_.plane != 3) return leave_to_mesher();
    TypeBox box{name_place_};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::minmax({number(), number()});
      box.low[axis] = low;
      box.high[axis] = high;
    }
    const NodeType* type = one_of(gear_.types, "type");
    if (!type) return;
    box.type = static_cast<int>(type - gear_.types.data());
    gear_.type_boxes.push_back(box);
  }

  std::vector<double> numbers(std::size_t count) {
    std::vector<double> all;
    while (all.size() < count && !in_.has_failed()) all.push_back(number());
    return all;
  }
  std::size_t rows_of_table() {
    const int rows = in_.next_integer(("the number of times of " + name_).c_str());
    if (!in_.has_failed() && (rows < 1 || rows > kMostTableRows))
      in_.fail(name_place_, name_ + ": a table of " + std::to_string(rows) + " times; 1 to " +
                                std::to_string(kMostTableRows) + " are expected");
    return in_.has_failed() ? 0 : static_cast<std::size_t>(rows);
  }
  std::vector<double> times(std::size_t rows) {
    auto all = numbers(rows);
    if (!in_.has_failed() && std::adjacent_find(all.begin(), all.end(), std::greater_equal<>()) != all.end())
      in_.fail(name_place_, name_ + ": its times do not ascend");
    return all;
  }

  /// Reads the arguments of a drum: cable, shortest and longest bar, n, n times, n speeds, n ends.
  void drum() {
    const Cable* c = cable();
    if (!c) return;
    Drum d;
    d.place = name_place_;
    d.cable = static_cast<int>(c - gear_.cables.data());
    d.shortest = number();
    d.longest = number();
    const std::size_t rows = rows_of_table();
    d.times = times(rows);
    d.speeds = numbers(rows);
    for (std::size_t i = 0; i < rows && !in_.has_failed(); ++i)
      d.ends.push_back(in_.next_integer("an end of a cable"));
    if (in_.has_failed()) return;
    if (!(d.shortest > 0) || !(d.longest >= d.shortest))
      return in_.fail(name_place_, name_ +
                                       ": the two lengths are the least and the greatest length of a bar, "
                                       "and the first must be above zero");
    if (std::any_of(d.ends.begin(), d.ends.end(), [](int end) { return end != 1 && end != 2; }))
      return in_.fail(name_place_, name_ + ": a drum is at end 1 or 2 of its cable");
    gear_.drums.push_back(std::move(d));
  }

  /// Reads the arguments of a motion of nodes: type, n, n times, n velocities along x, y and z.
  void node_motion() {
    const NodeType* type = one_of(gear_.types, "type");
    if (!type) return;
    NodeMotion m;
    m.place = name_place_;
    m.type = static_cast<int>(type - gear_.types.data());
    const std::size_t rows = rows_of_table();
    m.times = times(rows);
    for (auto& axis : m.velocity) axis = numbers(rows);
    if (!in_.has_failed()) gear_.motions.push_back(std::move(m));
  }

  void drag_type() {
    gear_.environment.drag_type = in_.next_integer("a kind of drag");
    if (gear_.environment.drag_type == 2) leave_out("drag law 2 is not known; drag law 1 is used instead");
  }

  void sphere_element() {
    if (Cable* c = cable()) smear_floats(*c, c->length);
  }
  void sphere_element2() {
    Cable* c = cable();
    if (c) smear_floats(*c, 0);
  }

  /// Adds n spheres (floats) of diameter D and net buoyancy F to a cable of length L, as if they were part of
  /// the cable. d is the diameter of the cable, ρ its density, C its drag coefficient; a prime marks the new
  /// values. V is the volume of a sphere, m its mass, V_c the volume of the cable, g gravity, ρ_w the density
  /// of water:
  ///   V = π D³/6,  m = V ρ_w − F/g,  V_c = L π d²/4
  ///   ρ′ = (V_c ρ + n m)/(V_c + n V),  d′ = √(4 (V_c + n V)/(π L)),  C′ = (0.6 n π D²/4 + C L d)/(L d′)
  void smear_floats(Cable& c, double length) {
    constexpr double pi = std::numbers::pi;
    const double n = number(), D = number(), F = number(), L = length > 0 ? length : number();
    if (in_.has_failed()) return;
    const double V = pi * D * D * D / 6, m = V * gear_.environment.water_density - F / kGravity;
    const double V_c = L * pi * c.diameter * c.diameter / 4, whole = V_c + n * V;
    if (!(L > 0) || !(whole > 0))
      return in_.fail(name_place_, name_ + ": neither the cable nor its spheres have a volume");
    if (m < 0)
      diagnostics_.warning(name_place_, name_ + ": the spheres lift more than the water that they displace");
    const double d = std::sqrt(4 * whole / (pi * L));
    c.cd = (0.6 * n * pi * D * D / 4 + c.cd * L * c.diameter) / (L * d);
    c.density = (V_c * c.density + n * m) / whole;
    c.diameter = d;
    char text[120];
    std::snprintf(text, sizeof text, "%s%.6g spheres of %.6g m and %.6g N", c.floats.empty() ? "" : ", ", n,
                  D, F);
    c.floats += text;
  }

  void bend_cable() {
    if (Cable* c = cable()) c->EI = number();
  }

  void clamp() {
    const Cable *first = cable(), *second = first ? cable() : nullptr;
    const double angle = second ? number() : 0;
    if (in_.has_failed() || !second) return;
    gear_.clamps.push_back({name_place_, static_cast<int>(first - gear_.cables.data()),
                            static_cast<int>(second - gear_.cables.data()), angle});
  }

  void netting_to_ropes() {
    Panel* p = panel();
    if (!p) return;
    p->twines = number();
    number();
    number();
    number();
    const auto bars = in_.try_real();
    p->bars = bars.value_or(0);
    if (!bars && !in_.has_failed()) {
      p->twines = 0;
      return note("has no number of bars, as in an older FEMNET: its panel is taken as triangles");
    }
    if (!in_.has_failed() && !(p->twines > 0 && p->bars > 0))
      in_.fail(name_place_, "netting2ropes: the twines of a bar and the number of bars must be above zero");
  }

  void knot() {
    if (Panel* p = panel()) p->knot_size = number();
  }
  void neutral_angle() {
    if (Panel* p = panel()) p->neutral_angle = number();
  }
  void bend_twines() {
    if (Panel* p = panel()) p->EI = number();
  }

  void constant_tension() {
    if (Cable* c = cable()) c->constant_tension = number();
  }

  /// Sets the force on nodes of a type to that of a foil of area S in the current c: q c_d along the current,
  /// q c_l across it and q c_z upward, where q = ρ S c²/2 and ρ is the density of water.
  void foil() {
    NodeType* type = one_of(gear_.types, "type");
    const double S = number(), cd = number(), cl = number(), cz = number();
    if (in_.has_failed() || !type) return;
    const Environment& e = gear_.environment;
    const double psi = formats::in_radians(e.direction), q = 0.5 * e.water_density * S * e.speed * e.speed;
    type->force = {q * (cd * std::cos(psi) - cl * std::sin(psi)),
                   q * (cd * std::sin(psi) + cl * std::cos(psi)), q * cz};
  }

  DonScanner& in_;
  GearFile& gear_;
  formats::Diagnostics& diagnostics_;
  formats::Place at_, name_place_;
  std::string name_;
};

}  // namespace

void read_keywords(DonScanner& in, GearFile& gear, formats::Diagnostics& diagnostics) {
  KeywordReader(in, gear, diagnostics).read();
}

}  // namespace netloft::scenes::femnet
