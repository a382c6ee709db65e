#pragma once
/// What has changed between two revisions, as front ends ask for it and report it.

#include <burin/converters/plan.h>
#include <burin/converters/write_difference.h>
#include <burin/diff/difference.h>
#include <burin/revisions/line_changes.h>

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace burin {

/// A revision as it was read, and how the front end and its own file want it drawn.
struct Revision {
  Scene scene;
  DrawPlan plan;
  /// Of its files, for titles.
  std::string name;
  /// Whether its plan has looks of its own, of an illustration or a model file that says some: then
  /// selectors name its parts, else those of both revisions.
  bool own_looks = false;
};

/// Reads and follows a task. Callouts that only marks of the model ask for are not asked of a
/// drawing of two revisions. Throws as `DrawTask`.
Revision read_revision(DrawTask& task, std::string name, RunContext& context);

/// What came out: of models `models`, of drawings `lines`.
struct DiffOutcome {
  bool same = true;
  std::optional<Difference> models;
  std::optional<LineDifference> lines;
  /// Absent where none was asked for. With the diagnostics of both drawings.
  std::optional<Drawing> drawing;
  /// Of what was read and compared.
  Diagnostics diagnostics;
  /// One a part that is not the same, or a layer of lines that are not.
  std::vector<DifferenceRow> rows;
  /// One line: how many of what.
  std::string counts;
  /// Names of both revisions.
  std::string before, after;
};

/// Compares two models, part by part, and draws both as the plan of `after` says, for both sheets
/// together: with `draws`. What options of the user leave out is not compared; a part that the file
/// of one revision alone leaves out is compared and its look told, one that both leave out is not.
/// Exploded views, callouts and parts lists are left out of such a drawing, and told. Throws as
/// `compare_revisions`, `select_parts`, `draw`.
DiffOutcome diff_models(Revision before, Revision after, bool draws, RunContext& context);

/// Compares two drawings line by line, within `tolerance` mm of paper.
DiffOutcome diff_drawings(const Drawing& before, const Drawing& after,
                          const std::string& before_name, const std::string& after_name,
                          double tolerance, bool draws, const RunContext& context);

inline constexpr double kLineTolerance = 0.1;

/// Whether a file is a drawing of Burin, not an illustration, by its suffix and first bytes. False
/// where it cannot be read.
bool is_drawing_file(const std::filesystem::path& path);

/// The report: one line a row that is not "same", then the counts.
std::string difference_text(const DiffOutcome& outcome);
/// The report for programs, kernel/docs/changes.md lists its members.
std::string difference_json(const DiffOutcome& outcome);

/// Whether an output of this name and format is the report for programs: .json, but for
/// NAME.drawing.json, which is the drawing of both.
bool is_difference_report(const std::string& name, const Format& format);
/// Writes the report, the page or the drawing, as the name and format have it.
void write_difference(const DiffOutcome& outcome, const std::string& name, const Format& format,
                      const WriteOptions& options, std::ostream& out, const RunContext& context);

}  // namespace burin
