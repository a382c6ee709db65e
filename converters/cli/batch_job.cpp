#include "batch_job.h"

#include <burin/base/error.h>
#include <burin/base/input_files.h>
#include <burin/base/version.h>
#include <burin/converters/messages.h>
#include <burin/converters/output.h>

#include "draw.h"
#include "report.h"
#include "signals.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/prctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <string>
#include <utility>
#include <vector>

namespace burin::cli {
namespace {

using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

struct JobDrawing {
  Request options;
  std::vector<std::string> outputs;
};

struct Job {
  std::vector<std::string> inputs;
  std::vector<JobDrawing> drawings;
  std::string threads;
  bool check = false;
};

/// Standard output for our own lines alone: what a library prints goes to standard error.
class Answers {
 public:
  Answers() : descriptor_(::dup(STDOUT_FILENO)) {
    if (descriptor_ < 0 || ::dup2(STDERR_FILENO, STDOUT_FILENO) < 0) fail();
  }
  ~Answers() { ::close(descriptor_); }
  Answers(const Answers&) = delete;
  Answers& operator=(const Answers&) = delete;

  void say(const Json& answer) const {
    // Names of files may be no UTF-8.
    const std::string line = answer.dump(-1, ' ', true, Json::error_handler_t::replace) + "\n";
    for (std::size_t done = 0; done < line.size();) {
      const ssize_t n = ::write(descriptor_, line.data() + done, line.size() - done);
      if (n < 0 && errno != EINTR) fail();
      if (n > 0) done += static_cast<std::size_t>(n);
    }
  }

 private:
  [[noreturn]] static void fail() { throw OutputError("cannot be written", "standard output"); }

  int descriptor_;
};

std::string all_of_stdin() {
  std::string text;
  std::array<char, 1 << 14> block;
  for (;;) {
    const ssize_t n = ::read(STDIN_FILENO, block.data(), block.size());
    if (n == 0) return text;
    if (n > 0) text.append(block.data(), static_cast<std::size_t>(n));
    if (n < 0 && errno != EINTR) throw InputError("cannot be read", "standard input");
  }
}

JobDrawing read_drawing(const Json& json) {
  JobDrawing drawing;
  drawing.options = json.at("options").get<Request>();
  drawing.outputs = json.at("outputs").get<std::vector<std::string>>();
  for (const Json& list : json.value("lists", Json::array())) {
    drawing.options["parts_list"].push_back(list.get<std::string>());
  }
  return drawing;
}

Job read_job(const std::string& text) {
  try {
    const Json json = Json::parse(text);
    Job job;
    job.inputs = json.at("inputs").get<std::vector<std::string>>();
    job.threads = std::to_string(json.value("threads", 1));
    job.check = json.value("check", false);
    for (const Json& drawing : json.at("drawings")) job.drawings.push_back(read_drawing(drawing));
    return job;
  } catch (const Json::exception& e) {
    throw UsageError(
        fmt::format("burin batch job reads a job as JSON from standard input, which "
                    "burin batch run writes: {}",
                    e.what()));
  }
}

/// Rows do not look at options that they do not know.
void check_names(const Request& options) {
  for (const auto& [name, texts] : options) {
    find_option(all_options(), name);
    if (texts.empty()) throw UsageError(called(name, Spelling::Options) + " has no value");
  }
}

Json files_of(const InputFiles::Stamps& stamps) {
  Json files = Json::array();
  for (const auto& [name, stamp] : stamps) {
    Json known = nullptr;
    if (stamp.there) {
      known = Json::array({stamp.device, stamp.node, stamp.size, stamp.changed, stamp.renewed});
    }
    files.push_back(Json::array({name, known}));
  }
  return files;
}

Json diagnostics_of(const Diagnostics& diagnostics) {
  Json all = Json::array();
  for (const Diagnostic& d : diagnostics.entries()) {
    Json one = Json::object();
    one["severity"] = to_string(d.severity);
    one["code"] = d.code;
    one["message"] = d.message;
    all.push_back(std::move(one));
  }
  return all;
}

Json failed(const Failure& failure) {
  Json error = Json::object();
  error["kind"] = failure.kind;
  error["message"] = failure.message;
  return error;
}

void check(const JobDrawing& drawing) {
  DrawRequest request;
  request.options = drawing.options;
  make_plan(request, Spelling::Options);
  plan_outputs(drawing.outputs, "", {});
}

/// The messages about a drawing that has ended.
Json answer_of(const Job& job, const JobDrawing& drawing, KeptScene& kept, const Answers& answers) {
  const Clock::time_point start = Clock::now();
  const InputFiles read;
  std::string last;
  RunContext context([&](const std::string& stage, double) {
    if (stage == last) return;
    last = stage;
    answers.say(Json::object({{"stage", stage}}));
  });
  const signals::Turn turn(context);
  Json answer = Json::object();
  try {
    check_names(drawing.options);
    if (job.check) {
      check(drawing);
    } else {
      DrawArguments arguments;
      arguments.inputs = job.inputs;
      arguments.outputs = drawing.outputs;
      arguments.request.options = drawing.options;
      arguments.request.options["threads"] = {job.threads};
      answer["diagnostics"] = diagnostics_of(draw_files(arguments, context, &kept).diagnostics);
    }
  } catch (const Cancelled&) {
    throw;
  } catch (...) {
    answer["error"] = failed(failure_of(job.inputs.size() == 1 ? job.inputs.front() : ""));
  }
  answer["files"] = files_of(read.stamps());
  answer["seconds"] = std::chrono::duration<double>(Clock::now() - start).count();
  return answer;
}

}  // namespace

void run_batch_job(RunContext& context) {
  // Who kills the batch wants no drawings that go on. A parent that is gone by now has closed
  // standard input, and what it wrote is no whole job.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  const Answers answers;
  const Job job = read_job(all_of_stdin());
  answers.say(Json::object({{"version", version()}}));
  KeptScene kept;
  kept.illustrations = true;
  for (std::size_t i = 0; i < job.drawings.size(); ++i) {
    context.check();
    answers.say(Json::object({{"drawing", i}}));
    Json answer = answer_of(job, job.drawings[i], kept, answers);
    answer["drawing"] = i;
    answers.say(answer);
  }
  answers.say(Json::object({{"done", true}}));
}

}  // namespace burin::cli
