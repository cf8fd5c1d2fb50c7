// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/ranks/messages.hpp"
#include "framework/ranks/share_orders.hpp"

#include <map>
#include <memory>
#include <string>

namespace netloft {

/// On all ranks but 0: makes the scenes that rank 0 makes, with the plugins of its own registry, and
/// evaluates its share of them.
class ShareServer : public ServesShares {
 public:
  ShareServer(Messages& messages, Registry& registry) : messages_(messages), registry_(registry) {}
  void serve(int instance, int job) override;

 private:
  struct Served {
    Scene scene;
    Plan plan;
    std::unique_ptr<Assembler> assembler;  // null: it could not be made
    std::string fault;                     // why not
    Share share;
    std::vector<double> x, x_low, residual, energies;
    std::unique_ptr<double[], void (*)(void*)> values{nullptr, nullptr};
  };
  void open(Served& served);
  Plan plan_of(const Scene& scene, const ShareOpening& opening, std::span<const std::uint8_t> terms);
  void make(Served& served);
  void join(const Served& served);
  void evaluate(Served& served);
  void send_sums(Served& served, const Request& request);
  void set_memory(Served& served);
  void receive_needed(const Served& served, std::span<double> all);

  Messages& messages_;
  Registry& registry_;
  std::map<int, Served> scenes_;
};

}  // namespace netloft
