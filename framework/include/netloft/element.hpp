// SPDX-License-Identifier: BSD-3-Clause
//
// The header for authors of elements. An element is a struct with the nodes that it connects (`stencil`), its
// `Parameters` (set by users, one per part of a gear), its `Data` (one per element) and its terms. A term is
// a struct with one of four functions, in order from the quickest to write to the fastest to run:
//
//   template <class T> static T energy(const Parameters&, const Data&, const Water&, const Points<T, N>& x);
//   template <class T> static Points<T, N> force(const Parameters&, const Data&, const MovingNodes<T, N>&);
//   static Status evaluate(const Parameters&, const Data&, const State<N>&, Local<N>&);
//   static Status tile(const Family<Element>&, netloft_tile&);
//
// `energy` and `force` are differentiated automatically; `evaluate` computes one element, `tile` computes up
// to 64 elements in a loop. `force` returns the physical force on the nodes; the other functions compute the
// residual, which is minus the physical force.
//
// On a rigid body (`stencil = NETLOFT_BODY`), `energy` takes a `Pose<T>` instead of points, and `force` takes
// a `Body<T>` and returns a `Wrench<T>`: see body.hpp. `evaluate` and `tile` see the body as two nodes, the
// second of which is its rotation vector: see ext/bodies.h.
//
// If an element needs data of its whole part (all elements with the same parameters), it declares a struct
// `Whole`. The host calls `gather(parameters, data, whole)`, which fills this struct, for each element of the
// part in turn. `evaluate`, `force` and outputs receive the struct after the data, and
// `check_whole(parameters, whole)` may throw std::invalid_argument. Curves from tables (interpolation.hpp)
// are best stored in `Whole`, too, so that they are made only once per part. If the elements of a part share
// unknowns (the front of a catch), the element declares their number, `static constexpr int globals = 1`.
// These unknowns are the coordinates of an additional last node, so that N is greater by one.
//
// If an element bears tension along straight lines, it can declare these lines, its members. Solvers may then
// treat the tensions as unknowns:
//
//   static std::array<Member, N> members(const Parameters&, const Data&, double time);
//
// The term whose force is exactly that of the members has the trait `of_members`.
//
// An element whose shared unknowns describe how the gear changes the water is a flow: see flow.hpp.
#pragma once
#include <netloft/ext/pairs.h>
#include <netloft/ext/shared_unknowns.h>
#include <netloft/element_calls.hpp>
#include <netloft/flow.hpp>
#include <netloft/offers.hpp>
#include <netloft/parameters.hpp>

#include <memory>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace netloft {

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
  of_members = NETLOFT_OF_MEMBERS,
  is_weight = NETLOFT_IS_WEIGHT,
  is_drag = NETLOFT_IS_DRAG,
  reads_ground = NETLOFT_READS_GROUND,
  reads_bed = NETLOFT_READS_BED,
  reads_waves = NETLOFT_READS_WAVES,
  needs_waves = NETLOFT_NEEDS_WAVES,
};

/// The meaning of an output, for reports that compare parts of different types.
enum class OutputRole : std::uint32_t {
  plain = NETLOFT_OUTPUT_PLAIN,
  tension = NETLOFT_OUTPUT_TENSION,  // tension in a rope or in one twine [N], negative if compressed
  doubt = NETLOFT_OUTPUT_DOUBT,      // not zero if the element is used beyond its known range of validity
};

/// Describes one element to the host: parameters, data, terms, outputs.
template <class E>
class ElementTable : public ParameterTable<typename E::Parameters> {
 public:
  using Parameters = typename E::Parameters;
  using Data = typename E::Data;
  using Output = double (*)(const Parameters&, const Data&, const detail::ViewOf<E>&);
  using OutputWithWhole = double (*)(const Parameters&, const Data&, const typename Family<E>::Whole&,
                                     const detail::ViewOf<E>&);
  using LanesOutput = void (*)(const Family<E>&, const netloft_tile&, double* values);
  using Start = double (*)(const Parameters&, const typename Family<E>::Whole&);
  static_assert(std::is_trivially_copyable_v<Data>, "Data must be plain numbers");

  ElementTable(const char* name, const char* doc) : name_(name), doc_(doc) {
    if constexpr (detail::is_on_body<E>)
      required_.push_back(NETLOFT_EXT_BODIES);
    else if constexpr (E::stencil > 0xff)
      required_.push_back(NETLOFT_EXT_PAIRS);
    if constexpr (detail::IsFlow<E>) {
      required_.push_back(NETLOFT_EXT_FLOW);
      offers_.template one<netloft_flow>(NETLOFT_EXT_FLOW).evaluate = &detail::evaluate_flow<E>;
    }
  }

  /// Declares a number that every element has, and its unit.
  void data(const char* name, double Data::*member, const char* unit, const char* doc) {
    add_datum(name, unit, doc, offset_of(member), 1);
  }
  template <std::size_t Width>
  void data(const char* name, std::array<double, Width> Data::*member, const char* unit, const char* doc) {
    add_datum(name, unit, doc, offset_of(member), Width);
  }

  /// Declares a term. `needs` are names of parameters, separated by spaces; the term acts only if at least
  /// one of them is not zero.
  template <class T, std::uint32_t Traits = 0>
  void term(const char* name, const char* doc, const char* needs = nullptr) {
    constexpr std::uint32_t traits =
        Traits | (detail::HasEnergy<E, T> && !detail::HasTile<E, T> && !detail::HasEvaluate<E, T>
                      ? std::uint32_t{NETLOFT_CONSERVATIVE | NETLOFT_SYMMETRIC}
                      : 0u);
    netloft_term t{};
    t.size = sizeof t;
    t.traits = traits;
    t.name = name;
    t.doc = doc;
    t.needs = needs;
    t.evaluate = &detail::evaluate_term<E, T, traits>;
    terms_.push_back(t);
    if constexpr ((traits & NETLOFT_OF_MEMBERS) != 0) declare_members();
    list_inputs(traits);
  }

  /// Declares a number that is reported for each element, with the sign of the physical quantity: tension is
  /// positive.
  void output(const char* name, const char* unit, const char* doc, Output function,
              OutputRole role = OutputRole::plain) {
    add_output(name, unit, doc, {function, nullptr, nullptr}, role);
  }
  void output_of_whole(const char* name, const char* unit, const char* doc, OutputWithWhole function,
                       OutputRole role = OutputRole::plain) {
    add_output(name, unit, doc, {nullptr, function, nullptr}, role);
  }
  /// Declares an output that is computed for 64 elements at once, such as the result of a law.
  void output_lanes(const char* name, const char* unit, const char* doc, LanesOutput function) {
    add_output(name, unit, doc, {nullptr, nullptr, function}, OutputRole::plain);
  }

  /// Declares a key under which users choose a law by name. `accepts` is a sum of values of netloft_law_kind,
  /// `fallback` is the default.
  void law(const char* name, std::uint32_t accepts, const char* fallback, const char* doc) {
    netloft_law_slot l{};
    l.size = sizeof l;
    l.accepts = accepts;
    l.name = name;
    l.doc = doc;
    l.fallback = fallback;
    require(NETLOFT_EXT_LAWS, &detail::take_laws<E>);
    offers_.template rows<netloft_law_slots>(NETLOFT_EXT_LAWS).push_back(l);
  }
  /// Makes the host create this element on each pair of neighbouring elements of another type of the same
  /// plugin, such as bending on the bars of a rope.
  void rides_on(const char* element) {
    offers_.template one<netloft_rider>(NETLOFT_EXT_PAIRS).rides_on = element;
  }
  /// Declares an unknown that all elements of a part share, with its initial value `start`. If the parameter
  /// named by `needs` is zero, the unknown keeps this value; if `needs` is nullptr, it is always free. The
  /// unknowns, three at most, are x, y and z of the last node of State::x.
  void global(const char* name, const char* unit, const char* doc, const char* needs, Start start) {
    netloft_global g{};
    g.size = sizeof g;
    g.name = name;
    g.unit = unit;
    g.doc = doc;
    g.needs = needs;
    require(NETLOFT_EXT_SHARED_UNKNOWNS, &place_globals);
    offers_.template rows<netloft_globals>(NETLOFT_EXT_SHARED_UNKNOWNS).push_back(g);
    starts_.push_back(start);
  }
  /// Declares how many numbers each element remembers from one accepted step to the next.
  void remembers(std::uint32_t width) {
    require(NETLOFT_EXT_MEMORY, nullptr);
    offers_.template one<netloft_memory>(NETLOFT_EXT_MEMORY).width = width;
  }

  /// Identifiers of the extensions that a host must support to accept the element.
  const std::vector<const char*>& required() const { return required_; }

  netloft_element descriptor() const {
    detail::OwnParameters<E>::declare(this->rows());
    netloft_element e{};
    e.size = sizeof e;
    e.stencil = E::stencil;
    e.name = name_;
    e.doc = doc_;
    e.parameter_bytes = sizeof(Parameters);
    e.parameter_count = static_cast<std::uint32_t>(this->rows().size());
    e.parameters = this->rows().data();
    e.datum_count = static_cast<std::uint32_t>(data_.size());
    e.data = data_.data();
    e.term_count = static_cast<std::uint32_t>(terms_.size());
    e.terms = terms_.data();
    e.output_count = static_cast<std::uint32_t>(outputs_.size());
    e.outputs = outputs_.data();
    e.create = &create;
    e.destroy = &destroy;
    e.output = &evaluate_outputs;
    if (lists_inputs_) e.inputs = inputs_.data();
    e.extension = &offer_of;
    return e;
  }

 private:
  template <class M>
  static std::size_t offset_of(M Data::*member) {
    static const Data object{};
    return static_cast<std::size_t>(reinterpret_cast<const char*>(&(object.*member)) -
                                    reinterpret_cast<const char*>(&object));
  }
  /// The function of an output: one of these pointers; the other two are nullptr.
  struct OutputFunction {
    Output one;
    OutputWithWhole with_whole;
    LanesOutput lanes;
  };
  /// Declares the members of the element; the term with the trait `of_members` is their force.
  void declare_members() {
    static_assert(detail::HasMembers<E>,
                  "A term of members needs a static function of the element, `std::array<Member, N> "
                  "members(const Parameters&, const Data&, double time)`.");
    auto& members = offers_.template one<netloft_element_members>(NETLOFT_EXT_MEMBERS);
    members.count = detail::count_members<E>();
    members.write = &detail::write_members<E>;
  }
  /// Lists the extensions (ground, waves, memory) whose data a term with these traits reads, so that the host
  /// provides them.
  void list_inputs(std::uint32_t traits) {
    if (traits & (NETLOFT_READS_GROUND | NETLOFT_READS_BED))
      list_input(detail::kGroundPlace, NETLOFT_EXT_GROUND);
    if (traits & NETLOFT_READS_WAVES) list_input(detail::kWavesPlace, NETLOFT_EXT_WAVES);
    if (traits & NETLOFT_READS_STATE) list_input(detail::kMemoryPlace, NETLOFT_EXT_MEMORY);
  }
  void list_input(std::size_t place, const char* id) {
    inputs_[place] = id;
    lists_inputs_ = true;
  }
  /// Requires an extension. When elements are created, `take` reads the host's data for this extension;
  /// `take` is nullptr if there are none.
  void require(const char* id, void (*take)(Family<E>&, netloft_create&)) {
    for (const char* known : required_)
      if (std::strcmp(known, id) == 0) return;
    required_.push_back(id);
    if (take) takers_.push_back(take);
  }
  static const void* offer_of(const char* id) noexcept { return offers_.find(id); }
  void add_output(const char* name, const char* unit, const char* doc, OutputFunction function,
                  OutputRole role) {
    netloft_output o{};
    o.size = sizeof o;
    o.role = static_cast<std::uint32_t>(role);
    o.name = name;
    o.unit = unit;
    o.doc = doc;
    outputs_.push_back(o);
    functions_.push_back(function);
  }
  void add_datum(const char* name, const char* unit, const char* doc, std::size_t offset, std::size_t width) {
    netloft_datum d{};
    d.size = sizeof d;
    d.width = static_cast<std::uint32_t>(width);
    d.name = name;
    d.unit = unit;
    d.doc = doc;
    data_.push_back(d);
    offsets_.push_back(offset);
  }
  static int create(netloft_create* in, void** self) {
    return detail::guarded(in->message, in->message_size, [&] {
      auto family = std::make_unique<Family<E>>();
      detail::fill_family(*family, *in, offsets_, data_);
      for (const auto& take : takers_) take(*family, *in);
      *self = family.release();
      return NETLOFT_OK;
    });
  }
  static void place_globals(Family<E>& f, netloft_create& in) {
    const auto* to = detail::given<netloft_global_starts>(in, NETLOFT_EXT_SHARED_UNKNOWNS);
    for (std::size_t p = 0; to && p < in.part_count; ++p)
      for (std::size_t k = 0; k < starts_.size(); ++k)
        to->start[p * starts_.size() + k] = starts_[k](f.parameters_[p], f.wholes_[p]);
  }
  static void destroy(void* self) { delete static_cast<Family<E>*>(self); }
  static int evaluate_outputs(const void* self, netloft_tile* t, double* values) {
    const auto& f = *static_cast<const Family<E>*>(self);
    return detail::guarded(t->message, t->message_size, [&] {
      for (std::uint32_t lane = 0; lane < t->count; ++lane) {
        const auto state = detail::view_of<E>(*t, lane);
        const std::size_t e = t->first + lane;
        for (std::size_t k = 0; k < functions_.size(); ++k)
          if (functions_[k].one)
            values[k * kLanes + lane] = functions_[k].one(f.parameters(e), f.data(e), state);
          else if (functions_[k].with_whole)
            values[k * kLanes + lane] =
                functions_[k].with_whole(f.parameters(e), f.data(e), f.whole(e), state);
      }
      for (std::size_t k = 0; k < functions_.size(); ++k)
        if (functions_[k].lanes) functions_[k].lanes(f, *t, values + k * kLanes);
      return NETLOFT_OK;
    });
  }

  const char *name_, *doc_;
  std::vector<const char*> required_;
  bool lists_inputs_ = false;
  // An input that no term reads is listed as "". No host knows this identifier or provides data for it.
  std::array<const char*, detail::kInputPlaces + 1> inputs_{"", "", "", nullptr};
  std::vector<netloft_term> terms_;
  std::vector<netloft_output> outputs_;
  // One table per element type, filled before any element is created.
  static inline std::vector<netloft_datum> data_;
  static inline std::vector<std::size_t> offsets_;
  static inline std::vector<OutputFunction> functions_;
  static inline std::vector<Start> starts_;
  static inline std::vector<void (*)(Family<E>&, netloft_create&)> takers_;
  static inline detail::Offers offers_;
};

}  // namespace netloft

#include <netloft/register.hpp>
