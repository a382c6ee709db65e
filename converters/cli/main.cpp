/// The command `burin`.

#include <burin/base/error.h>
#include <burin/base/run_context.h>
#include <burin/converters/load_plugins.h>

#include "arguments.h"
#include "batch_job.h"
#include "console.h"
#include "convert.h"
#include "diff.h"
#include "draw.h"
#include "illustrate.h"
#include "info.h"
#include "options.h"
#include "plugins.h"
#include "python_module.h"
#include "report.h"
#include "signals.h"
#include "steps.h"
#include "styles.h"
#include "watch.h"

#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace burin::cli {
namespace {

void print(const std::string& text) { std::fwrite(text.data(), 1, text.size(), stdout); }

/// Whether nobody reads on, as behind `| head`: that is no error of a text.
bool reader_is_gone() {
  pollfd out{STDOUT_FILENO, 0, 0};
  return ::poll(&out, 1, 0) == 1 && (out.revents & POLLERR) != 0;
}

void check_printed() {
  if ((std::fflush(stdout) != 0 || std::ferror(stdout)) && !reader_is_gone()) {
    throw OutputError("cannot be written", "standard output");
  }
}

int run(const Arguments& arguments, RunContext& context, Console& console) {
  switch (arguments.verb) {
    case Verb::Help:
      print(arguments.help);
      break;
    case Verb::Draw:
      run_draw(arguments.draw, context, console);
      break;
    case Verb::Watch:
      run_watch(arguments.draw, context, console);
      break;
    case Verb::Illustrate:
      run_illustrate(arguments.illustrate, context, console);
      break;
    case Verb::Steps:
      run_steps(arguments.steps, context, console);
      break;
    case Verb::Diff: {
      const int status = run_diff(arguments.diff, context, console);
      check_printed();
      return status;
    }
    case Verb::Batch:
      if (arguments.words == std::vector<std::string>{"job"}) {
        run_batch_job(context);
        break;
      }
      become_python("batch", arguments.words);
    case Verb::Book:
      become_python("book", arguments.words);
    case Verb::Convert:
      run_convert(arguments.convert, context, console);
      break;
    case Verb::Info: {
      if (arguments.info.inputs.empty()) {
        throw UsageError("no input; name model files: burin info INPUT...");
      }
      InfoOptions options;
      options.inputs.assign(arguments.info.inputs.begin(), arguments.info.inputs.end());
      options.json = arguments.info.json;
      options.read = make_read_options(arguments.info.read, Spelling::Options);
      const int status = run_info(options, context);
      check_printed();
      return status;
    }
    case Verb::Styles:
      print(run_styles(arguments.styles));
      break;
    case Verb::Options:
      print(run_options(arguments.options));
      break;
    case Verb::Plugins:
      print(run_plugins(arguments.plugins));
      break;
  }
  check_printed();
  return kDone;
}

int main_of(int argc, const char* const* argv) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  std::string input;
  try {
    // Options and help tell those of plug-ins, too.
    load_plugins(argc > 1 && std::string_view(argv[1]) == "plugins");
    const Arguments arguments = parse_arguments(argc, argv);
    const auto& inputs = arguments.verb == Verb::Info    ? arguments.info.inputs
                         : arguments.verb == Verb::Steps ? arguments.steps.draw.inputs
                         : arguments.verb == Verb::Diff  ? arguments.diff.draw.inputs
                                                         : arguments.draw.inputs;
    if (inputs.size() == 1) input = inputs.front();
    if (arguments.verb == Verb::Convert) input = arguments.convert.input;
    Console console(arguments.chatter);
    RunContext context([&](const std::string& stage, double share) {
      console.progress(stage, share, context.doing());
    });
    const signals::Handlers handlers(context);
    const int status = run(arguments, context, console);
    signals::finish();
    if (arguments.verb == Verb::Draw || arguments.verb == Verb::Steps ||
        arguments.verb == Verb::Diff || arguments.verb == Verb::Convert) {
      console.stages(context, std::chrono::duration<double>(Clock::now() - start).count());
    }
    return status;
  } catch (...) {
    return report(input);
  }
}

}  // namespace
}  // namespace burin::cli

int main(int argc, char** argv) { return burin::cli::main_of(argc, argv); }
