#include "outputs.h"

#include "signals.h"

#include <algorithm>
#include <ostream>
#include <utility>

namespace burin::cli {

std::vector<Output> make_outputs(std::vector<std::string> names, const std::string& format,
                                 const std::vector<std::string>& sources) {
  std::stable_partition(names.begin(), names.end(),
                        [](const std::string& name) { return name != "-"; });
  return plan_outputs(names, format, sources);
}

Diagnostics write_outputs(std::vector<Output>& outputs, const Drawing& drawing,
                          WriteOptions options, RunContext& context) {
  return write_outputs(outputs, std::move(options), context,
                       [&](const Output& output, const WriteOptions& how, std::ostream& out) {
                         write_drawing(drawing, output.format(), how, out, context);
                       });
}

Diagnostics write_outputs(
    std::vector<Output>& outputs, WriteOptions options, RunContext& context,
    const std::function<void(const Output&, const WriteOptions&, std::ostream&)>& write) {
  Diagnostics reported;
  options.report = [&](const Diagnostic& one) { reported.add(one); };
  context.begin_stage(RunStage::Write);
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const auto done = static_cast<double>(i), all = static_cast<double>(outputs.size());
    options.progress = [&](double share) { context.progress((done + share) / all); };
    outputs[i].write([&](std::ostream& out) { write(outputs[i], options, out); });
    options.progress(1);
  }
  context.check();
  signals::finish();
  for (Output& output : outputs) output.commit();
  context.end_stage();
  return reported;
}

}  // namespace burin::cli
