// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/partners.hpp"
#include "framework/ranks/messages.hpp"

#include <cstdint>

namespace netloft {

/// On rank 0: all ranks as a team. They make scenes of `from` unknowns and more that are at rest, and
/// evaluate their shares.
class RankTeam : public Team {
 public:
  /// `messages` must outlive it and what it opens.
  RankTeam(Messages& messages, std::int32_t from) : messages_(messages), from_(from) {}
  std::unique_ptr<Partners> open(const Scene& scene, const Plan& plan) override;

 private:
  Messages& messages_;
  std::int32_t from_;
};

}  // namespace netloft
