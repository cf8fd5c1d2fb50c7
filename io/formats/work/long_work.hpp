// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <exception>
#include <string_view>

namespace netloft::formats {

/// A step of long work, for a line of progress such as "meshing belly, 1200 nodes".
struct Step {
  std::string_view deed, of;
  std::size_t done = 0;
  std::string_view unit = {};  // empty: nothing is counted
};

/// Thrown when the user interrupts long work. A function that already has results catches it.
struct Interrupted : std::exception {
  const char* what() const noexcept override { return "interrupted"; }
};

/// Follows the long work of this process: shows its progress, and ends it by throwing Interrupted.
class WorkFollower {
 public:
  virtual ~WorkFollower() = default;
  virtual void at(const Step& step) = 0;
  virtual void hear() = 0;
  virtual void end() noexcept = 0;
};

/// Sets the follower of all long work in this thread, and returns the previous one; nullptr: no follower.
WorkFollower* follow_work(WorkFollower* follower);

/// Marks work that may take long, such as reading a scene. The work begins with the step `first` and ends
/// with this object. Nested work is a part of the outer work.
class LongWork {
 public:
  explicit LongWork(const Step& first);
  ~LongWork();
  LongWork(const LongWork&) = delete;
  LongWork& operator=(const LongWork&) = delete;
};

/// Reports a step of the current work to the follower, if there is one and if work has begun. Throws
/// Interrupted if the work has to end.
void report(const Step& step);
/// Throws Interrupted if the work has to end. For calls within a step that takes long.
void hear_interruption();

}  // namespace netloft::formats
