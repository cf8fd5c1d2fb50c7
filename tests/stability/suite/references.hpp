// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tests/stability/suite/judge.hpp"

#include <map>

namespace netloft::hard_cases {

/// The best known equilibria, by name and size, in the file references.json of the suite.
class References {
 public:
  /// Reads the file; if there is none, there are no references. Throws std::runtime_error, naming the file,
  /// if it cannot be read.
  explicit References(const std::filesystem::path& file);

  std::optional<Reference> find(const std::string& name, const std::string& size) const;
  void keep(const std::string& name, const std::string& size, const Reference& reference);
  void forget(const std::string& name, const std::string& size);
  void save() const;

 private:
  std::filesystem::path file_;
  std::map<std::string, std::map<std::string, Reference>> all_;
};

}  // namespace netloft::hard_cases
