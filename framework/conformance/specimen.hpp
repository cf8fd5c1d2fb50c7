// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/conformance/test_laws.hpp"
#include "framework/parameters/parameter_values.hpp"
#include "framework/registry/element_data.hpp"

#include <stdexcept>

namespace netloft::conformance {

inline constexpr std::size_t kLanes = NETLOFT_LANES;

/// Index of a degree of freedom (or matrix entry) of element `lane` in the array of a tile.
constexpr std::size_t at(std::size_t row, std::size_t lane) { return row * kLanes + lane; }

/// Sampled elements: parameters of each part, part and data of each element, kind of the laws that the
/// elements use.
struct Sample {
  std::vector<Values> parameters;
  std::vector<std::uint32_t> part;
  std::vector<std::vector<double>> data;  // [datum] -> [element][width]
  // Kind of law in all slots that accept this kind; any other slot gets the first kind that it accepts.
  std::uint32_t law_kind = 0;
  // Bytes of the parameters to be overwritten; no row of the table declares them.
  std::vector<ByteRange> spoilt = {};
};

/// The states of up to 64 elements, in arrays [dof][64] like those of a tile. Empty arrays are passed as
/// nullptr.
struct States {
  std::uint32_t first = 0, count = 0;
  std::vector<double> x, v, a, current, current_dz;
  std::vector<double> memory = {};   // [state_width][64] memory of the elements; empty: none
  std::vector<double> x_low = {};    // digits that rounding removes from x; empty: unknown
  std::vector<double> ground = {};   // [3] velocity of the ground, one for all elements; empty: at rest
  std::vector<double> bed = {};      // [6 nodes][64] the bed below the nodes of the stencil; empty: none
  std::vector<double> swing = {};    // [dof][64] acceleration of the water; empty: none
  std::vector<double> surface = {};  // [nodes][64] height of the surface of the water; empty: z = 0
  double time = 1;                   // [s]
  std::uint32_t exposed = 0;         // traits whose inputs every term receives, also without the trait
};

/// The arrays of States that have rows of one number per element.
inline constexpr std::vector<double> States::*kFields[] = {
    &States::x,      &States::v,     &States::a,   &States::current, &States::current_dz,
    &States::memory, &States::x_low, &States::bed, &States::swing,   &States::surface};

struct Factors {
  double cu = 1, cv = 0, ca = 0;
};

/// The answer of a term for a tile. Arrays of outputs that were not requested are empty.
struct Answer {
  int status = NETLOFT_OK;
  std::string message;
  std::uint32_t lane_at_fault = 0;
  std::vector<double> energy, force, matrix;
  std::vector<double> memory;  // [state_width][64], of a term with memory
  bool ok() const { return status == NETLOFT_OK; }
};

/// Status of a call that broke a rule of the plugin interface (plugin_call.hpp), for instance by an
/// exception.
inline constexpr int kThrew = -1000;

struct Refused : std::runtime_error {
  Refused(std::uint32_t refused, const std::string& why) : std::runtime_error(why), element(refused) {}
  std::uint32_t element;
};
struct Escaped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Specimen {
 public:
  /// Throws Refused if the plugin refuses an element, Escaped if it breaks a rule of the plugin interface.
  Specimen(const ElementType& type, const Sample& sample);
  ~Specimen();
  Specimen(const Specimen&) = delete;
  Specimen& operator=(const Specimen&) = delete;

  /// Evaluates a term into new arrays.
  Answer evaluate(const netloft_term& term, const States& states, std::uint32_t want,
                  Factors factors = {}) const;
  /// Evaluates a term, which adds to the arrays of `answer`; these must be large enough.
  void evaluate(const netloft_term& term, const States& states, std::uint32_t want, Factors factors,
                Answer& answer) const;
  /// Evaluates a term, which adds to arrays of the caller; unused arrays are nullptr.
  Answer evaluate_into(const netloft_term& term, const States& states, std::uint32_t want, Factors factors,
                       double* energy, double* force, double* matrix, double* memory) const;
  /// Evaluates the outputs of the elements, [output][64]. They replace the previous numbers.
  Answer outputs(const States& states, std::vector<double>& values) const;

  /// Computes the velocity of the water. The elements must be a flow. Returns kThrew if the plugin broke a
  /// rule of the plugin interface.
  int find_water(netloft_flow_tile& tile) const;

  /// Members of elements first … first + count − 1 at the time of the tiles; empty if the plugin failed.
  std::vector<netloft_member> members(std::uint32_t first, std::uint32_t count) const;

  std::size_t entries(const netloft_term& term) const;
  /// Counts the lanes for which the elements called their laws.
  const LaneCounts& law_lanes() const { return law_lanes_; }
  /// Size of the memory of a term, in numbers per element.
  std::size_t remembered(const netloft_term& term) const;

 private:
  netloft_tile tile(const States& states, Factors factors) const;
  ExtensionInputs inputs(const States& states) const;

  const ElementType& type_;
  std::vector<ParameterBlock> parameters_;
  LaneCounts law_lanes_;
  std::vector<netloft_bound_law> laws_;
  std::vector<double> forgotten_;  // zeros: the memory of elements before their first step
  void* self_ = nullptr;
};

/// Moves a node over its bed, which is a paraboloid, by (dx, dy).
void move_bed(States& states, std::size_t node, std::size_t lane, double dx, double dy);
/// Raises the beds of all nodes by dz.
void lift_bed(States& states, double dz);
/// Rotates the beds of all nodes and the velocity of the ground about z, or reflects them at y = 0.
void turn_ground(States& states, double angle);
void reflect_ground(States& states);

bool wants_matrix(std::uint32_t want);
/// The results that `want` requests from a term, in words: "energy + force + tangent".
std::string want_text(std::uint32_t want);
/// All combinations of outputs that the host requests from a term.
std::vector<std::uint32_t> wants_of(const netloft_term& term);

}  // namespace netloft::conformance
