// SPDX-License-Identifier: BSD-3-Clause
#include "framework/conformance/specimen.hpp"

#include "framework/conformance/test_laws.hpp"
#include "framework/registry/plugin_call.hpp"

#include <cmath>

namespace netloft::conformance {

namespace {

constexpr std::uint32_t kMessage = 256;
constexpr double kTime = 1;  // time at which members are evaluated [s]

/// Calls a function of the plugin. If it breaks a rule of the plugin interface, the status is kThrew.
template <class Call>
int guarded(const ElementType& type, const char* function, const char* term, std::string& message,
            Call&& call) {
  const int status = call_plugin({type.type.c_str(), function, term, CallFrame::Kind::element}, kThrew, call);
  std::string broken = take_broken_rule();
  if (broken.empty()) return status;
  message = std::move(broken);
  return kThrew;
}

const double* pointer(const std::vector<double>& v) { return v.empty() ? nullptr : v.data(); }

/// Removes those inputs for which the term has no trait.
void hide_undeclared(std::uint32_t traits, netloft_tile& t, ExtensionInputs& inputs) {
  if (!(traits & NETLOFT_READS_VELOCITY)) t.v = nullptr;
  if (!(traits & NETLOFT_READS_ACCELERATION)) t.a = nullptr;
  if (!(traits & NETLOFT_READS_CURRENT)) t.current = t.current_dz = nullptr;
  if (!(traits & NETLOFT_READS_STATE)) inputs.memory.state = nullptr;
  if (!(traits & NETLOFT_READS_GROUND)) inputs.ground.velocity = nullptr;
  if (!(traits & NETLOFT_READS_BED)) inputs.ground.bed = nullptr;
  if (!(traits & NETLOFT_READS_WAVES)) inputs.waves.acceleration = inputs.waves.surface = nullptr;
}

std::uint32_t kind_for(const netloft_law_slot& slot, std::uint32_t wanted) {
  if (slot.accepts & wanted) return wanted;
  return slot.accepts & NETLOFT_TWINE_LAW ? NETLOFT_TWINE_LAW : NETLOFT_SCREEN_LAW;
}

}  // namespace

Specimen::Specimen(const ElementType& type, const Sample& sample)
    : type_(type), forgotten_(type.state_width * kLanes, 0.0) {
  for (const auto& slot : type.laws) laws_.push_back(test_law(kind_for(slot, sample.law_kind), &law_lanes_));
  std::vector<std::string> faults;
  std::vector<const void*> blocks;
  std::vector<const double*> data;
  for (const auto& values : sample.parameters)
    parameters_.emplace_back(type.parameters, type.element.parameter_bytes, values, faults);
  if (!faults.empty()) throw Refused(0, faults.front());
  for (auto& block : parameters_) {
    for (const auto& range : sample.spoilt) block.spoil(range);
    blocks.push_back(block.data());
  }
  for (const auto& datum : sample.data) data.push_back(datum.data());

  char message[kMessage] = "";
  std::string thrown;
  netloft_create in{};
  in.size = sizeof in;
  in.count = static_cast<std::uint32_t>(sample.part.size());
  in.part_count = static_cast<std::uint32_t>(blocks.size());
  in.parameters = blocks.data();
  in.part = sample.part.data();
  in.data = data.data();
  in.message = message;
  in.message_size = kMessage;
  std::vector<double> globals(blocks.size() * type.globals.size());
  CreationInputs inputs;
  inputs.laws.count = static_cast<std::uint32_t>(laws_.size());
  inputs.laws.laws = laws_.data();
  inputs.globals.start = globals.data();
  inputs.hand_to(in);
  const int status =
      guarded(type, "create", nullptr, thrown, [&] { return type.element.create(&in, &self_); });
  if (status == kThrew) throw Escaped(thrown);
  if (status != NETLOFT_OK) throw Refused(std::min(in.at_fault, in.count - 1), message);
}

Specimen::~Specimen() {
  std::string unheard;
  if (!self_) return;
  guarded(type_, "destroy", nullptr, unheard, [&] {
    type_.element.destroy(self_);
    return 0;
  });
}

std::size_t Specimen::entries(const netloft_term& term) const {
  const auto n = static_cast<std::size_t>(type_.dofs());
  return term.traits & NETLOFT_SYMMETRIC ? n * (n + 1) / 2 : n * n;
}

std::size_t Specimen::remembered(const netloft_term& term) const {
  return term.traits & NETLOFT_READS_STATE ? type_.state_width : 0;
}

netloft_tile Specimen::tile(const States& states, Factors factors) const {
  netloft_tile t{};
  t.size = sizeof t;
  t.first = states.first;
  t.count = states.count;
  t.time = states.time;
  t.cu = factors.cu;
  t.cv = factors.cv;
  t.ca = factors.ca;
  t.water_density = 1025;
  t.gravity = 9.81;
  t.water_viscosity = 1.19e-6;
  t.x = pointer(states.x);
  t.v = pointer(states.v);
  t.a = pointer(states.a);
  t.x_low = pointer(states.x_low);
  t.current = pointer(states.current);
  t.current_dz = pointer(states.current_dz);
  return t;
}

ExtensionInputs Specimen::inputs(const States& states) const {
  ExtensionInputs inputs;
  inputs.ground.velocity = pointer(states.ground);
  inputs.ground.bed = pointer(states.bed);
  inputs.waves.acceleration = pointer(states.swing);
  inputs.waves.surface = pointer(states.surface);
  inputs.memory.state = states.memory.empty() ? pointer(forgotten_) : states.memory.data();
  return inputs;
}

Answer Specimen::evaluate(const netloft_term& term, const States& states, std::uint32_t want,
                          Factors factors) const {
  Answer answer;
  if (want & NETLOFT_WANT_ENERGY) answer.energy.assign(kLanes, 0.0);
  if (want & NETLOFT_WANT_FORCE) answer.force.assign(static_cast<std::size_t>(type_.dofs()) * kLanes, 0.0);
  if (wants_matrix(want)) answer.matrix.assign(entries(term) * kLanes, 0.0);
  answer.memory.assign(remembered(term) * kLanes, 0.0);
  evaluate(term, states, want, factors, answer);
  return answer;
}

void Specimen::evaluate(const netloft_term& term, const States& states, std::uint32_t want, Factors factors,
                        Answer& answer) const {
  Answer told = evaluate_into(term, states, want, factors, answer.energy.data(), answer.force.data(),
                              answer.matrix.data(), answer.memory.data());
  answer.status = told.status;
  answer.lane_at_fault = told.lane_at_fault;
  answer.message = std::move(told.message);
}

Answer Specimen::evaluate_into(const netloft_term& term, const States& states, std::uint32_t want,
                               Factors factors, double* energy, double* force, double* matrix,
                               double* memory) const {
  Answer answer;
  char message[kMessage] = "";
  netloft_tile t = tile(states, factors);
  t.want = want;
  ExtensionInputs given = inputs(states);
  hide_undeclared(term.traits | states.exposed, t, given);
  if (term.traits & NETLOFT_READS_GROUND && given.ground.velocity && !states.exposed)
    given.memory.state = nullptr;
  given.memory.state_new = remembered(term) ? memory : nullptr;
  given.hand_to(t, type_.inputs);
  t.energy = want & NETLOFT_WANT_ENERGY ? energy : nullptr;
  t.force = want & NETLOFT_WANT_FORCE ? force : nullptr;
  t.tangent = wants_matrix(want) ? matrix : nullptr;
  t.message = message;
  t.message_size = kMessage;
  answer.status = guarded(type_, "term", term.name, answer.message, [&] { return term.evaluate(self_, &t); });
  if (answer.status != kThrew) answer.message = message;
  answer.lane_at_fault = t.lane_at_fault;
  return answer;
}

int Specimen::find_water(netloft_flow_tile& tile) const {
  std::string unheard;
  return guarded(type_, "flow", nullptr, unheard, [&] { return type_.flow.evaluate(self_, &tile); });
}

Answer Specimen::outputs(const States& states, std::vector<double>& values) const {
  Answer answer;
  char message[kMessage] = "";
  netloft_tile t = tile(states, {});
  ExtensionInputs given = inputs(states);
  given.hand_to(t, type_.inputs);
  t.message = message;
  t.message_size = kMessage;
  answer.status = guarded(type_, "outputs", nullptr, answer.message,
                          [&] { return type_.element.output(self_, &t, values.data()); });
  if (answer.status != kThrew) answer.message = message;
  return answer;
}

std::vector<netloft_member> Specimen::members(std::uint32_t first, std::uint32_t count) const {
  std::vector<netloft_member> members(std::size_t{count} * type_.members.count);
  std::string thrown;
  const int status = guarded(type_, "members", nullptr, thrown,
                             [&] { return type_.members.write(self_, kTime, first, count, members.data()); });
  return status == NETLOFT_OK ? members : std::vector<netloft_member>{};
}

void move_bed(States& s, std::size_t node, std::size_t lane, double dx, double dy) {
  if (s.bed.empty()) return;
  const auto b = [&](std::size_t k) -> double& { return s.bed[at(6 * node + k, lane)]; };
  b(0) += b(1) * dx + b(2) * dy + 0.5 * b(3) * dx * dx + b(4) * dx * dy + 0.5 * b(5) * dy * dy;
  b(1) += b(3) * dx + b(4) * dy;
  b(2) += b(4) * dx + b(5) * dy;
}

void lift_bed(States& s, double dz) {
  for (std::size_t row = 0; (row + 6) * kLanes <= s.bed.size(); row += 6)
    for (std::size_t lane = 0; lane < kLanes; ++lane) s.bed[at(row, lane)] += dz;
}

void turn_ground(States& s, double angle) {
  const double c = std::cos(angle), sine = std::sin(angle);
  const auto turn = [&](double& x, double& y) {
    const double before = x;
    x = c * before - sine * y;
    y = sine * before + c * y;
  };
  if (!s.ground.empty()) turn(s.ground[0], s.ground[1]);
  for (std::size_t row = 0; (row + 6) * kLanes <= s.bed.size(); row += 6)
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const auto b = [&](std::size_t k) -> double& { return s.bed[at(row + k, lane)]; };
      turn(b(1), b(2));
      double yx = b(4);  // rotates the second derivatives H to R H Rᵀ: first the columns, then the rows
      turn(b(3), yx);
      turn(b(4), b(5));
      turn(b(3), b(4));
      turn(yx, b(5));
    }
}

void reflect_ground(States& s) {
  if (!s.ground.empty()) s.ground[1] = -s.ground[1];
  for (std::size_t row = 0; (row + 6) * kLanes <= s.bed.size(); row += 6)
    for (std::size_t lane = 0; lane < kLanes; ++lane)
      for (const std::size_t k : {2, 4}) s.bed[at(row + k, lane)] *= -1;
}

bool wants_matrix(std::uint32_t want) {
  return want & (NETLOFT_WANT_TANGENT | NETLOFT_WANT_CONVEX | NETLOFT_WANT_METRIC);
}

std::string want_text(std::uint32_t want) {
  constexpr const char* names[] = {"energy", "force", "tangent", "convex part", "metric"};
  std::string text;
  for (std::uint32_t i = 0; i < 5; ++i)
    if (want & (1u << i)) text += (text.empty() ? "" : " + ") + std::string(names[i]);
  return text;
}

std::vector<std::uint32_t> wants_of(const netloft_term& term) {
  std::vector<std::uint32_t> wants = {NETLOFT_WANT_FORCE};
  const auto energy = term.traits & NETLOFT_CONSERVATIVE ? std::uint32_t{NETLOFT_WANT_ENERGY} : 0u;
  if (energy) wants.insert(wants.end(), {energy, energy | NETLOFT_WANT_FORCE});
  if (term.traits & NETLOFT_CONSTANT) return wants;
  wants.push_back(NETLOFT_WANT_TANGENT);
  wants.push_back(energy | NETLOFT_WANT_FORCE | NETLOFT_WANT_TANGENT);
  if (term.traits & NETLOFT_HAS_CONVEX) wants.push_back(NETLOFT_WANT_CONVEX);
  if (term.traits & NETLOFT_HAS_METRIC) wants.push_back(NETLOFT_WANT_METRIC);
  return wants;
}

}  // namespace netloft::conformance
