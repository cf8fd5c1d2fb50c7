// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/registry/registry.hpp"

namespace netloft::io {

/// What the interior-point method of tension_cones.hpp is worth to a scene.
///   never      bodies and frames carry nodes; or things stick and slide; or there is no member, or no load
///   as_a_way   after some others: members stretch much, so that coarser meshes lead better, or stand by
///              themselves when pressed, or are ropes in a current, of which no member need be slack: there
///              are no more of them than their nodes have unknowns
///   first      a net in a current, which gives what is slack its place; or without one, members that bear
///              tension only, or hardly stretch and bear next to nothing when pressed
enum class ConeUse { never, as_a_way, first };

ConeUse use_of_cones(const Scene& scene, Registry& registry, Assembler& assembler);

/// All that drives the gear, all in all [N].
double load_of(Assembler& assembler);

}  // namespace netloft::io
