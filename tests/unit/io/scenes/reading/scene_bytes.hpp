// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/scenes/reading/loaded_scene.hpp"

#include <cstring>
#include <string>

namespace netloft::scenes {

/// All data of a loaded scene as bytes. If a struct gets another member, this does not compile until the
/// member is added.
class SceneBytes {
 public:
  explicit SceneBytes(const LoadedScene& loaded) { put(loaded); }
  const std::string& bytes() const { return bytes_; }

 private:
  template <class T>
  requires std::is_arithmetic_v<T> || std::is_enum_v<T>
  void put(T number) { bytes_.append(reinterpret_cast<const char*>(&number), sizeof number); }
  void put(const std::string& text) {
    put(text.size());
    bytes_ += text;
  }
  void put(const std::filesystem::path& path) { put(path.string()); }
  template <class T, std::size_t n>
  void put(const std::array<T, n>& all) {
    for (const T& one : all) put(one);
  }
  template <class T>
  void put(const std::vector<T>& all) {
    put(all.size());
    for (const auto& one : all) put(static_cast<const T&>(one));
  }
  template <class T>
  void put(const std::set<T>& all) {
    put(all.size());
    for (const T& one : all) put(one);
  }
  template <class K, class T>
  void put(const std::map<K, T>& all) {
    put(all.size());
    for (const auto& [key, one] : all) put_all(key, one);
  }
  template <class T>
  void put(const std::optional<T>& one) {
    put(one.has_value());
    if (one) put(*one);
  }
  template <class... T>
  void put(const std::variant<T...>& one) {
    put(one.index());
    std::visit([this](const auto& value) { put(value); }, one);
  }
  template <class... T>
  void put_all(const T&... all) {
    (put(all), ...);
  }

  void put(const formats::Place& p) { put_all(p.file, p.line, p.column, p.length); }
  void put(const formats::SourceFile& f) { put_all(f.path, f.text, f.hash); }
  void put(const SceneWater& w) {
    const auto& [density, gravity, viscosity] = w;
    put_all(density, gravity, viscosity);
  }
  void put(const Current::Sample& s) { put_all(s.z, s.velocity); }
  void put(const Current::Factor& f) { put_all(f.t, f.value); }
  void put(const Current::Drift& d) { put_all(d.t, d.velocity); }
  void put(const Current& c) {
    const auto& [samples, factors, drifts, tow] = c;
    put_all(samples, factors, drifts, tow);
  }
  void put(const SeaBed& b) {
    const auto& [is_there, depth, slope_x, slope_y, relief] = b;
    put_all(is_there, depth, slope_x, slope_y, relief.empty());
    for (const double x : {-7.0, 0.0, 13.0}) put(b.at(x, 3));
  }
  void put(const LawChoice& l) { put_all(l.type, l.parameters); }
  void put(const Part& p) {
    const auto& [name, type, parameters, nodes, data, laws, companion, viscosity_ratio, flow, reach] = p;
    put_all(name, type, parameters, nodes, data, laws, companion, viscosity_ratio, flow.value_or(0), reach);
  }
  void put(const NodeLabel& l) { put_all(l.part, l.id); }
  void put(const Course::Knot& k) { put_all(k.t, k.d, k.v); }
  void put(const Guide& g) {
    const auto& [nodes, axes, course] = g;
    put_all(nodes, axes, course.knots);
  }
  void put(const RigidBody::Point& p) { put_all(p.node, p.r); }
  void put(const RigidBody& b) {
    const auto& [name, origin, rotation, held_rotation, points, rotation_node] = b;
    put_all(name, origin, rotation, held_rotation, points, rotation_node);
  }
  void put(const Setting& s) {
    const auto& [name, part, datum, unit, node, wanted, factor] = s;
    put_all(name, part, datum, unit, node, wanted, factor);
  }
  void put(const WinchStage& s) {
    const auto& [follows, from, rows, max_speed, band, dead_band] = s;
    put_all(follows, from, rows, max_speed, band, dead_band);
  }
  void put(const Winch& w) {
    const auto& [part, parameter, block, length, stages] = w;
    put_all(part, parameter, block, length, stages);
  }
  void put(const WaterMotion& m) { put_all(m.velocity, m.acceleration, m.velocity_dz, m.surface); }
  void put(const Scene& s) {
    const auto& [name, water, current, waves, ground, bed, positions, held, frames, bodies, carried, guides,
                 labels, parts, settings, winches] = s;
    put_all(name, water, current, ground, bed, positions, held, frames, bodies, carried, guides, labels,
            parts, settings, winches, waves != nullptr);
    for (const double t : {0.0, 1.7})
      if (waves) put(waves->at({1, 2, -3}, t));
  }
  void put(const PartGeometry& g) {
    const auto& [name, place, nodes, cells, panel, sets, is_numbered] = g;
    put_all(name, place, nodes, cells, panel, sets, is_numbered);
  }
  void put(const BodyInScene& b) {
    const auto& [part, side, points, outline] = b;
    put_all(part, side, points, outline);
  }
  void put(const Hold& h) { put_all(h.name, h.nodes, h.axes); }
  void put(const ResultRequest& r) {
    const auto& [name, of, take, how, quantity, unit, doc, source, axis, body, nodes, part] = r;
    put_all(name, of, take, how, quantity, unit, doc, source, axis, body, nodes, part);
  }
  void put(const MarchSettings& m) {
    const auto& [duration, step, adaptive, accuracy, longest, shortest, interval, dense, budget, judged,
                 check, disturb, pace, mass_damping] = m;
    put_all(duration, step, adaptive, accuracy, longest, shortest, interval, dense, budget, judged, check,
            disturb, pace, mass_damping);
  }
  void put(const Dynamics& d) {
    const auto& [integrator, parameters, march, material, stiffness, from_equilibrium, start_file] = d;
    put_all(integrator, parameters, march, material, stiffness, from_equilibrium, start_file);
  }
  void put(const Limits& l) {
    const auto& [tolerance, iterations, seconds, interrupt, path, model, work, judging] = l;
    put_all(tolerance, iterations, seconds, path, work, judging.examine_growth, judging.accept_oscillation);
  }
  void put(const Analysis& a) {
    const auto& [kind, settles, dynamics, strategy, strategy_parameters, work, solver, solver_parameters,
                 given, limits, tangent] = a;
    put_all(kind, settles, dynamics, strategy, strategy_parameters, work, solver, solver_parameters, given,
            limits, tangent);
  }
  void put(const BillItem& b) {
    const auto& [kind, name, part_name, number, length, diameter, breaking_load, mass, area] = b;
    put_all(kind, name, part_name, number, length, diameter, breaking_load, mass, area);
  }
  void put(const NettingSheet& s) {
    const auto& [name, number, mesh, twine, twines, laid, fore, aft, deep, pieces, outer, inner] = s;
    put_all(name, number, mesh, twine, twines, laid, fore, aft, deep, pieces, outer, inner);
  }
  void put(const SheetPlace& s) { put_all(s.x, s.y, s.x_across, s.y_across, s.x_deep, s.y_deep); }
  void put(const GearInScene& g) {
    const auto& [times, panels, ropes, pieces, points, nodes, size, headline, footrope, across, roles, pairs,
                 ship_speed, ship_efficiency, bill, netting, sheet, division] = g;
    static_cast<void>(division);  // the geometry of the parts already includes this mesh
    put_all(times, panels, ropes, pieces, points, nodes, size, headline, footrope, across, roles, pairs,
            ship_speed, ship_efficiency, bill, netting, sheet);
  }
  void put(const Strength& s) { put_all(s.breaking_load, s.material); }
  void put(const LoadedScene& l) {
    const auto& [scene, parts, bodies, holds, results, analysis, files, gear, strengths, index_of_parts] = l;
    static_cast<void>(index_of_parts);
    put_all(scene, parts, bodies, holds, results, analysis, files, gear, strengths);
  }

  std::string bytes_;
};

}  // namespace netloft::scenes
