#pragma once
/// States to ThreadSanitizer what a parallel loop orders: all before the loop comes before each of
/// its tasks, and each task before all behind the loop. libtbb, which makes it so, is not compiled
/// with the sanitizer, and TBB's half in headers not either (CMakeLists.txt of this module):
/// without these words every loop would look like a race, and with TBB suppressed no race between
/// two tasks would be told. Nothing in any other build.

#ifdef BURIN_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace burin::detail {

#ifdef BURIN_THREAD_SANITIZER
/// A loop, from its construction to its destruction; of each task too.
class TaskOrder {
 public:
  TaskOrder() { __tsan_release(&begin_); }
  ~TaskOrder() { __tsan_acquire(&end_); }
  TaskOrder(const TaskOrder&) = delete;
  TaskOrder& operator=(const TaskOrder&) = delete;

  class Task {
   public:
    explicit Task(TaskOrder& loop) : loop_(loop) { __tsan_acquire(&loop_.begin_); }
    ~Task() { __tsan_release(&loop_.end_); }
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;

   private:
    TaskOrder& loop_;
  };

 private:
  char begin_ = 0, end_ = 0;
};
#else
struct TaskOrder {
  struct Task {
    explicit Task(const TaskOrder& /*loop*/) {}
  };
};
#endif

}  // namespace burin::detail
