// SPDX-License-Identifier: BSD-3-Clause
#include "io/python/module/background.hpp"

#include "io/python/module/opened_scene.hpp"
#include "io/python/module/python_plugin.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace netloft::python {

namespace py = pybind11;

namespace {

// Python handles a signal only if somebody asks, and an answer is wanted within 0.2 s.
constexpr std::chrono::milliseconds kBetweenQuestions{20};

/// Discards an exception that a component in Python raised in this thread and nobody has fetched.
void forget_error() {
  std::exception_ptr error = take_error();
  if (!error) return;
  const py::gil_scoped_acquire interpreter;  // needed when exceptions of Python are destroyed
  error = nullptr;
}

/// A thread that works once.
class Worker {
 public:
  explicit Worker(const std::function<void(std::atomic<bool>&)>& work)
      : thread_([this, &work, may_read = ReadingLock::is_held_here()] {
          const LentReading lent(may_read);
          try {
            work(interrupt_);
          } catch (...) {
            fault_ = std::current_exception();
          }
          forget_error();
          const std::lock_guard lock(mutex_);
          is_done_ = true;
          done_.notify_one();
        }) {}
  ~Worker() {
    if (thread_.joinable()) thread_.join();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Waits for a moment. Returns whether the work has ended.
  bool wait() {
    std::unique_lock lock(mutex_);
    return done_.wait_for(lock, kBetweenQuestions, [this] { return is_done_; });
  }
  void interrupt() { interrupt_ = true; }
  void finish() {
    thread_.join();
    if (fault_) std::rethrow_exception(fault_);
  }

 private:
  std::atomic<bool> interrupt_ = false;
  std::mutex mutex_;
  std::condition_variable done_;
  bool is_done_ = false;
  std::exception_ptr fault_;
  std::thread thread_;  // the last member, because the thread uses the others
};

/// The exception that a signal handler has raised since the last call; nullptr if there is none.
std::exception_ptr raised_by_signals() {
  if (PyErr_CheckSignals() == 0) return nullptr;
  try {
    throw py::error_already_set();
  } catch (...) {
    return std::current_exception();
  }
}

}  // namespace

std::exception_ptr call_in_background(const std::function<void(std::atomic<bool>&)>& work) {
  std::exception_ptr raised;
  Worker worker(work);
  for (bool is_done = false; !is_done;) {
    {
      const py::gil_scoped_release others_may_run;
      is_done = worker.wait();
    }
    if (raised) continue;
    raised = raised_by_signals();
    if (raised) worker.interrupt();
  }
  worker.finish();
  return raised;
}

}  // namespace netloft::python
