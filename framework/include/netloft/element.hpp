// SPDX-License-Identifier: BSD-3-Clause
//
// What the author of an element includes. An element is a struct that says what it stands on (`stencil`), its
// `Parameters` (set by users, one per part of a gear), its `Data` (one per element) and its terms. A term is
// a struct with one of three functions, from the quickest to write to the fastest to run:
//
//   template <class T> static T energy(const Parameters&, const Data&, const Water&, const Points<T, N>& x);
//   static Status evaluate(const Parameters&, const Data&, const State<N>&, Local<N>&);
//   static Status tile(const Family<Element>&, netloft_tile&);
//
// `energy` gives force and tangent by differentiation; `evaluate` fills one element; `tile` loops over 64.
// An element that must know all of its part declares `Whole`, which `gather(parameters, data, whole)` makes
// of every element of the part in turn; `evaluate` is handed it after the data. One whose part shares numbers
// that are solved for, too (the front of a catch), says how many: `static constexpr int globals = 1`. They
// are coordinates of one more node, the last: N is one more.
#pragma once
#include <netloft/plugin.h>
#include <netloft/dual.hpp>
#include <netloft/parameters.hpp>
#include <netloft/vec3.hpp>

#include <cstdio>
#include <cstring>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace netloft {

inline constexpr int kLanes = NETLOFT_LANES;

enum class Status { ok = NETLOFT_OK, outside_domain = NETLOFT_OUTSIDE_DOMAIN };

/// Thrown where a state has no force (a bar of no length): the solver shortens its step.
struct OutsideDomain : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct Water {
  double density;        // [kg/m3]
  double gravity;        // [m/s2]
  double viscosity = 0;  // kinematic [m2/s]
};

/// One element's view of the world in `evaluate`. Arrays the term did not ask for are zero.
template <int Nodes>
struct State {
  Points<double, Nodes> x{}, v{}, a{}, current{}, current_dz{};
  Water water{};
  double time = 0;
  double cu = 1, cv = 0, ca = 0;  // factors of dforce/dx, dforce/dv, dforce/da in the tangent
  bool wants_tangent = false;
};

/// What `evaluate` fills: energy [J], force = +dE/dx [N], tangent = dforce/dx [N/m]. All zero to begin with.
template <int Nodes>
struct Local {
  static constexpr int dofs = 3 * Nodes;
  double energy = 0;
  Points<double, Nodes> force{};
  double tangent[dofs][dofs] = {};
};

/// All elements of one type in a scene. Elements of several parts stand side by side.
template <class E>
class Family {
 public:
  using Parameters = typename E::Parameters;
  using Data = typename E::Data;

  const Parameters& parameters(std::size_t element) const { return *parameters_[part_[element]]; }
  const Data& data(std::size_t element) const { return data_[element]; }
  const auto& whole(std::size_t element) const { return wholes_[part_[element]]; }
  /// What E::pack made of 64 elements, for terms written as `tile`.
  const auto& lanes(const netloft_tile& tile) const { return lanes_[tile.first / NETLOFT_LANES]; }
  std::size_t size() const { return data_.size(); }

  struct None {};
  template <class F, class = void>
  struct LanesOf {
    using type = None;
  };
  template <class F>
  struct LanesOf<F, std::void_t<typename F::Lanes>> {
    using type = typename F::Lanes;
  };
  using Lanes = typename LanesOf<E>::type;
  template <class F, class = void>
  struct WholeOf {
    using type = None;
  };
  template <class F>
  struct WholeOf<F, std::void_t<typename F::Whole>> {
    using type = typename F::Whole;
  };
  using Whole = typename WholeOf<E>::type;

  /// The law in a slot, in the order the slots were declared. Its arrays are those of netloft_flow.
  const netloft_bound_law& law(std::size_t slot) const { return laws_[slot]; }

  std::vector<const Parameters*> parameters_;
  std::vector<netloft_bound_law> laws_;
  std::vector<std::uint32_t> part_;
  std::vector<Data> data_;
  std::vector<Lanes> lanes_;
  std::vector<Whole> wholes_;  // per part
};

namespace detail {

template <class E>
consteval int count_globals() {
  if constexpr (requires { E::globals; }) return E::globals;
  return 0;
}
/// Those of the stencil, and one for what a part shares.
template <class E>
inline constexpr int nodes_of = (E::stencil & 0xff) + (count_globals<E>() > 0);

template <class E, class T>
concept HasTile = requires(const Family<E>& f, netloft_tile& t) {
  T::tile(f, t);
};
template <class E, class T>
concept HasEvaluate = requires(const typename E::Parameters& p, const typename E::Data& d,
                               const State<nodes_of<E>>& s, Local<nodes_of<E>>& l) {
  T::evaluate(p, d, s, l);
};
template <class E, class T>
concept HasEvaluateWithWhole = requires(const typename E::Parameters& p, const typename E::Data& d,
                                        const typename Family<E>::Whole& w, const State<nodes_of<E>>& s,
                                        Local<nodes_of<E>>& l) {
  T::evaluate(p, d, w, s, l);
};
template <class E, class T>
concept HasEnergy = requires(const typename E::Parameters& p, const typename E::Data& d, const Water& w,
                             const Points<Dual<3 * nodes_of<E>>, nodes_of<E>>& x) {
  T::energy(p, d, w, x);
};

inline int say(char* message, std::uint32_t size, const char* text, int status) {
  if (message && size) std::snprintf(message, size, "%s", text);
  return status;
}

/// Runs `body`; no exception leaves the plugin.
template <class F>
int guarded(char* message, std::uint32_t size, F&& body) noexcept {
  try {
    return body();
  } catch (const OutsideDomain& e) {
    return say(message, size, e.what(), NETLOFT_OUTSIDE_DOMAIN);
  } catch (const std::exception& e) {
    return say(message, size, e.what(), NETLOFT_ERROR);
  } catch (...) {
    return say(message, size, "an exception that is no std::exception", NETLOFT_ERROR);
  }
}

template <int Nodes>
void gather(const double* from, std::size_t lane, Points<double, Nodes>& to) {
  if (!from) return;
  for (int n = 0; n < Nodes; ++n)
    for (int axis = 0; axis < 3; ++axis)
      to[static_cast<std::size_t>(n)][axis] = from[static_cast<std::size_t>(3 * n + axis) * kLanes + lane];
}

template <int Nodes>
State<Nodes> gather(const netloft_tile& t, std::size_t lane) {
  State<Nodes> s;
  gather<Nodes>(t.x, lane, s.x);
  gather<Nodes>(t.v, lane, s.v);
  gather<Nodes>(t.a, lane, s.a);
  gather<Nodes>(t.current, lane, s.current);
  gather<Nodes>(t.current_dz, lane, s.current_dz);
  s.water = {t.water_density, t.gravity, t.water_viscosity};
  s.time = t.time, s.cu = t.cu, s.cv = t.cv, s.ca = t.ca;
  s.wants_tangent = t.want & (NETLOFT_WANT_TANGENT | NETLOFT_WANT_CONVEX | NETLOFT_WANT_METRIC);
  return s;
}

template <int Nodes>
void scatter(const Local<Nodes>& local, bool symmetric, std::size_t lane, netloft_tile& t) {
  constexpr int dofs = 3 * Nodes;
  if (t.energy) t.energy[lane] += local.energy;
  if (t.force)
    for (int i = 0; i < dofs; ++i)
      t.force[static_cast<std::size_t>(i) * kLanes + lane] +=
          local.force[static_cast<std::size_t>(i / 3)][i % 3];
  if (!t.tangent) return;
  std::size_t entry = 0;
  for (int r = 0; r < dofs; ++r)
    for (int c = 0; c < (symmetric ? r + 1 : dofs); ++c)
      t.tangent[kLanes * entry++ + lane] += local.tangent[r][c];
}

/// Force and tangent of an energy, by second-order forward differentiation.
template <class E, class T>
void differentiate(const Family<E>& f, std::size_t element, const netloft_tile& t, std::size_t lane,
                   Local<nodes_of<E>>& local) {
  constexpr int N = nodes_of<E>;
  const Water water{t.water_density, t.gravity, t.water_viscosity};
  Points<Dual<3 * N>, N> x;
  for (int i = 0; i < 3 * N; ++i)
    x[static_cast<std::size_t>(i / 3)][i % 3] =
        Dual<3 * N>::variable(t.x[static_cast<std::size_t>(i) * kLanes + lane], i);
  const Dual<3 * N> e = T::energy(f.parameters(element), f.data(element), water, x);
  local.energy = e.value;
  std::size_t k = 0;
  for (int r = 0; r < 3 * N; ++r) {
    local.force[static_cast<std::size_t>(r / 3)][r % 3] = e.gradient[static_cast<std::size_t>(r)];
    for (int c = 0; c <= r; ++c, ++k) local.tangent[r][c] = local.tangent[c][r] = t.cu * e.hessian[k];
  }
}

template <class E, class T>
Status evaluate_one(const Family<E>& f, const netloft_tile& t, std::size_t lane, Local<nodes_of<E>>& local) {
  const std::size_t element = t.first + lane;
  if constexpr (HasEvaluateWithWhole<E, T>) {
    return T::evaluate(f.parameters(element), f.data(element), f.whole(element), gather<nodes_of<E>>(t, lane),
                       local);
  } else if constexpr (HasEvaluate<E, T>) {
    return T::evaluate(f.parameters(element), f.data(element), gather<nodes_of<E>>(t, lane), local);
  } else {
    differentiate<E, T>(f, element, t, lane, local);
    return Status::ok;
  }
}

template <class E, class T, bool Symmetric>
int evaluate_term(const void* self, netloft_tile* t) {
  static_assert(
      HasTile<E, T> || HasEvaluate<E, T> || HasEvaluateWithWhole<E, T> || HasEnergy<E, T>,
      "A term needs one of these static functions: `T energy(const Parameters&, const Data&, const "
      "Water&, const Points<T, N>&)` (a template over T), `Status evaluate(const Parameters&, const "
      "Data&, const State<N>&, Local<N>&)`, or `Status tile(const Family<Element>&, netloft_tile&)`.");
  const auto& family = *static_cast<const Family<E>*>(self);
  return guarded(t->message, t->message_size, [&]() -> int {
    if constexpr (HasTile<E, T>) {
      return static_cast<int>(T::tile(family, *t));
    } else {
      for (std::uint32_t lane = 0; lane < t->count; ++lane) {
        Local<nodes_of<E>> local;
        t->lane_at_fault = lane;
        const Status status = evaluate_one<E, T>(family, *t, lane, local);
        if (status != Status::ok) return static_cast<int>(status);
        scatter(local, Symmetric, lane, *t);
      }
      return NETLOFT_OK;
    }
  });
}

template <class E>
void fill_family(Family<E>& f, netloft_create& in, const std::vector<std::size_t>& offsets,
                 const std::vector<netloft_datum>& data) {
  using P = typename E::Parameters;
  for (std::uint32_t p = 0; p < in.part_count; ++p)
    f.parameters_.push_back(static_cast<const P*>(in.parameters[p]));
  f.part_.assign(in.part, in.part + in.count);
  if (in.laws) f.laws_.assign(in.laws, in.laws + in.law_count);
  f.wholes_.resize(in.part_count);
  f.data_.resize(in.count);
  if constexpr (requires { typename E::Lanes; }) f.lanes_.resize((in.count + kLanes - 1) / kLanes);
  for (std::uint32_t e = 0; e < in.count; ++e) {
    in.at_fault = e;
    for (std::size_t k = 0; k < data.size(); ++k)
      std::memcpy(reinterpret_cast<char*>(&f.data_[e]) + offsets[k],
                  in.data[k] + std::size_t{e} * data[k].width, data[k].width * sizeof(double));
    if constexpr (requires { E::check(f.parameters(e), f.data_[e]); }) E::check(f.parameters(e), f.data_[e]);
    if constexpr (requires { typename E::Lanes; })
      E::pack(f.parameters(e), f.data_[e], f.lanes_[e / kLanes], e % kLanes);
    if constexpr (requires { typename E::Whole; })
      E::gather(f.parameters(e), f.data_[e], f.wholes_[f.part_[e]]);
  }
}

}  // namespace detail

/// Traits of a term, to be joined with `|`.
enum Trait : std::uint32_t {
  conservative = NETLOFT_CONSERVATIVE,
  symmetric = NETLOFT_SYMMETRIC,
  constant = NETLOFT_CONSTANT,
  reads_velocity = NETLOFT_READS_VELOCITY,
  reads_acceleration = NETLOFT_READS_ACCELERATION,
  reads_current = NETLOFT_READS_CURRENT,
  needs_gravity = NETLOFT_NEEDS_GRAVITY,
  needs_flow = NETLOFT_NEEDS_FLOW,
  needs_motion = NETLOFT_NEEDS_MOTION,
  reads_state = NETLOFT_READS_STATE,
  reads_time = NETLOFT_READS_TIME,
  has_convex = NETLOFT_HAS_CONVEX,
  has_metric = NETLOFT_HAS_METRIC,
  from_outside = NETLOFT_FROM_OUTSIDE,
};

/// Describes one element to the host: parameters, data, terms, outputs.
template <class E>
class ElementTable : public ParameterTable<typename E::Parameters> {
 public:
  using Parameters = typename E::Parameters;
  using Data = typename E::Data;
  using Output = double (*)(const Parameters&, const Data&, const State<detail::nodes_of<E>>&);
  using LanesOutput = void (*)(const Family<E>&, const netloft_tile&, double* values);
  using Start = double (*)(const Parameters&, const typename Family<E>::Whole&);
  static_assert(std::is_trivially_copyable_v<Data>, "Data must be plain numbers");

  ElementTable(const char* name, const char* doc) : name_(name), doc_(doc) {}

  /// A number of every element; the unit is part of the promise.
  void data(const char* name, double Data::*member, const char* unit, const char* doc) {
    add_datum(name, unit, doc, offset_of(member), 1);
  }
  template <std::size_t Width>
  void data(const char* name, std::array<double, Width> Data::*member, const char* unit, const char* doc) {
    add_datum(name, unit, doc, offset_of(member), Width);
  }

  /// A term. `needs` names parameters, a space between two, one of which must differ from zero for the term
  /// to act.
  template <class T, std::uint32_t Traits = 0>
  void term(const char* name, const char* doc, const char* needs = nullptr) {
    constexpr std::uint32_t traits =
        Traits | (detail::HasEnergy<E, T> && !detail::HasTile<E, T> && !detail::HasEvaluate<E, T>
                      ? std::uint32_t{NETLOFT_CONSERVATIVE | NETLOFT_SYMMETRIC}
                      : 0u);
    netloft_term t{};
    t.size = sizeof t, t.traits = traits, t.name = name, t.doc = doc, t.needs = needs;
    t.evaluate = &detail::evaluate_term<E, T, (traits & NETLOFT_SYMMETRIC) != 0>;
    terms_.push_back(t);
  }

  /// A number reported per element, in physical sign.
  void output(const char* name, const char* unit, const char* doc, Output function) {
    add_output(name, unit, doc, {function, nullptr});
  }
  /// The same for 64 elements at once, with the family at hand: what comes out of a law.
  void output_lanes(const char* name, const char* unit, const char* doc, LanesOutput function) {
    add_output(name, unit, doc, {nullptr, function});
  }

  /// A law that users choose by name under this key; `accepts` is a sum of netloft_law_kind.
  void law(const char* name, std::uint32_t accepts, const char* fallback, const char* doc) {
    netloft_law_slot l{};
    l.size = sizeof l, l.accepts = accepts, l.name = name, l.doc = doc, l.fallback = fallback;
    laws_.push_back(l);
  }
  /// This element is made wherever another one of the plugin is used, on pairs of it: bending on a rope's
  /// bars.
  void rides_on(const char* element) { rides_on_ = element; }
  /// A number that all elements of a part share: an unknown where the parameter `needs` differs from zero (or
  /// always, if there is none), else it stands where it starts. They are x, y, z of State::x's last node.
  void global(const char* name, const char* unit, const char* doc, const char* needs, Start start) {
    netloft_global g{};
    g.size = sizeof g, g.name = name, g.unit = unit, g.doc = doc, g.needs = needs;
    globals_.push_back(g);
    starts_.push_back(start);
  }
  /// Numbers that each element remembers from one accepted step to the next.
  void remembers(std::uint32_t width) { state_width_ = width; }

  netloft_element descriptor() const {
    netloft_element e{};
    e.size = sizeof e, e.stencil = E::stencil, e.name = name_, e.doc = doc_;
    e.parameter_bytes = sizeof(Parameters);
    e.parameter_count = static_cast<std::uint32_t>(this->rows().size()), e.parameters = this->rows().data();
    e.datum_count = static_cast<std::uint32_t>(data_.size()), e.data = data_.data();
    e.term_count = static_cast<std::uint32_t>(terms_.size()), e.terms = terms_.data();
    e.output_count = static_cast<std::uint32_t>(outputs_.size()), e.outputs = outputs_.data();
    e.laws = laws_.data(), e.law_count = static_cast<std::uint32_t>(laws_.size());
    e.rides_on = rides_on_, e.state_width = state_width_;
    e.globals = globals_.data(), e.global_count = static_cast<std::uint32_t>(globals_.size());
    e.create = &create, e.destroy = &destroy, e.output = &evaluate_outputs;
    return e;
  }

 private:
  template <class M>
  static std::size_t offset_of(M Data::*member) {
    static const Data object{};
    return static_cast<std::size_t>(reinterpret_cast<const char*>(&(object.*member)) -
                                    reinterpret_cast<const char*>(&object));
  }
  /// One of both.
  struct OutputFunction {
    Output one;
    LanesOutput lanes;
  };
  void add_output(const char* name, const char* unit, const char* doc, OutputFunction function) {
    netloft_output o{};
    o.size = sizeof o, o.name = name, o.unit = unit, o.doc = doc;
    outputs_.push_back(o);
    functions_.push_back(function);
  }
  void add_datum(const char* name, const char* unit, const char* doc, std::size_t offset, std::size_t width) {
    netloft_datum d{};
    d.size = sizeof d, d.width = static_cast<std::uint32_t>(width), d.name = name, d.unit = unit, d.doc = doc;
    data_.push_back(d);
    offsets_.push_back(offset);
  }
  static int create(netloft_create* in, void** self) {
    return detail::guarded(in->message, in->message_size, [&] {
      auto family = std::make_unique<Family<E>>();
      detail::fill_family(*family, *in, offsets_, data_);
      place_globals(*family, *in);
      *self = family.release();
      return NETLOFT_OK;
    });
  }
  static void place_globals(const Family<E>& f, netloft_create& in) {
    if (starts_.empty()) return;
    if (in.size < sizeof in || !in.globals)
      throw std::runtime_error("this program is older than the element and does not know shared numbers");
    for (std::size_t p = 0; p < in.part_count; ++p)
      for (std::size_t k = 0; k < starts_.size(); ++k)
        in.globals[p * starts_.size() + k] = starts_[k](*f.parameters_[p], f.wholes_[p]);
  }
  static void destroy(void* self) { delete static_cast<Family<E>*>(self); }
  static int evaluate_outputs(const void* self, netloft_tile* t, double* values) {
    const auto& f = *static_cast<const Family<E>*>(self);
    return detail::guarded(t->message, t->message_size, [&] {
      for (std::uint32_t lane = 0; lane < t->count; ++lane) {
        const auto state = detail::gather<detail::nodes_of<E>>(*t, lane);
        const std::size_t e = t->first + lane;
        for (std::size_t k = 0; k < functions_.size(); ++k)
          if (functions_[k].one)
            values[k * kLanes + lane] = functions_[k].one(f.parameters(e), f.data(e), state);
      }
      for (std::size_t k = 0; k < functions_.size(); ++k)
        if (functions_[k].lanes) functions_[k].lanes(f, *t, values + k * kLanes);
      return NETLOFT_OK;
    });
  }

  const char *name_, *doc_, *rides_on_ = nullptr;
  std::uint32_t state_width_ = 0;
  std::vector<netloft_law_slot> laws_;
  std::vector<netloft_term> terms_;
  std::vector<netloft_output> outputs_;
  std::vector<netloft_global> globals_;
  // One table per element type, described once, before any family is made.
  static inline std::vector<netloft_datum> data_;
  static inline std::vector<std::size_t> offsets_;
  static inline std::vector<OutputFunction> functions_;
  static inline std::vector<Start> starts_;
};

}  // namespace netloft

#include <netloft/register.hpp>
