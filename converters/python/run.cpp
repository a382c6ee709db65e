#include "run.h"

#include <burin/base/error.h>

#include "module.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <string>
#include <thread>
#include <vector>

namespace burin::python {
namespace {

constexpr std::chrono::milliseconds kPoll{20};

struct Request {
  const std::function<void()>& body;
  /// Who is to answer; nullptr = anybody.
  RunId own;
  std::exception_ptr error;
  bool done = false;
};

/// Where code without the GIL leaves what it wants of Python. One for all runs: whoever waits does
/// what is there. Never freed, for threads may outlive static objects.
struct Desk {
  std::mutex mutex;
  std::condition_variable wanted, answered;
  std::vector<Request*> requests;
  int waiters = 0;
};
Desk& desk() {
  static Desk& desk = *new Desk;
  return desk;
}

thread_local RunId t_run = nullptr;

void answer(const std::vector<Request*>& requests) {
  for (Request* request : requests) {
    try {
      request->body();
    } catch (...) {
      request->error = std::current_exception();
    }
  }
  const std::lock_guard lock(desk().mutex);
  for (Request* request : requests) request->done = true;
  desk().answered.notify_all();
}

/// One call of `run`.
class Run {
 public:
  Run(const py::object& progress, const std::shared_ptr<CancelFlag>& cancel)
      : progress_(progress),
        cancel_(cancel),
        context_([this](const std::string& stage, double share) { report(stage, share); }) {
    if (cancel_) cancel_->add(context_);
  }
  ~Run() {
    if (cancel_) cancel_->remove(context_);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  void operator()(const std::function<void(RunContext&)>& work) {
    {
      const py::gil_scoped_release release;
      std::thread worker([&] { do_work(work); });
      wait();
      worker.join();
    }
    // What is said last is the end of the last stage.
    if (!stopped_ && !failed_) call_progress();
    if (stopped_) std::rethrow_exception(stopped_);
    if (failed_) std::rethrow_exception(failed_);
  }

 private:
  void do_work(const std::function<void(RunContext&)>& work) {
    std::exception_ptr error;
    t_run = this;
    try {
      context_.check();
      work(context_);
    } catch (...) {
      error = std::current_exception();
    }
    const std::lock_guard lock(desk().mutex);
    failed_ = error;
    done_ = true;
    desk().wanted.notify_all();
  }

  void report(const std::string& stage, double share) {
    const std::lock_guard lock(progress_mutex_);
    stage_ = stage;
    share_ = share;
    news_ = true;
  }

  void wait() {
    auto next = std::chrono::steady_clock::now() + kPoll;
    std::unique_lock lock(desk().mutex);
    ++desk().waiters;
    while (!done_) {
      std::vector<Request*> requests;
      desk().wanted.wait_until(lock, next, [&] {
        requests = take();
        return done_ || !requests.empty();
      });
      if (done_ && requests.empty()) break;
      lock.unlock();
      const bool poll = std::chrono::steady_clock::now() >= next;
      if (poll || !requests.empty()) {
        const py::gil_scoped_acquire gil;
        if (!requests.empty()) answer(requests);
        if (poll) look();
      }
      if (poll) next = std::chrono::steady_clock::now() + kPoll;
      lock.lock();
    }
    // Requests of other runs that came meanwhile are theirs to answer.
    --desk().waiters;
    if (!desk().requests.empty()) desk().wanted.notify_all();
  }

  /// The requests that this thread may answer; under the desk's mutex.
  std::vector<Request*> take() const {
    auto& all = desk().requests;
    const auto mine = std::stable_partition(all.begin(), all.end(), [this](const Request* r) {
      return r->own != nullptr && r->own != this;
    });
    std::vector<Request*> taken(mine, all.end());
    all.erase(mine, all.end());
    return taken;
  }

  /// With the GIL: signals and progress.
  void look() {
    if (stopped_) return;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      call_progress();
    } catch (...) {
      stopped_ = std::current_exception();
      context_.cancel();
    }
  }

  void call_progress() {
    if (progress_.is_none()) return;
    std::string stage;
    double share = 0;
    {
      const std::lock_guard lock(progress_mutex_);
      if (!news_) return;
      news_ = false;
      stage = stage_;
      share = share_;
    }
    progress_(stage, share);
  }

  py::object progress_;
  std::shared_ptr<CancelFlag> cancel_;
  RunContext context_;
  std::mutex progress_mutex_;
  std::string stage_;
  double share_ = 0;
  bool news_ = false;
  // Under the desk's mutex until the worker has ended.
  bool done_ = false;
  std::exception_ptr failed_;
  std::exception_ptr stopped_;
};

}  // namespace

std::shared_ptr<CancelFlag> cancel_flag(const py::object& cancel) {
  if (!cancel.is_none() && !py::isinstance<CancelFlag>(cancel)) {
    throw py::type_error("argument cancel takes a Cancel");
  }
  return cancel.cast<std::shared_ptr<CancelFlag>>();
}

void run(const py::object& progress, const std::shared_ptr<CancelFlag>& cancel,
         const std::function<void(RunContext&)>& work) {
  if (!progress.is_none() && !PyCallable_Check(progress.ptr())) {
    throw py::type_error("progress takes a function of the stage's name and its share done");
  }
  Run(progress, cancel)(work);
}

RunId this_run() { return t_run; }

void in_python(const std::function<void()>& body, RunId own) {
  Request request{body, own, {}, false};
  {
    std::unique_lock lock(desk().mutex);
    if (desk().waiters > 0) {
      desk().requests.push_back(&request);
      desk().wanted.notify_all();
      desk().answered.wait(lock, [&] { return request.done; });
    }
  }
  if (!request.done) {
    const py::gil_scoped_acquire gil;
    body();
  }
  if (request.error) std::rethrow_exception(request.error);
}

void add_run(py::module_& module) {
  py::class_<CancelFlag, std::shared_ptr<CancelFlag>> cancel(
      module, "Cancel",
      "A flag that ends runs within 0.1 s; may be set from any thread, for good.");
  of_package(cancel)
      .def(py::init<>())
      .def("cancel", &CancelFlag::cancel,
           "Ends the runs that were given this flag, and later ones.")
      .def_property_readonly("cancelled", &CancelFlag::cancelled, "Whether `cancel` was called.");
}

}  // namespace burin::python
