// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "io/gears/plan/net_plan.hpp"

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace netloft::gears {

/// Thrown if a seam or a panel cannot be divided into elements. Contains a sentence for the user and a cure.
/// The seam is given by its index and the panel by its name, because the input of the division contains no
/// places in files (division.hpp).
class CannotDivide : public std::invalid_argument {
 public:
  static CannotDivide seam(std::size_t join, const std::string& what, std::string cure) {
    return {what, std::move(cure), join, ""};
  }
  static CannotDivide panel(const std::string& name, const std::string& what, std::string cure) {
    return {"panels." + name + ": " + what, std::move(cure), std::nullopt, name};
  }

  /// Reports the error at the place of the seam or panel in `plan`.
  void report(const NetPlan& plan, formats::Diagnostics& diagnostics) const {
    const Panel* panel = plan.find_panel(panel_);
    diagnostics.error(join_   ? plan.joins.at(*join_).place
                      : panel ? panel->place
                              : formats::Place{},
                      what(), cure_);
  }

 private:
  CannotDivide(const std::string& what, std::string cure, std::optional<std::size_t> join, std::string panel)
      : std::invalid_argument(what), cure_(std::move(cure)), join_(join), panel_(std::move(panel)) {}

  std::string cure_;
  std::optional<std::size_t> join_;
  std::string panel_;
};

}  // namespace netloft::gears
