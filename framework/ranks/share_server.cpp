// SPDX-License-Identifier: BSD-3-Clause
#include "framework/ranks/share_server.hpp"

#include "framework/ranks/share_orders.hpp"
#include "framework/scene/scene_bytes.hpp"

#include <cstdlib>
#include <new>
#include <stdexcept>

namespace netloft {

void ShareServer::serve(int instance, int job) {
  Served& served = scenes_[instance];
  switch (static_cast<ShareJob>(job)) {
    case ShareJob::open:
      return open(served);
    case ShareJob::join:
      return join(served);
    case ShareJob::evaluate:
      return evaluate(served);
    case ShareJob::set_memory:
      return set_memory(served);
    case ShareJob::close:
      scenes_.erase(instance);
  }
}

/// What goes wrong here is said when rank 0 joins; what is wrong with the scene, it finds itself.
void ShareServer::open(Served& served) {
  ShareOpening opening;
  messages_.broadcast(writable_bytes_of(opening));
  std::vector<std::uint8_t> terms(opening.terms);
  std::vector<std::byte> bytes(opening.bytes);
  messages_.broadcast(std::as_writable_bytes(std::span(terms))), messages_.broadcast(bytes);
  try {
    served.scene = scene_of(bytes);
    served.plan = plan_of(served.scene, opening, terms);
    make(served);
  } catch (const std::bad_alloc&) {
    served.assembler = nullptr;
    served.fault = "not enough memory for the scene";
  } catch (const std::exception& e) {
    served.assembler = nullptr;
    served.fault = e.what();
  }
}

Registry& ShareServer::registry() {
  if (!registry_) {
    Registry found;
    find_plugins_(found);
    registry_ = std::move(found);
  }
  return *registry_;
}

/// Of the components that this rank finds; what acts, rank 0 has decided.
Plan ShareServer::plan_of(const Scene& scene, const ShareOpening& opening,
                          std::span<const std::uint8_t> terms) {
  Plan plan = make_plan(scene, registry(), opening.tangent);
  plan.symmetric = opening.symmetric, plan.conservative = opening.conservative;
  std::size_t next = 0;
  visit_terms(plan, [&](TermPlan& term) {
    const std::uint8_t use = next < terms.size() ? terms[next] : std::uint8_t{0};
    term.on = use & kTermIsOn, term.when_it_moves = use & kTermWhenItMoves;
    ++next;
  });
  if (next != terms.size()) throw std::runtime_error("it has other plugins than rank 0");
  return plan;
}

/// Values take room only where the share adds to them: its columns, and those next to them, which its tiles
/// reach and nobody reads or sets to zero.
void ShareServer::make(Served& served) {
  served.assembler = std::make_unique<Assembler>(served.scene, served.plan, 1);
  const Assembler& assembler = *served.assembler;
  served.share = assembler.shares(
      static_cast<std::size_t>(messages_.size()))[static_cast<std::size_t>(messages_.rank())];
  served.x = served.x_low = assembler.start();
  served.residual.resize(served.x.size()), served.gradient.resize(served.x.size());
  served.energies.resize(served.share.own_tiles.size());
  served.values = {static_cast<double*>(std::calloc(assembler.value_slots(), sizeof(double))), std::free};
  if (!served.values) throw std::bad_alloc();
}

void ShareServer::join(const Served& served) {
  ShareSizes sizes;
  if (served.assembler) sizes = sizes_of(*served.assembler);
  sizes.sentence = served.fault.size();
  messages_.send(0, bytes_of(sizes));
  messages_.send(0, std::as_bytes(std::span(served.fault)));
}

void ShareServer::receive_needed(const Served& served, std::span<double> all) {
  for (const Range& range : served.share.needed)
    messages_.receive(0, std::as_writable_bytes(all.subspan(range.begin, range.size())));
}

void ShareServer::evaluate(Served& served) {
  ShareRequest wanted;
  messages_.receive(0, writable_bytes_of(wanted));
  receive_needed(served, served.x);
  if (wanted.has_low) receive_needed(served, served.x_low);
  double energy = 0;
  Request request{.energy = wanted.energy ? &energy : nullptr,
                  .conservative_only = wanted.conservative_only,
                  .without = wanted.without,
                  .residual = wanted.residual ? served.residual.data() : nullptr,
                  .gradient = wanted.gradient ? served.gradient.data() : nullptr,
                  .matrix = wanted.matrix,
                  .values = wanted.matrix != MatrixKind::none ? served.values.get() : nullptr};
  request.motion = {.time = wanted.time,
                    .cu = wanted.cu,
                    .cv = wanted.cv,
                    .ca = wanted.ca,
                    .x_low = wanted.has_low ? served.x_low.data() : nullptr};
  const bool could = served.assembler->evaluate_share(served.share, served.x, request);
  messages_.send(0, bytes_of(could));
  if (could) send_sums(served, request);
}

void ShareServer::send_sums(Served& served, const Request& request) {
  const auto send = [&](const double* all, const Range& range) {
    messages_.send(0, std::as_bytes(std::span(all + range.begin, range.size())));
  };
  if (request.energy) {
    const std::span<const double> all = served.assembler->tile_energies();
    for (std::size_t i = 0; i < served.energies.size(); ++i)
      served.energies[i] = all[served.share.own_tiles[i]];
    send(served.energies.data(), {0, served.energies.size()});
  }
  for (const double* forces : {request.residual, request.gradient})
    for (const Range& range : served.share.places)
      if (forces) send(forces, range);
  if (wants_matrix(request)) send(request.values, served.share.slots);
}

void ShareServer::set_memory(Served& served) {
  std::vector<double> kept = served.assembler->memory();
  messages_.receive(0, std::as_writable_bytes(std::span(kept)));
  served.assembler->set_memory(kept);
}

}  // namespace netloft
