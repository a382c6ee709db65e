#include <burin/base/error.h>
#include <burin/converters/plan.h>
#include <burin/converters/read.h>

#include "make_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace burin {

DrawInputs find_inputs(const std::vector<std::string>& files) {
  const auto found =
      std::ranges::find_if(files, [](const std::string& file) { return is_illustration(file); });
  if (found == files.end()) {
    check_inputs(files);
    return {.files = files};
  }
  if (files.size() > 1) {
    throw UsageError(fmt::format(
        "'{}' is an illustration file, which is drawn alone: name the others in its \"parts\"",
        *found));
  }
  return {.files = files, .illustration = read_illustration(*found)};
}

DrawTask::DrawTask(DrawInputs inputs, const DrawRequest& request, Spelling spelling)
    : inputs_(std::move(inputs)),
      request_(inputs_.illustration ? merged(inputs_.illustration->request, request) : request),
      own_looks_(inputs_.illustration.has_value()) {
  plan = detail::plan_of(request_, inputs_.part_styles, spelling);
  if (inputs_.illustration && !plan.read.given.empty()) {
    throw UsageError(plan.read.given.front().spelled +
                     " is about reading: in an illustration it belongs to a part, {\"file\": ...}");
  }
}

ReadResult DrawTask::read(RunContext& context) const {
  if (inputs_.given) return *inputs_.given;
  if (inputs_.illustration) return {read_scene(*inputs_.illustration, context)};
  return read_files(inputs_.files, plan.read, context);
}

Scene DrawTask::follow(ReadResult read) {
  if (!read.marks.empty()) {
    detail::follow_marks(read.marks, request_, plan);
    own_looks_ = true;
  }
  return std::move(read.scene);
}

PlannedScene plan_scene(DrawInputs inputs, const DrawRequest& request, Spelling spelling,
                        RunContext& context) {
  DrawTask task(std::move(inputs), request, spelling);
  Scene scene = task.follow(task.read(context));
  return {std::move(scene), std::move(task.plan)};
}

}  // namespace burin
