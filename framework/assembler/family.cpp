// SPDX-License-Identifier: BSD-3-Clause
#include "framework/assembler/family.hpp"

#include "framework/assembler/changed_water.hpp"
#include "framework/registry/plugin_call.hpp"

#include <cstdio>
#include <stdexcept>

namespace netloft {

ElementFamily::ElementFamily(const Scene& scene, const FamilyPlan& plan, std::uint32_t first_global_node)
    : type_(plan.type), parts_(plan.parts), viscosity_ratio_(plan.viscosity_ratio) {
  for (std::size_t i = 0; i < plan.terms.size(); ++i)
    if (plan.terms[i].on && !is_in_changed_water(plan, plan.terms[i]))
      terms_.push_back(type_->terms[i]);
    else if (plan.terms[i].on)
      continue;  // another family evaluates this term
    else if (plan.terms[i].when_it_moves)
      terms_of_motion_.push_back(type_->terms[i]);
  gather_parameters(scene);
  gather_laws(scene, plan);
  gather_elements(scene);
  gather_nodes(scene, first_global_node);
  create(scene);
  gather_globals(scene, first_global_node);
}

ElementFamily::ElementFamily(const Scene& scene, const FamilyPlan& plan, const ElementFamily& base,
                             const ElementFamily& flow)
    : parts_(base.parts_),
      viscosity_ratio_(base.viscosity_ratio_),
      part_begin_(base.part_begin_),
      part_(base.part_),
      arms_(base.arms_),
      changed_water_(std::make_unique<ChangedWater>(scene, plan, base, flow)) {
  type_ = &changed_water_->type();
  terms_ = type_->terms;
  const std::uint32_t unknowns = changed_water_->node();
  for (std::size_t e = 0; e < size(); ++e) {
    for (int corner = 0; corner < base.all_nodes_per_element(); ++corner)
      nodes_.push_back(base.node(e, corner));
    nodes_.push_back(unknowns);
  }
}

ElementFamily::~ElementFamily() {
  if (!self_) return;
  call_plugin({type_->type.c_str(), "destroy", nullptr, CallFrame::Kind::element}, 0, [&] {
    type_->element.destroy(self_);
    return 0;
  });
}

namespace {

/// Calls a function of a plugin on a tile. The fields of the tile that the host reads afterwards are
/// restored, whatever the plugin wrote there. Returns OK, OUTSIDE_DOMAIN or ERROR. Unless it is OK, the
/// message of the tile is a sentence about the failure.
template <class Function>
int call_on_tile(const CallFrame& frame, netloft_tile& tile, Function&& function) {
  const std::uint32_t first = tile.first, count = tile.count;
  const std::span<char> said{tile.message, tile.message_size};
  const int status = call_plugin(frame, int{NETLOFT_ERROR}, function);
  tile.first = first;
  tile.count = count;
  if (status == NETLOFT_OK) return NETLOFT_OK;
  if (take_broken_rule(said)) return NETLOFT_ERROR;
  if (status == NETLOFT_OUTSIDE_DOMAIN || status == NETLOFT_ERROR) return status;
  std::snprintf(said.data(), said.size(), "%s returned %d, which is no status", text_of(frame).c_str(),
                status);
  return NETLOFT_ERROR;
}

}  // namespace

int ElementFamily::evaluate(const netloft_term& term, netloft_tile& tile) const {
  if (changed_water_) return changed_water_->evaluate(term, tile);
  return call_on_tile({type_->type.c_str(), "term", term.name, CallFrame::Kind::element}, tile,
                      [&] { return term.evaluate(self_, &tile); });
}

int ElementFamily::output(netloft_tile& tile, double* values) const {
  if (changed_water_) return changed_water_->output(tile, values);
  const netloft_tile before = tile;
  const int status =
      call_plugin({type_->type.c_str(), "outputs", nullptr, CallFrame::Kind::element}, int{NETLOFT_ERROR},
                  [&] { return type_->element.output(self_, &tile, values); });
  tile = before;
  if (const std::string broken = take_broken_rule(); !broken.empty()) throw std::runtime_error(broken);
  return status;
}

int ElementFamily::find_water(netloft_flow_tile& tile) const {
  return call_plugin({type_->type.c_str(), "flow", nullptr, CallFrame::Kind::element}, int{NETLOFT_ERROR},
                     [&] { return type_->flow.evaluate(self_, &tile); });
}

const ElementFamily* ElementFamily::repeated() const {
  return changed_water_ ? &changed_water_->base() : nullptr;
}

const std::vector<std::unique_ptr<LawWatch>>& ElementFamily::law_watches() const {
  return changed_water_ ? changed_water_->base().law_watches() : watches_;
}

std::span<double> ElementFamily::table(std::uint32_t scene_part, std::string_view parameter) const {
  for (std::size_t p = 0; p < parts_.size(); ++p)
    for (const auto& one : type_->parameters)
      if (parts_[p] == scene_part && one.kind == NETLOFT_TABLE && parameter == one.name)
        return parameters_[p].table(one);
  return {};
}

void ElementFamily::add_corners_in_time(std::vector<double>& times) const {
  for (const auto& one : type_->parameters) {
    if (one.kind != NETLOFT_TABLE || std::string_view(one.column_units[0]) != "s") continue;
    std::size_t columns = 0;
    while (one.columns[columns]) ++columns;
    for (const auto& block : parameters_) {
      const auto numbers = block.table(one);
      for (std::size_t i = 0; i < numbers.size(); i += columns) times.push_back(numbers[i]);
    }
  }
}

void ElementFamily::gather_parameters(const Scene& scene) {
  std::vector<SceneFault> faults;
  for (const auto part : parts_) {
    std::vector<std::string> wrong;
    parameters_.emplace_back(type_->parameters, type_->element.parameter_bytes, scene.parts[part].parameters,
                             wrong);
    for (auto& w : wrong) faults.push_back({scene.parts[part].name, std::move(w)});
  }
  if (!faults.empty()) throw SceneError(std::move(faults));
}

void ElementFamily::gather_laws(const Scene& scene, const FamilyPlan& plan) {
  // Prevents reallocation, because law watches keep pointers to the entries.
  law_parameters_.reserve(plan.laws.size());
  for (const auto& law : plan.laws) {
    if (!law.type) {
      laws_.push_back({});  // in still water, no term reads a law
      continue;
    }
    std::vector<std::string> wrong;
    law_parameters_.emplace_back(law.type->parameters, law.type->law.parameter_bytes, law.choice.parameters,
                                 wrong);
    if (!wrong.empty()) throw SceneError({{scene.parts[parts_[0]].name, law.slot + ": " + wrong[0]}});
    watches_.push_back(std::make_unique<LawWatch>(*law.type, law_parameters_.back()));
    laws_.push_back(watches_.back()->bound());
  }
}

void ElementFamily::gather_elements(const Scene& scene) {
  const auto width = static_cast<std::size_t>(type_->nodes());
  for (std::uint32_t p = 0; p < parts_.size(); ++p) {
    const auto& nodes = scene.parts[parts_[p]].nodes;
    part_begin_.push_back(part_.size());
    part_.insert(part_.end(), nodes.size() / width, p);
  }
  part_begin_.push_back(part_.size());
}

void ElementFamily::gather_nodes(const Scene& scene, std::uint32_t first_global_node) {
  const auto width = static_cast<std::size_t>(type_->nodes());
  for (std::uint32_t p = 0; p < parts_.size(); ++p) {
    const Part& part = scene.parts[parts_[p]];
    for (std::size_t i = 0; i < part.nodes.size(); ++i) {
      nodes_.push_back(part.nodes[i]);
      if (type_->is_on_body()) add_body_of(scene, part.nodes[i], part);
      if (!type_->globals.empty() && i % width == width - 1) nodes_.push_back(first_global_node + p);
    }
  }
}

/// Adds the rotation node of a body to the nodes of an element, after the origin of the body.
void ElementFamily::add_body_of(const Scene& scene, std::uint32_t origin, const Part& part) {
  const auto body = scene.body_at(origin);
  if (!body) throw SceneError({{part.name, type_->type + " needs a rigid body, but this part is not one"}});
  nodes_.push_back(rotation_node(scene, *body));
  arms_.push_back(scene.bodies[*body].arm());
}

std::vector<double> ElementFamily::gather_datum(const Scene& scene, const netloft_datum& datum) const {
  std::vector<double> all;
  for (std::uint32_t p = 0; p < parts_.size(); ++p) {
    const Part& part = scene.parts[parts_[p]];
    const auto given = part.data.find(datum.name);
    const std::size_t wanted = (part_begin_[p + 1] - part_begin_[p]) * datum.width;
    if (given == part.data.end())
      throw SceneError(
          {{part.name, type_->type + " needs \"" + datum.name + "\" (" + datum.doc +
                           ") for every element, and the geometry of this part does not give it; elements " +
                           "on this stencil can use " + names_of_data_on(type_->element.stencil)}});
    if (given->second.size() != wanted)
      throw SceneError(
          {{part.name, "\"" + std::string(datum.name) + "\" has " + std::to_string(given->second.size()) +
                           " numbers, but " + std::to_string(wanted) + " are expected"}});
    all.insert(all.end(), given->second.begin(), given->second.end());
  }
  return all;
}

void ElementFamily::create(const Scene& scene) {
  std::vector<std::vector<double>> data;
  std::vector<const double*> data_pointers;
  for (const auto& datum : type_->data) data.push_back(gather_datum(scene, datum));
  for (const auto& d : data) data_pointers.push_back(d.data());
  std::vector<const void*> blocks;
  for (const auto& block : parameters_) blocks.push_back(block.data());

  char message[512] = "";
  netloft_create in{};
  in.size = sizeof in;
  in.count = static_cast<std::uint32_t>(size());
  in.part_count = static_cast<std::uint32_t>(parts_.size());
  in.parameters = blocks.data();
  in.part = part_.data();
  in.data = data_pointers.data();
  in.message = message;
  in.message_size = sizeof message;
  global_starts_.assign(parts_.size() * type_->globals.size(), 0.0);
  CreationInputs inputs;
  inputs.laws.count = static_cast<std::uint32_t>(laws_.size());
  inputs.laws.laws = laws_.data();
  inputs.globals.start = global_starts_.data();
  inputs.hand_to(in);
  const int status = call_plugin({type_->type.c_str(), "create", nullptr, CallFrame::Kind::element},
                                 int{NETLOFT_ERROR}, [&] { return type_->element.create(&in, &self_); });
  if (status == NETLOFT_OK) return;
  self_ = nullptr;
  take_broken_rule(message);
  const std::size_t e = std::min<std::size_t>(in.at_fault, size() - 1);
  throw SceneError(
      {{scene.parts[part(e)].name,
        type_->type + " element " + std::to_string(e - part_begin_[part_[e]]) + " is refused: " + message}});
}

/// Makes one node for each part. The coordinates of the node are the unknowns that all elements of the part
/// share. Coordinates are held if there are fewer unknowns, if the parameter `needs` of the unknown is zero,
/// or if no term is active.
void ElementFamily::gather_globals(const Scene& scene, std::uint32_t first_node) {
  const auto& globals = type_->globals;
  for (std::uint32_t p = 0; p < parts_.size() && !globals.empty(); ++p) {
    GlobalNode shared{first_node + p, {}, kAllAxes};
    for (std::size_t k = 0; k < globals.size(); ++k) {
      shared.start[k] = global_starts_[p * globals.size() + k];
      if (!terms_.empty() && (!globals[k].needs || sets(scene.parts[parts_[p]], *type_, globals[k].needs)))
        shared.held = static_cast<std::uint8_t>(shared.held & ~(1 << k));
    }
    global_nodes_.push_back(shared);
  }
}

}  // namespace netloft
