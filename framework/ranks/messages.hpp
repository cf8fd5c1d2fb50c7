// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <mutex>
#include <span>

namespace netloft {

/// How processes of one program talk, numbered from 0; 0 gives orders, all others wait for them. What they
/// talk through (MPI) is not known here. Messages between two of them arrive in the order in which they were
/// sent, and each is received whole: by a span of its own length.
class Messages {
 public:
  virtual ~Messages() = default;
  virtual int rank() const = 0;
  virtual int size() const = 0;
  /// On rank 0: a number for something that all of them will have.
  virtual int next_instance() = 0;
  /// On rank 0: gives all others an order about shares of a scene. They are the caller's until it lets the
  /// lock go.
  virtual std::unique_lock<std::mutex> begin_shares(int instance, int job) = 0;
  virtual void send(int rank, std::span<const std::byte> bytes) = 0;
  virtual void receive(int rank, std::span<std::byte> bytes) = 0;
  /// From rank 0 to all others, each of which calls it with as many bytes.
  virtual void broadcast(std::span<std::byte> bytes) = 0;
};

/// What a rank other than 0 does when it is given an order about shares.
class ServesShares {
 public:
  virtual ~ServesShares() = default;
  virtual void serve(int instance, int job) = 0;
};

}  // namespace netloft
