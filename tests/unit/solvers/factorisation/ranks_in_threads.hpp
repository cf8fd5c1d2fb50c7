// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "framework/ranks/share_server.hpp"
#include "solvers/factorisation/ranks.hpp"
#include "tests/folders.hpp"

namespace netloft::test {

/// Ranks that are threads of this process, with queues for messages instead of MPI; without MUMPS. One at a
/// time.
class RanksInThreads {
 public:
  explicit RanksInThreads(int size) {
    post() = std::make_unique<Post>();
    post()->size = size;
    for (int rank = 1; rank < size; ++rank)
      servers_.emplace_back([rank, size] {
        own_rank() = rank;
        Ranks ranks(kModule, Launch{rank, size, true});
        ShareServer shares(ranks, [](Registry& registry) { registry.add_folder(plugin_folder()); });
        ranks.serve(&shares);
      });
    first_ = std::make_unique<Ranks>(kModule, Launch{0, size, true});
  }
  ~RanksInThreads() {
    first_.reset();
    for (std::thread& server : servers_) server.join();
  }
  Ranks& first() { return *first_; }

  /// Messages that have come and that nobody has taken.
  static std::size_t unread() {
    std::size_t all = 0;
    for (const auto& [way, messages] : post()->messages) all += messages.size();
    return all;
  }

 private:
  struct Post {
    int size = 1;
    std::mutex mutex;
    std::condition_variable arrival;
    std::map<std::pair<int, int>, std::deque<std::vector<char>>> messages;
    std::map<int, std::deque<RanksOrder>> orders;
  };
  static std::unique_ptr<Post>& post() {
    static std::unique_ptr<Post> post;
    return post;
  }
  static int& own_rank() {
    thread_local int rank = 0;
    return rank;
  }

  static const char* start(int* rank, int* size) {
    *rank = own_rank(), *size = post()->size;
    return nullptr;
  }
  static void give(const RanksOrder* order) {
    const std::lock_guard lock(post()->mutex);
    for (int rank = 1; rank < post()->size; ++rank) post()->orders[rank].push_back(*order);
    post()->arrival.notify_all();
  }
  static void wait(RanksOrder* order) {
    std::unique_lock lock(post()->mutex);
    auto& orders = post()->orders[own_rank()];
    post()->arrival.wait(lock, [&] { return !orders.empty(); });
    *order = orders.front();
    orders.pop_front();
  }
  static void send(int rank, const void* bytes, std::size_t count) {
    const std::lock_guard lock(post()->mutex);
    const char* from = static_cast<const char*>(bytes);
    post()->messages[{own_rank(), rank}].emplace_back(from, from + count);
    post()->arrival.notify_all();
  }
  static void receive(int rank, void* bytes, std::size_t count) {
    std::unique_lock lock(post()->mutex);
    auto& way = post()->messages[{rank, own_rank()}];
    post()->arrival.wait(lock, [&] { return !way.empty(); });
    if (way.front().size() != count) std::abort();  // as MPI may
    std::copy(way.front().begin(), way.front().end(), static_cast<char*>(bytes));
    way.pop_front();
  }
  static void broadcast(void* bytes, std::size_t count) {
    if (own_rank() > 0) return receive(0, bytes, count);
    for (int rank = 1; rank < post()->size; ++rank) send(rank, bytes, count);
  }
  static void run_mumps(const RanksOrder*, void*) {}

  static constexpr RanksModule kModule{"none", 0, start, give, wait, run_mumps, send, receive, broadcast};
  std::vector<std::thread> servers_;
  std::unique_ptr<Ranks> first_;
};

}  // namespace netloft::test
