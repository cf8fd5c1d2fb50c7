// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/conformance/test_laws.hpp"
#include "framework/parameters/parameter_values.hpp"
#include "framework/registry/element_data.hpp"

#include <stdexcept>

namespace netloft::conformance {

inline constexpr std::size_t kLanes = NETLOFT_LANES;

/// Place of a degree of freedom (or matrix entry) of a lane in a tile's array.
constexpr std::size_t at(std::size_t row, std::size_t lane) { return row * kLanes + lane; }

/// What a family is made from: parameters of each part, part and data of each element, kind of law in its
/// slots.
struct Sample {
  std::vector<Values> parameters;
  std::vector<std::uint32_t> part;
  std::vector<std::vector<double>> data;  // [datum] -> [element][width]
  std::uint32_t law_kind = 0;             // where a slot takes it; else the first kind that the slot takes
  std::vector<ByteRange> spoilt = {};     // bytes of the parameters that no row declares, overwritten
};

/// The world as up to 64 elements see it, arrays [dof][64] like those of a tile. Empty: null.
struct States {
  std::uint32_t first = 0, count = 0;
  std::vector<double> x, v, a, current, current_dz;
  std::vector<double> memory = {};  // [state_width][64], what elements remember; empty: nothing yet
  std::vector<double> x_low = {};   // digits that x has no room for; empty: not known
  std::vector<double> ground = {};  // [3] velocity of the ground, one for all lanes; empty: it stands
  std::vector<double> bed = {};     // [6 nodes][64] the bed below the nodes of the stencil; empty: none
  std::vector<double> swing = {};   // [dof][64] acceleration of the water; empty: it has none
};

/// The fields of States that have lanes, for loops.
inline constexpr std::vector<double> States::*kFields[] = {
    &States::x,      &States::v,     &States::a,   &States::current, &States::current_dz,
    &States::memory, &States::x_low, &States::bed, &States::swing};

struct Factors {
  double cu = 1, cv = 0, ca = 0;
};

/// What a term said of a tile. Arrays that were not asked for are empty.
struct Answer {
  int status = NETLOFT_OK;
  std::string message;
  std::uint32_t lane_at_fault = 0;
  std::vector<double> energy, force, matrix;
  std::vector<double> memory;  // [state_width][64] of a term that remembers
  bool ok() const { return status == NETLOFT_OK; }
};

/// Status of a call that an exception came out of.
inline constexpr int kThrew = -1000;

struct Refused : std::runtime_error {
  Refused(std::uint32_t refused, const std::string& why) : std::runtime_error(why), element(refused) {}
  std::uint32_t element;
};
struct Escaped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A family of sampled elements, made by its plugin.
class Specimen {
 public:
  /// Throws Refused when the plugin refuses an element, Escaped when an exception comes out of it.
  Specimen(const ElementType& type, const Sample& sample);
  ~Specimen();
  Specimen(const Specimen&) = delete;
  Specimen& operator=(const Specimen&) = delete;

  /// Adds to zeros.
  Answer evaluate(const netloft_term& term, const States& states, std::uint32_t want,
                  Factors factors = {}) const;
  /// Adds to what is in `answer`, whose arrays must be large enough for what is wanted.
  void evaluate(const netloft_term& term, const States& states, std::uint32_t want, Factors factors,
                Answer& answer) const;
  /// The plain call: adds to arrays of the caller, of which those not wanted are passed as null.
  Answer evaluate_into(const netloft_term& term, const States& states, std::uint32_t want, Factors factors,
                       double* energy, double* force, double* matrix, double* memory) const;
  /// The element's outputs, [output][64], added to nothing: they are written.
  Answer outputs(const States& states, std::vector<double>& values) const;

  /// Members of elements first … first + count - 1 at the time of the tiles; empty: the plugin failed.
  std::vector<netloft_member> members(std::uint32_t first, std::uint32_t count) const;

  std::size_t entries(const netloft_term& term) const;
  /// What laws were asked so far.
  const AskedLanes& asked() const { return asked_; }
  /// Numbers that a term remembers of each element.
  std::size_t remembered(const netloft_term& term) const;

 private:
  netloft_tile tile(const States& states, Factors factors) const;

  const ElementType& type_;
  std::vector<ParameterBlock> parameters_;
  AskedLanes asked_;
  std::vector<netloft_bound_law> laws_;
  std::vector<double> forgotten_;  // zeros: the memory of new elements
  void* self_ = nullptr;
};

/// The bed of a lane below where its nodes are after a move by dx: a paraboloid stays the same one.
void move_bed(States& states, std::size_t node, std::size_t lane, double dx, double dy);
/// The beds of all nodes higher by dz.
void lift_bed(States& states, double dz);
/// The beds of all nodes and the velocity of the ground, turned about z; or reflected at y = 0.
void turn_ground(States& states, double angle);
void reflect_ground(States& states);

bool wants_matrix(std::uint32_t want);
/// "energy + force + tangent"
std::string want_text(std::uint32_t want);
/// All combinations that the host asks of a term.
std::vector<std::uint32_t> wants_of(const netloft_term& term);

}  // namespace netloft::conformance
