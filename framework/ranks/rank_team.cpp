// SPDX-License-Identifier: BSD-3-Clause
#include "framework/ranks/rank_team.hpp"

#include "framework/ranks/share_orders.hpp"
#include "framework/scene/scene_bytes.hpp"

#include <stdexcept>

namespace netloft {

namespace {

class RankPartners : public Partners {
 public:
  RankPartners(Messages& messages, const Scene& scene, const Plan& plan)
      : messages_(messages), instance_(messages.next_instance()) {
    std::vector<std::uint8_t> terms;
    visit_terms(plan, [&](const TermPlan& term) {
      terms.push_back(
          static_cast<std::uint8_t>((term.on ? kTermIsOn : 0) | (term.when_it_moves ? kTermWhenItMoves : 0)));
    });
    std::vector<std::byte> bytes = bytes_of(scene);
    ShareOpening opening{terms.size(), bytes.size(), plan.tangent, plan.symmetric, plan.conservative};
    const auto lock = order(ShareJob::open);
    messages_.broadcast(writable_bytes_of(opening));
    messages_.broadcast(std::as_writable_bytes(std::span(terms))), messages_.broadcast(bytes);
  }
  RankPartners(const RankPartners&) = delete;
  RankPartners& operator=(const RankPartners&) = delete;
  ~RankPartners() override { order(ShareJob::close); }

  void join(const Assembler& assembler) override;
  int size() const override { return messages_.size(); }
  const Share& own() const override { return shares_.front(); }
  bool can(const Request& request) const override {
    return !request.motion.v && !request.motion.a && !request.between;
  }
  void begin(std::span<const double> x, const Request& request) override;
  bool end(const Request& request, std::span<double> tile_energy) override;
  void set_memory(std::span<const double> kept) override;

 private:
  std::unique_lock<std::mutex> order(ShareJob job) {
    return messages_.begin_shares(instance_, static_cast<int>(job));
  }
  template <class Do>
  void for_others(const Do& act) {
    for (int rank = 1; rank < messages_.size(); ++rank) act(rank, shares_[static_cast<std::size_t>(rank)]);
  }
  void send_needed(int rank, const Share& share, std::span<const double> all) {
    for (const Range& range : share.needed) messages_.send(rank, std::as_bytes(part_of(all, range)));
  }
  void receive_sums(int rank, const Share& share, const Request& request, std::span<double> tile_energy);

  Messages& messages_;
  int instance_;
  std::size_t dofs_ = 0;
  std::vector<Share> shares_;  // by rank
  std::vector<double> energies_;
  std::unique_lock<std::mutex> evaluation_;
};

/// The others were making the scene meanwhile. What one of them says is an error of that rank. All that an
/// evaluation needs is made here, so that nothing fails between its beginning and its end.
void RankPartners::join(const Assembler& assembler) {
  dofs_ = assembler.numbering().dofs();
  shares_ = assembler.shares(static_cast<std::size_t>(messages_.size()));
  energies_.reserve(assembler.tile_energies().size());
  const ShareSizes expected = sizes_of(assembler);
  const auto lock = order(ShareJob::join);
  std::string fault;
  for (int rank = 1; rank < messages_.size(); ++rank) {
    ShareSizes sizes;
    messages_.receive(rank, writable_bytes_of(sizes));
    std::string sentence(sizes.sentence, ' ');
    messages_.receive(rank, std::as_writable_bytes(std::span(sentence)));
    if (sentence.empty() && sizes != expected)
      sentence = "its plugins make another scene than those of rank 0";
    if (fault.empty() && !sentence.empty()) fault = "rank " + std::to_string(rank) + ": " + sentence;
  }
  if (!fault.empty()) throw std::runtime_error(fault);
}

void RankPartners::begin(std::span<const double> x, const Request& request) {
  const Kinematics& m = request.motion;
  const ShareRequest wanted{.energy = request.energy != nullptr,
                            .residual = request.residual != nullptr,
                            .gradient = request.gradient != nullptr,
                            .conservative_only = request.conservative_only,
                            .has_low = m.x_low != nullptr,
                            .matrix = wants_matrix(request) ? request.matrix : MatrixKind::none,
                            .without = request.without,
                            .time = m.time,
                            .cu = m.cu,
                            .cv = m.cv,
                            .ca = m.ca};
  evaluation_ = order(ShareJob::evaluate);
  for_others([&](int rank, const Share& share) {
    messages_.send(rank, bytes_of(wanted));
    send_needed(rank, share, x);
    if (m.x_low) send_needed(rank, share, {m.x_low, dofs_});
  });
}

bool RankPartners::end(const Request& request, std::span<double> tile_energy) {
  bool all_could = true;
  for_others([&](int rank, const Share& share) {
    bool could = false;
    messages_.receive(rank, writable_bytes_of(could));
    if (could) receive_sums(rank, share, request, tile_energy);
    all_could = all_could && could;
  });
  evaluation_.unlock();
  return all_could;
}

void RankPartners::receive_sums(int rank, const Share& share, const Request& request,
                                std::span<double> tile_energy) {
  const auto receive = [&](double* all, const Range& range) {
    messages_.receive(rank, std::as_writable_bytes(std::span(all + range.begin, range.size())));
  };
  if (request.energy) {
    energies_.resize(share.own_tiles.size());
    receive(energies_.data(), {0, energies_.size()});
    for (std::size_t i = 0; i < energies_.size(); ++i) tile_energy[share.own_tiles[i]] = energies_[i];
  }
  for (double* forces : {request.residual, request.gradient})
    for (const Range& range : share.places)
      if (forces) receive(forces, range);
  if (wants_matrix(request)) receive(request.values, share.slots);
}

void RankPartners::set_memory(std::span<const double> kept) {
  if (kept.empty()) return;
  const auto lock = order(ShareJob::set_memory);
  for_others([&](int rank, const Share&) { messages_.send(rank, std::as_bytes(kept)); });
}

}  // namespace

std::unique_ptr<Partners> RankTeam::open(const Scene& scene, const Plan& plan) {
  const bool is_at_rest = plan.kind == AnalysisKind::statics && !plan.between;
  const bool is_large = plan.unknowns >= static_cast<std::size_t>(from_);
  if (!is_at_rest || !is_large || messages_.size() < 2) return nullptr;
  return std::make_unique<RankPartners>(messages_, scene, plan);
}

}  // namespace netloft
