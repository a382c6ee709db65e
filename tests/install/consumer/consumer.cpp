// Draws an assembly taken apart and numbered, and cut open: consumer MODEL FOLDER
#include <burin/burin.h>
#include <burin/io.h>

#include <cstdio>
#include <exception>
#include <string>

using namespace burin;

namespace {

/// Draws as `burin draw` does with these options, named with underscores; NAME.svg and NAME.pdf.
void draw_files(const ReadResult& model, const Request& options, const std::string& name,
                RunContext& run) {
  auto [scene, plan] = plan_scene({.given = model}, {.options = options}, Spelling::Keywords, run);
  arrange_parts(scene, plan, run);
  const Drawing drawing = draw(scene, plan_sheet(scene, plan), plan, run);
  for (const char* suffix : {".svg", ".pdf"}) {
    write_file(drawing, name + suffix, write_options(plan.style), run);
  }
  for (const Diagnostic& told : drawing.diagnostics.entries()) std::puts(told.message.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fputs("consumer MODEL FOLDER\n", stderr), 2;
  try {
    RunContext run;
    const ReadResult model = read_files({argv[1]}, {}, run);
    const std::string folder = argv[2];
    draw_files(model, {{"explode", {"auto"}}, {"callouts", {"true"}}, {"style", {"outline"}}},
               folder + "/apart", run);
    draw_files(model, {{"view", {"front"}}, {"section", {"y"}}, {"callouts", {"true"}}},
               folder + "/cut", run);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "consumer: %s\n", error_message(e, Spelling::Keywords).c_str());
    return 1;
  }
}
