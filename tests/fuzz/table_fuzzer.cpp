// SPDX-License-Identifier: BSD-3-Clause
// Tries random tables of a plugin: each input gives the numbers, words and null pointers in them. Pointers
// are valid or null: wild pointers would end this process, whereas the program tries plugins in a process of
// their own.
#include "framework/parameters/parameter_values.hpp"
#include "framework/registry/descriptors.hpp"
#include "tests/fuzz/choices.hpp"
#include "tests/fuzz/scratch_file.hpp"

#include <deque>
#include <vector>

namespace {

using namespace netloft;

/// Makes tables, and owns all objects that they point to.
class Tables {
 public:
  Tables(const std::uint8_t* data, std::size_t size) : source_(data, size) {}

  netloft_plugin plugin() {
    netloft_plugin p{};
    p.size = row_size(sizeof p);
    p.abi_major = source_.flag() ? NETLOFT_ABI_MAJOR : source_.any<std::uint32_t>();
    p.abi_minor = source_.in<std::uint32_t>(0, 2);
    p.name = source_.flag() ? "fuzzed" : word(), p.version = word(), p.doc = word(), p.compiler = word();
    p.elements = rows<netloft_element>(p.element_count, &Tables::element);
    p.required = list();
    solvers_ = list_of<netloft_solvers>(&Tables::method<netloft_solver>);
    laws_ = list_of<netloft_laws>(&Tables::law);
    integrators_ = list_of<netloft_integrators>(&Tables::method<netloft_integrator>);
    strategies_ = list_of<netloft_strategies>(&Tables::method<netloft_strategy>);
    offering_ = this;
    p.extension = [](const char* id) { return offering_->offer(id); };
    return p;
  }

 private:
  /// In seven of eight cases, the size of a row in this version; otherwise a random size up to it, as of an
  /// older version.
  std::uint32_t row_size(std::size_t size) {
    return source_.in<int>(0, 7) ? static_cast<std::uint32_t>(size)
                                 : source_.in<std::uint32_t>(0, static_cast<std::uint32_t>(size));
  }
  const char* word() {
    switch (source_.in<int>(0, 9)) {
      case 0:
        return nullptr;
      case 1:
        return words_.emplace_back(source_.text(300)).c_str();
      case 2:
        return "EA";
      case 3:
        return "a b EA";
      default:
        return words_.emplace_back("w" + std::to_string(source_.any<std::uint8_t>())).c_str();
    }
  }
  /// A list of words that ends with a null pointer, or a null pointer instead of the list.
  const char* const* list() {
    if (source_.flag()) return nullptr;
    auto& words = lists_.emplace_back();
    for (int n = source_.in<int>(0, 4); n > 0; --n)
      if (const char* w = word()) words.push_back(w);
    words.push_back(nullptr);
    return words.data();
  }
  /// Consecutive rows. Sometimes there are none, and `count` is 1 or larger than a table may have: then no
  /// reader may read a row.
  template <class T, class Count>
  const T* rows(Count& count, void (Tables::*fill)(T&)) {
    const int n = source_.in<int>(-2, 3);
    count = n == -2 ? kMostRows + 1 + source_.any<std::uint16_t>() : static_cast<Count>(std::max(n, 0));
    if (n == -1) count = 1;
    if (n <= 0) return nullptr;
    const std::uint32_t size = row_size(sizeof(T));
    auto& bytes = memory_.emplace_back(static_cast<std::size_t>(n) * sizeof(T) + sizeof(T));
    for (int i = 0; i < n; ++i) {
      T row{};
      (this->*fill)(row);
      row.size = size;
      std::memcpy(bytes.data() + static_cast<std::size_t>(i) * size, &row,
                  std::min<std::size_t>(size, sizeof row));
    }
    return reinterpret_cast<const T*>(bytes.data());
  }
  double number() { return source_.flag() ? source_.in<int>(-2, 9) : source_.number(); }

  void parameter(netloft_parameter& p) {
    p.kind = source_.in<std::uint32_t>(0, 6);
    p.name = word(), p.unit = word(), p.doc = word(), p.fallback_of = source_.flag() ? nullptr : word();
    p.fallback = number(), p.lo = number(), p.hi = number();
    p.flags = source_.in<std::uint32_t>(0, 15);
    p.offset = source_.flag() ? 8 * source_.in<std::uint32_t>(0, 8) : source_.any<std::uint32_t>();
    p.choices = list(), p.columns = list(), p.column_units = list(), p.fallback_text = word();
  }
  template <class T>
  void add_parameters(T& t) {
    t.name = word(), t.doc = word();
    t.parameter_bytes = source_.flag() ? 64 : source_.in<std::uint32_t>(0, 1 << 20);
    t.parameters = rows<netloft_parameter>(t.parameter_count, &Tables::parameter);
  }
  template <class T>
  void method(T& t) {
    add_parameters(t);
    if (source_.flag()) return;
    if constexpr (requires { t.solve; }) t.solve = [](const void*, netloft_problem*) { return 0; };
    if constexpr (requires { t.run; }) t.run = [](const void*, netloft_search*) { return 0; };
    if constexpr (requires { t.step; }) {
      t.step = [](const void*, netloft_motion*) { return 0; };
      t.order = [](const void*) { return 1.0; };
      t.stable_step = [](const void*, double) { return 0.0; };
    }
  }
  void law(netloft_law& l) {
    add_parameters(l);
    l.kind = source_.in<std::uint32_t>(0, 3);
    if (source_.flag()) l.evaluate = [](const void*, const netloft_law_tile*) { return 0; };
  }
  template <class T>
  void named(T& t) {
    t.name = word(), t.doc = word();
    if constexpr (requires { t.unit; }) t.unit = word();
    if constexpr (requires { t.needs; }) t.needs = word();
    if constexpr (requires { t.width; }) t.width = source_.any<std::uint32_t>();
    if constexpr (requires { t.fallback; }) t.fallback = word();
    if constexpr (requires { t.traits; }) t.traits = source_.in<std::uint32_t>(0, 1 << 17);
    if constexpr (requires { t.evaluate; })
      if (source_.flag()) t.evaluate = [](const void*, netloft_tile*) { return 0; };
  }
  void element(netloft_element& e) {
    add_parameters(e);
    const std::uint32_t stencils[] = {NETLOFT_NODE, NETLOFT_BAR, NETLOFT_TRIANGLE, NETLOFT_BAR_PAIR, 7, 0};
    e.stencil = source_.pick(stencils);
    e.data = rows<netloft_datum>(e.datum_count, &Tables::named<netloft_datum>);
    e.terms = rows<netloft_term>(e.term_count, &Tables::named<netloft_term>);
    e.outputs = rows<netloft_output>(e.output_count, &Tables::named<netloft_output>);
    slots_ = list_of<netloft_law_slots>(&Tables::named<netloft_law_slot>);
    globals_ = list_of<netloft_globals>(&Tables::named<netloft_global>);
    rider_ = {row_size(sizeof rider_), 0, word()};
    memory_width_ = {row_size(sizeof memory_width_), source_.any<std::uint32_t>()};
    members_ = {row_size(sizeof members_), source_.in<std::uint32_t>(0, 3), nullptr};
    e.inputs = list();
    if (source_.flag()) e.extension = [](const char* id) { return offering_->offer_of_element(id); };
    if (source_.flag()) e.create = [](netloft_create*, void**) { return 0; }, e.destroy = [](void*) {};
    if (source_.flag()) e.output = [](const void*, netloft_tile*, double*) { return 0; };
  }

  /// All elements of a plugin have the same offer.
  const void* offer_of_element(std::string_view id) const {
    if (id == NETLOFT_EXT_LAWS) return &slots_;
    if (id == NETLOFT_EXT_SHARED_UNKNOWNS) return &globals_;
    if (id == NETLOFT_EXT_PAIRS) return &rider_;
    if (id == NETLOFT_EXT_MEMORY) return &memory_width_;
    if (id == NETLOFT_EXT_MEMBERS) return &members_;
    return nullptr;
  }
  const void* offer(std::string_view id) const {
    if (id == NETLOFT_EXT_SOLVER) return &solvers_;
    if (id == NETLOFT_EXT_LAWS) return &laws_;
    if (id == NETLOFT_EXT_INTEGRATOR) return &integrators_;
    if (id == NETLOFT_EXT_STRATEGY) return &strategies_;
    return nullptr;
  }
  template <class List, class Row>
  List list_of(void (Tables::*fill)(Row&)) {
    List list{row_size(sizeof(List)), 0, nullptr};
    list.rows = rows<Row>(list.count, fill);
    return list;
  }

  static inline const Tables* offering_ = nullptr;
  netloft_solvers solvers_{};
  netloft_laws laws_{};
  netloft_integrators integrators_{};
  netloft_strategies strategies_{};
  netloft_law_slots slots_{};
  netloft_globals globals_{};
  netloft_rider rider_{};
  netloft_memory memory_width_{};
  netloft_element_members members_{};
  fuzz::Choices source_;
  std::deque<std::string> words_;
  std::deque<std::vector<const char*>> lists_;
  std::deque<std::vector<char>> memory_;
};

/// Uses an accepted table as the program does: prints its ranges and fills a struct.
void use_parameters(const std::vector<netloft_parameter>& rows, std::size_t bytes) {
  Values values;
  for (const auto& p : rows) {
    fuzz::use(allowed(p).size() + default_of(p).size());
    if (p.flags & NETLOFT_REQUIRED) values[p.name] = p.lo;
  }
  std::vector<std::string> faults;
  const ParameterBlock block(rows, bytes, values, faults);
  for (const auto& p : rows)
    if (p.kind <= NETLOFT_CHOICE) fuzz::use(block.number(p) > 0);
  fuzz::use(undeclared(rows, bytes).size() + faults.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Tables tables(data, size);
  const netloft_plugin plugin = tables.plugin();
  try {
    const PluginContent content = read_plugin(&plugin, "fuzzed.so", "fuzzed");
    for (const auto& e : content.elements) use_parameters(e.parameters, e.element.parameter_bytes);
    for (const auto& e : content.elements)
      for (const auto& t : e.terms) fuzz::use(names_needed_by(t).size());
    for (const auto& s : content.solvers) use_parameters(s.parameters, s.solver.parameter_bytes);
    for (const auto& l : content.laws) use_parameters(l.parameters, l.law.parameter_bytes);
    for (const auto& i : content.integrators) use_parameters(i.parameters, i.integrator.parameter_bytes);
    for (const auto& s : content.strategies) use_parameters(s.parameters, s.strategy.parameter_bytes);
  } catch (const PluginRefused& e) {
    fuzz::use(std::strlen(e.what()));
  }
  return 0;
}
