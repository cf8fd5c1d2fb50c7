// SPDX-License-Identifier: BSD-3-Clause
//
// Structs that a plugin or an element offers for extensions of the plugin interface. Included by register.hpp
// and element.hpp; authors do not use it.
#pragma once
#include <cstdint>
#include <cstring>
#include <memory>
#include <type_traits>
#include <vector>

namespace netloft::detail {

/// The structs offered for extensions, found by the identifier of the extension. A struct is created at its
/// first use, so that code that does not use an extension does not need its header.
class Offers {
 public:
  /// Returns the struct that is offered under an identifier, for an extension whose offer is a single struct.
  template <class Struct>
  Struct& one(const char* id) {
    auto& offer = of<One<Struct>>(id);
    offer.value.size = sizeof(Struct);
    return offer.value;
  }
  /// Returns the rows that are offered under an identifier, for an extension whose offer is a list {size,
  /// count, rows}.
  template <class List>
  auto& rows(const char* id) {
    return of<Rows<List>>(id).rows;
  }
  /// Returns the struct that is offered under this identifier, or nullptr if there is none.
  const void* find(const char* id) const {
    for (const auto& offer : offers_)
      if (std::strcmp(offer->id, id) == 0) return offer->get();
    return nullptr;
  }

 private:
  struct Offer {
    virtual ~Offer() = default;
    virtual const void* get() = 0;
    const char* id = nullptr;
  };
  template <class Struct>
  struct One : Offer {
    const void* get() override { return &value; }
    Struct value{};
  };
  template <class List>
  struct Rows : Offer {
    using Row = std::remove_cvref_t<decltype(*List::rows)>;
    const void* get() override {
      list = {sizeof list, static_cast<std::uint32_t>(rows.size()), rows.data()};
      return &list;
    }
    std::vector<Row> rows;
    List list{};
  };

  template <class Kind>
  Kind& of(const char* id) {
    for (const auto& offer : offers_)
      if (std::strcmp(offer->id, id) == 0) return static_cast<Kind&>(*offer);
    auto& made = *offers_.emplace_back(std::make_unique<Kind>());
    made.id = id;
    return static_cast<Kind&>(made);
  }

  std::vector<std::unique_ptr<Offer>> offers_;
};

/// Adds an identifier to a null-terminated list unless it is already there.
inline void add_identifier(std::vector<const char*>& list, const char* id) {
  for (const char* known : list)
    if (known && std::strcmp(known, id) == 0) return;
  if (list.empty()) list.push_back(nullptr);
  list.insert(list.end() - 1, id);
}

}  // namespace netloft::detail
