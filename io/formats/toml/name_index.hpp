// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace netloft::formats {

/// Finds items of a list by name without a search through the list. Between two calls, the list may only grow
/// at its end; after any other change, also of a name, a new index is needed. Not safe for several threads.
class NameIndex {
 public:
  /// The index of the first item with this name in `all`; name_of(item) returns the name of an item.
  template <class List, class NameOf>
  std::optional<std::size_t> find(std::string_view name, const List& all, const NameOf& name_of) {
    for (; known_ < all.size(); ++known_) first_.emplace(name_of(all[known_]), known_);
    const auto at = first_.find(name);
    return at == first_.end() ? std::nullopt : std::optional(at->second);
  }

 private:
  std::map<std::string, std::size_t, std::less<>> first_;
  std::size_t known_ = 0;  // number of items of the list that are in `first_`
};

}  // namespace netloft::formats
