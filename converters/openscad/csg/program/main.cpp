// burin-csg NODE,NODE,... [THREADS]: reads a tree from descriptor 3 (kChildFile), writes the solids
// of nodes there, and on its output, a line each, "share S WORDS", "say SEVERITY CODE COUNT
// MESSAGE", "input LINE MESSAGE" (the tree asks for what cannot be), "failed MESSAGE". Started by
// csg/child.cpp alone.
#include <burin/base/error.h>
#include <burin/base/parallel.h>
#include <burin/base/version.h>

#include "../exchange.h"
#include "../solids/evaluate.h"
#include "../tree.h"
#include "subprocess.h"

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <string_view>

namespace burin::csg {
namespace {

void say(const std::string& line) {
  std::string one = line;
  for (char& c : one) {
    if (c == '\n') c = ' ';
  }
  one += '\n';
  std::fwrite(one.data(), 1, one.size(), stdout);
  std::fflush(stdout);
}

std::vector<std::uint32_t> numbers(std::string_view list, std::size_t count) {
  std::vector<std::uint32_t> out;
  for (const char* p = list.data(); p < list.data() + list.size();) {
    std::uint32_t n = 0;
    const auto [end, error] = std::from_chars(p, list.data() + list.size(), n);
    if (error != std::errc{} || n >= count) throw UsageError("no such node");
    out.push_back(n);
    p = end + 1;
  }
  return out;
}

/// Told every so often, not every time: the share, and words where what is under way has changed.
class Share {
 public:
  void operator()(double share, const std::string& doing) {
    const auto now = Clock::now();
    const bool other = doing != doing_ && now - said_ > kPause;
    if (share < reported_ + kStep && !other) return;
    reported_ = share;
    doing_ = doing;
    said_ = now;
    say(fmt::format("share {:.4f} {}", share, doing));
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr double kStep = 0.005;
  static constexpr std::chrono::milliseconds kPause{100};
  double reported_ = 0;
  std::string doing_;
  Clock::time_point said_{};
};

void run(const char* list, const char* threads) {
  RunContext context;
  const ThreadLimit limit(std::atoi(threads));
  const Tree tree = parse(read_text(detail::kChildFile), "", context);
  Evaluation e{.tree = tree, .folder = std::filesystem::current_path(), .run = context};
  Share share;
  const std::vector<std::uint32_t> nodes = numbers(list, tree.nodes.size());
  const auto solids = evaluate(e, nodes, [&](double s) { share(s, e.doing); });
  for (const Diagnostic& d : e.diagnostics.entries()) {
    say(fmt::format("say {} {} {} {}", to_string(d.severity), d.code, d.count, d.message));
  }
  write_solids(detail::kChildFile, solids);
}

}  // namespace
}  // namespace burin::csg

int main(int argc, char** argv) {
  using namespace burin;
  if (argc != 2 && argc != 3) {
    std::fprintf(stderr, "burin-csg %s: started by burin, not by hand\n", version());
    return 2;
  }
  try {
    csg::run(argv[1], argc > 2 ? argv[2] : "0");
    return 0;
  } catch (const InputError& error) {
    csg::say(fmt::format("input {} {}", error.line(), error.what()));
  } catch (const std::bad_alloc&) {
    csg::say("failed not enough memory for its solids");
  } catch (const std::exception& error) {
    csg::say(fmt::format("failed {}", error.what()));
  }
  return 1;
}
