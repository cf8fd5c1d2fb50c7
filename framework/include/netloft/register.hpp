// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <netloft/plugin.h>
#include <netloft/offers.hpp>

#include <memory>
#include <vector>

namespace netloft {

template <class E>
class ElementTable;
template <class S>
class SolverTable;
template <class L>
class LawTable;
template <class I>
class IntegratorTable;
template <class S>
class StrategyTable;

/// Collects the tables of a plugin and converts them to the C structs that the host reads.
class Plugin {
 public:
  template <class E>
  ElementTable<E>& element(const char* name, const char* doc) {
    return add<ElementTable<E>>(name, doc);
  }
  template <class S>
  SolverTable<S>& solver(const char* name, const char* doc) {
    return add<SolverTable<S>>(name, doc);
  }

  template <class I>
  IntegratorTable<I>& integrator(const char* name, const char* doc) {
    return add<IntegratorTable<I>>(name, doc);
  }

  template <class S>
  StrategyTable<S>& strategy(const char* name, const char* doc) {
    return add<StrategyTable<S>>(name, doc);
  }

  template <class L>
  LawTable<L>& law(const char* name, const char* doc) {
    return add<LawTable<L>>(name, doc);
  }

  /// Completes the description of the plugin. `extension` must return the same as `offer`.
  const netloft_plugin* finish(const char* name, const char* version, const char* doc,
                               const void* (*extension)(const char* id)) {
    for (const auto& table : pending_) table->describe(*this);
    plugin_.size = sizeof plugin_;
    plugin_.abi_major = NETLOFT_ABI_MAJOR;
    plugin_.abi_minor = NETLOFT_ABI_MINOR;
    plugin_.flags = NETLOFT_BUILD_FLAGS;
    plugin_.name = name;
    plugin_.version = version;
    plugin_.doc = doc;
    plugin_.compiler = __VERSION__;
    plugin_.elements = elements_.data();
    plugin_.element_count = static_cast<std::uint32_t>(elements_.size());
    plugin_.required = required_.empty() ? nullptr : required_.data();
    plugin_.extension = extension;
    return &plugin_;
  }
  const void* offer(const char* id) const { return offers_.find(id); }

 private:
  template <class Table>
  Table& add(const char* name, const char* doc) {
    auto pending = std::make_unique<Holder<Table>>(name, doc);
    Table& table = pending->table;
    pending_.push_back(std::move(pending));
    return table;
  }

  /// A table of a component. The table is converted at the end, because the author's function may still add
  /// rows.
  struct Pending {
    virtual ~Pending() = default;
    virtual void describe(Plugin& plugin) const = 0;
  };
  template <class Table>
  struct Holder : Pending {
    Holder(const char* name, const char* doc) : table(name, doc) {}
    void describe(Plugin& plugin) const override {
      if constexpr (requires { typename Table::Offer; }) {
        plugin.offers_.rows<typename Table::Offer>(Table::extension).push_back(table.descriptor());
      } else {
        plugin.elements_.push_back(table.descriptor());
        for (const char* id : table.required()) detail::add_identifier(plugin.required_, id);
      }
    }
    Table table;
  };

  std::vector<std::unique_ptr<Pending>> pending_;
  std::vector<netloft_element> elements_;
  std::vector<const char*> required_;
  detail::Offers offers_;
  netloft_plugin plugin_{};
};

namespace detail {
/// The plugin that the author's function Describe describes.
template <void (*Describe)(Plugin&)>
Plugin& plugin_of() {
  static Plugin plugin;
  return plugin;
}

template <void (*Describe)(Plugin&)>
const void* offer_of(const char* id) noexcept {
  return plugin_of<Describe>().offer(id);
}

/// Returns the description of the plugin, which the first call makes; nullptr if that fails.
template <void (*Describe)(Plugin&)>
const netloft_plugin* describe_once(const char* name, const char* version, const char* doc) noexcept {
  try {
    Plugin& plugin = plugin_of<Describe>();
    static const netloft_plugin* described =
        (Describe(plugin), plugin.finish(name, version, doc, &offer_of<Describe>));
    return described;
  } catch (...) {
    return nullptr;
  }
}
}  // namespace detail
}  // namespace netloft

/// Defines the one exported symbol of a plugin. The code in braces after the macro registers the elements and
/// solvers on `plugin`.
#define NETLOFT_PLUGIN(name, version, doc)                                        \
  static void netloft_describe(netloft::Plugin& plugin);                          \
  extern "C" NETLOFT_EXPORT const netloft_plugin* NETLOFT_PLUGIN_SYMBOL(void) {   \
    return netloft::detail::describe_once<&netloft_describe>(name, version, doc); \
  }                                                                               \
  static void netloft_describe([[maybe_unused]] netloft::Plugin& plugin)
