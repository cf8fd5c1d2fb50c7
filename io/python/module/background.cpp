// SPDX-License-Identifier: BSD-3-Clause
#include "io/python/module/background.hpp"

#include "io/python/module/opened_scene.hpp"
#include "io/python/module/python_plugin.hpp"

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>

namespace netloft::python {

namespace py = pybind11;

namespace {

// Python handles signals only when asked. It is asked so often that a signal is answered within 0.2 s.
constexpr std::chrono::milliseconds kBetweenQuestions{20};
// Time for which an interrupted call waits: with kBetweenQuestions, half of the 0.2 s. Most steps of a search
// are shorter, so that the shape is there when the call ends.
constexpr std::chrono::milliseconds kPatience{80};

/// Counts threads whose work was left.
struct LeftWork {
  std::mutex mutex;
  std::condition_variable changed;
  int count = 0;
  void add(int difference) {
    const std::lock_guard lock(mutex);
    count += difference;
    changed.notify_all();
  }
};

LeftWork& left_work() {
  static LeftWork& all = *new LeftWork;  // never destroyed: threads may outlive the interpreter
  return all;
}

/// Discards an exception that a component in Python raised in this thread and that no caller has fetched.
void forget_error() {
  std::exception_ptr error = take_error();
  if (!error) return;
  const py::gil_scoped_acquire interpreter;  // needed when exceptions of Python are destroyed
  error = nullptr;
}

/// A thread that does one piece of work.
class Worker : public std::enable_shared_from_this<Worker> {
 public:
  explicit Worker(const std::function<void(std::atomic<bool>&)>& work)
      : work_(work), may_read_(ReadingLock::is_held_here()), thread_([this] { run(); }) {}
  ~Worker() {
    if (thread_.joinable()) thread_.join();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Waits for a moment. Returns whether the work has ended.
  bool wait() { return wait(kBetweenQuestions); }
  bool wait(std::chrono::milliseconds moment) {
    std::unique_lock lock(mutex_);
    return done_.wait_for(lock, moment, [this] { return is_done_; });
  }
  void wait_to_the_end() {
    std::unique_lock lock(mutex_);
    done_.wait(lock, [this] { return is_done_; });
  }
  /// Leaves the work to its thread, which then owns this object. Returns whether the work still goes on. Work
  /// that uses the reading lock of the thread that waits for it cannot be left.
  bool leave() {
    const std::lock_guard lock(mutex_);
    if (is_done_ || may_read_) return false;
    left_work().add(1);
    self_ = shared_from_this();
    thread_.detach();
    return true;
  }
  void interrupt() { interrupt_ = true; }
  void finish() {
    thread_.join();
    if (fault_) std::rethrow_exception(fault_);
  }

 private:
  void run() {
    {
      const LentReading lent(may_read_);
      try {
        work_(interrupt_);
      } catch (...) {
        fault_ = std::current_exception();
      }
      forget_error();
    }
    std::shared_ptr<Worker> self;
    {
      const std::lock_guard lock(mutex_);
      is_done_ = true;
      self = std::move(self_);
      done_.notify_all();
    }
    if (!self) return;
    self.reset();
    left_work().add(-1);
  }

  std::function<void(std::atomic<bool>&)> work_;
  bool may_read_;  // whether the work may read scenes with the lock of the waiting thread
  std::atomic<bool> interrupt_ = false;
  std::mutex mutex_;
  std::condition_variable done_;
  bool is_done_ = false;
  std::exception_ptr fault_;
  std::shared_ptr<Worker> self_;  // this object, if its work was left
  std::thread thread_;            // the last member, because the thread uses the others
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

/// Waits for the end of the work, or for a signal whose handler raises an exception; then interrupts the work
/// and returns the exception.
std::exception_ptr wait_for_end_or_signal(Worker& worker) {
  for (bool is_done = false; !is_done;) {
    {
      const py::gil_scoped_release others_may_run;
      is_done = worker.wait();
    }
    if (auto raised = raised_by_signals()) {
      worker.interrupt();
      return raised;
    }
  }
  return nullptr;
}

void wait_without_interpreter(Worker& worker) {
  const py::gil_scoped_release others_may_run;
  worker.wait_to_the_end();
}

}  // namespace

std::exception_ptr call_in_background(const std::function<void(std::atomic<bool>&)>& work) {
  Worker worker(work);
  const std::exception_ptr raised = wait_for_end_or_signal(worker);
  wait_without_interpreter(worker);
  worker.finish();
  return raised;
}

EndOfWork call_or_leave(const std::function<void(std::atomic<bool>&)>& work) {
  const auto worker = std::make_shared<Worker>(work);
  EndOfWork end{wait_for_end_or_signal(*worker), {}};
  if (!end.raised) {
    worker->finish();
    return end;
  }
  bool is_done;
  {
    const py::gil_scoped_release others_may_run;
    is_done = worker->wait(kPatience);
  }
  if (!is_done && worker->leave())
    end.finish = [worker] { wait_without_interpreter(*worker); };
  else
    wait_without_interpreter(*worker);
  return end;
}

void finish_left_work() {
  const py::gil_scoped_release others_may_run;
  LeftWork& left = left_work();
  std::unique_lock lock(left.mutex);
  left.changed.wait(lock, [&] { return left.count == 0; });
}

}  // namespace netloft::python
