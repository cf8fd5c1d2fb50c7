// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "framework/assembler/assembler.hpp"
#include "framework/ranks/messages.hpp"
#include "framework/ranks/share_orders.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace netloft {

/// On all ranks but 0: makes the scenes that rank 0 makes, with the plugins of its own registry, and
/// evaluates its share of them, by one thread.
class ShareServer : public ServesShares {
 public:
  /// `find_plugins` is called when the first scene is made. What it throws is why that cannot be.
  ShareServer(Messages& messages, std::function<void(Registry&)> find_plugins)
      : messages_(messages), find_plugins_(std::move(find_plugins)) {}
  void serve(int instance, int job) override;

 private:
  struct Served {
    Scene scene;
    Plan plan;
    std::unique_ptr<Assembler> assembler;  // null: it could not be made
    std::string fault;                     // why not
    Share share;
    std::vector<double> x, x_low, residual, gradient, energies;
    std::unique_ptr<double[], void (*)(void*)> values{nullptr, nullptr};
  };
  void open(Served& served);
  Registry& registry();
  Plan plan_of(const Scene& scene, const ShareOpening& opening, std::span<const std::uint8_t> terms);
  void make(Served& served);
  void join(const Served& served);
  void evaluate(Served& served);
  void send_sums(Served& served, const Request& request);
  void set_memory(Served& served);
  void receive_needed(const Served& served, std::span<double> all);

  Messages& messages_;
  std::function<void(Registry&)> find_plugins_;
  std::optional<Registry> registry_;
  std::map<int, Served> scenes_;
};

}  // namespace netloft
