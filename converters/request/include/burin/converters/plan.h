#pragma once
/// From what is asked to a scene and the plan of its drawing: one way for the command line, Python,
/// FreeCAD, batches and other programs.

#include <burin/base/run_context.h>
#include <burin/converters/illustration.h>
#include <burin/converters/read_result.h>
#include <burin/converters/request.h>

#include <optional>
#include <string>
#include <vector>

namespace burin {

/// What is drawn.
struct DrawInputs {
  /// As the user named them: models, or an illustration alone. `find_inputs` has looked whether
  /// they are there.
  std::vector<std::string> files = {};
  /// Instead of models: what the illustration says.
  std::optional<IllustrationFile> illustration = {};
  /// Instead of both: what a program has read or made itself, and how its parts are drawn.
  std::optional<ReadResult> given = {};
  std::vector<PartStyle> part_styles = {};
};

/// What files are. Reads an illustration, no models. Throws UsageError where an illustration is not
/// alone; as `check_inputs`; as `read_illustration`.
DrawInputs find_inputs(const std::vector<std::string>& files);

/// A drawing that is asked for. Its plan is made once, before anything is read, so that a wrong
/// request costs no time; what the files that are read ask of the drawing goes below it.
class DrawTask {
 public:
  /// Throws as `make_plan`; UsageError where options about reading are asked of an illustration,
  /// whose parts have them.
  DrawTask(DrawInputs inputs, const DrawRequest& request, Spelling spelling);

  const DrawInputs& inputs() const { return inputs_; }
  /// Reads the inputs. Throws as `read_files`. May be called again.
  ReadResult read(RunContext& context) const;
  /// The scene of what was read, here or by another task with the same inputs. What marks in the
  /// models ask is added to the plan, where the request asks nothing else. Throws UsageError that
  /// names the model. Once.
  Scene follow(ReadResult read);
  /// Whether the inputs say how they look: an illustration, or models with marks, once followed.
  bool has_own_looks() const { return own_looks_; }

  /// Programs may change it.
  DrawPlan plan;

 private:
  DrawInputs inputs_;
  DrawRequest request_;
  bool own_looks_ = false;
};

/// What is drawn, and how.
struct PlannedScene {
  Scene scene;
  DrawPlan plan;
};

/// All of it: makes the plan, reads, follows. Throws as `DrawTask`.
PlannedScene plan_scene(DrawInputs inputs, const DrawRequest& request, Spelling spelling,
                        RunContext& context);

}  // namespace burin
