// SPDX-License-Identifier: BSD-3-Clause
//
// MPI and parallel MUMPS as a module of their own: see ranks_module.hpp.
#include "solvers/factorisation/ranks_module.hpp"

#include <dmumps_c.h>
#include <malloc.h>
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <memory>
#include <thread>

namespace {

using netloft::RanksOrder;

constexpr int kNumbers = sizeof(RanksOrder) / sizeof(int), kBegin = -1, kEnd = -2;

MPI_Comm orders = MPI_COMM_NULL, work = MPI_COMM_NULL, messages = MPI_COMM_NULL;
std::map<int, std::unique_ptr<DMUMPS_STRUC_C>> instances;  // on ranks other than 0

/// Registered before anything that may use MPI registers an end of its own, so it comes last.
void finish() {
  int is_over = 0;
  MPI_Finalized(&is_over);
  if (!is_over) MPI_Finalize();
}

/// MUMPS allocates afresh in every factorisation. What it frees stays in the process: large blocks by mmap,
/// given back and cleared each time, make a factorisation of 10⁵ unknowns take twice as long.
void keep_freed_memory() {
#if defined(__GLIBC__)
  constexpr int kNever = 0, kNoTrimming = -1;
  mallopt(M_MMAP_MAX, kNever), mallopt(M_TRIM_THRESHOLD, kNoTrimming);
#endif
}

const char* start(int* rank, int* size) {
  keep_freed_memory();
  setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);  // a process without launcher needs no daemon
  int is_running = 0, threads = MPI_THREAD_SINGLE;
  MPI_Initialized(&is_running);
  if (!is_running) {
    if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &threads) != MPI_SUCCESS)
      return "MPI does not start";
    std::atexit(finish);
    if (threads < MPI_THREAD_SERIALIZED) return "this MPI cannot be called from several threads by turns";
  }
  MPI_Comm_rank(MPI_COMM_WORLD, rank), MPI_Comm_size(MPI_COMM_WORLD, size);
  for (MPI_Comm* one : {&orders, &work, &messages}) MPI_Comm_dup(MPI_COMM_WORLD, one);
  return nullptr;
}

void run(DMUMPS_STRUC_C& mumps) {
  if (mumps.job == kBegin) mumps.comm_fortran = static_cast<MUMPS_INT>(MPI_Comm_c2f(work));
  dmumps_c(&mumps);
  if (mumps.job == kBegin) std::fill_n(mumps.icntl, 4, 0);  // silent on every rank
}

/// MPI waits by asking again and again; a rank without work leaves the processor to others, and sleeps until
/// has_come() says so. Each sleep is an eighth longer than the one before, so that a rank is late by about an
/// eighth of the time it has waited.
template <class HasCome>
void sleep_until(const HasCome& has_come) {
  constexpr std::chrono::nanoseconds kShortest = std::chrono::microseconds(20),
                                     kLongest = std::chrono::milliseconds(1);
  constexpr int kLater = 8;
  for (auto pause = kShortest; !has_come(); pause = std::min(pause + pause / kLater, kLongest))
    std::this_thread::sleep_for(pause);
}

/// Matches wait(): MPI_Bcast would not.
void give(const RanksOrder* order) {
  RanksOrder copy = *order;
  MPI_Request request;
  MPI_Ibcast(&copy, kNumbers, MPI_INT, 0, orders, &request);
  MPI_Wait(&request, MPI_STATUS_IGNORE);
}

void wait(RanksOrder* order) {
  MPI_Request request;
  MPI_Ibcast(order, kNumbers, MPI_INT, 0, orders, &request);
  sleep_until([&] {
    int has_come = 0;
    MPI_Test(&request, &has_come, MPI_STATUS_IGNORE);
    return has_come;
  });
}

void run_mumps(const RanksOrder* order, void* structure) {
  if (structure) return run(*static_cast<DMUMPS_STRUC_C*>(structure));
  auto& mumps = instances[order->instance];
  if (!mumps) mumps = std::make_unique<DMUMPS_STRUC_C>();
  mumps->job = order->job, mumps->sym = order->symmetry, mumps->par = 1;
  run(*mumps);
  if (order->job == kEnd) instances.erase(order->instance);
}

/// Calls move(bytes, count) for pieces that MPI can count.
template <class Byte, class Move>
void in_pieces(Byte* bytes, std::size_t count, const Move& move) {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  for (; count > 0; bytes += std::min(count, kMost), count -= std::min(count, kMost))
    move(bytes, static_cast<int>(std::min(count, kMost)));
}

void send(int rank, const void* bytes, std::size_t count) {
  in_pieces(static_cast<const char*>(bytes), count,
            [&](const char* from, int size) { MPI_Send(from, size, MPI_BYTE, rank, 0, messages); });
}

/// Once a message has begun to come, MPI moves it piece by piece whenever it is asked: no sleep then.
void receive(int rank, void* bytes, std::size_t count) {
  in_pieces(static_cast<char*>(bytes), count, [&](char* to, int size) {
    sleep_until([&] {
      int has_come = 0;
      MPI_Iprobe(rank, 0, messages, &has_come, MPI_STATUS_IGNORE);
      return has_come;
    });
    MPI_Recv(to, size, MPI_BYTE, rank, 0, messages, MPI_STATUS_IGNORE);
  });
}

/// All have their order, and come at once.
void broadcast(void* bytes, std::size_t count) {
  in_pieces(static_cast<char*>(bytes), count,
            [](char* piece, int size) { MPI_Bcast(piece, size, MPI_BYTE, 0, messages); });
}

constexpr netloft::RanksModule kModule{
    MUMPS_VERSION, sizeof(DMUMPS_STRUC_C), start, give, wait, run_mumps, send, receive, broadcast};

}  // namespace

extern "C" [[gnu::visibility("default")]] const netloft::RanksModule* netloft_ranks_v3() { return &kModule; }
