// SPDX-License-Identifier: BSD-3-Clause
//
// Where rigid bodies are and how they are turned.
#include <netloft/attitude.hpp>

#include "io/report/gear_view.hpp"

namespace netloft::io {

void add_body_figures(const LoadedScene& loaded, const Assembler& assembler, const Answer& answer,
                      std::vector<Figure>& figures) {
  for (std::size_t b = 0; b < loaded.scene.bodies.size(); ++b) {
    const RigidBody& body = loaded.scene.bodies[b];
    const auto psi = assembler.rotation(b, answer.x);
    const Attitude turned = attitude_of(turned_axes(Vector{psi[0], psi[1], psi[2]}), loaded.bodies[b].side);
    const auto at = assembler.node_position(body.origin, answer.x);
    const std::string own = "bodies/" + body.name + "/";
    figures.push_back({own + "heading", "rad", "angle by which its nose is turned outward", turned.heading});
    figures.push_back({own + "heel", "rad", "angle by which its top leans outward", turned.heel});
    figures.push_back({own + "trim", "rad", "angle by which its nose is up", turned.trim});
    figures.push_back({own + "x", "m", "place of its origin, aft", at[0]});
    figures.push_back({own + "y", "m", "place of its origin, to starboard", at[1]});
    figures.push_back({own + "z", "m", "height of its origin over the surface of the water", at[2]});
  }
}

}  // namespace netloft::io
