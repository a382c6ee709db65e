#pragma once
/// What a user asks of a drawing, as text, and what that means to the kernel: one place for the
/// command line and the Python module, so that both take the same and say the same.

#include <burin/camera/sheet.h>
#include <burin/converters/read.h>
#include <burin/illustrate/illustrate.h>
#include <burin/illustrate/style.h>

#include <string>
#include <vector>

namespace burin {

/// Long options about reading, as they were typed; empty = absent.
struct ReadRequest {
  std::string bounds;
  /// Of functions: auto, nets or delaunay.
  std::string mesher = {};
  /// OpenSCAD's -D NAME=VALUE.
  std::vector<std::string> define = {};
  std::string openscad_timeout = {};
  /// FreeCAD documents.
  std::vector<std::string> object = {};
  std::string recompute = {};
  std::string freecad_timeout = {};
  /// Volumes.
  std::string iso;
  std::string inside;
  std::string volume_degree;
  std::string smooth;
  std::string specks;
  std::string interpolate;
  std::string raw;
  std::string raw_skip;
  /// "true" or "false".
  std::string heal = {};
};

/// Long options of `burin draw`, as they were typed; empty = absent.
struct DrawRequest {
  std::string view = "iso";
  std::string up;
  std::string perspective;
  std::string paper = "A4";
  std::string scale;
  std::string center;
  std::string margin = "10";
  std::string style = "technical";
  /// The text of a style file; goes before `style`.
  std::string style_text;
  std::vector<std::string> set;
  std::string light;
  std::string hidden = "none";
  std::string tolerance;
  std::string seed = "1";
  std::string threads;
  /// "true" or "false".
  std::string verify = {};
  ReadRequest read;
};

/// How errors name an option: "--crease-angle" or "crease_angle".
enum class Spelling { Options, Keywords };

/// Everything but the inputs and outputs themselves.
struct DrawPlan {
  Style style;
  ViewOptions view;
  SheetOptions sheet;
  IllustrateOptions illustrate;
  ReadOptions read;
  /// Worker threads; 0 = all.
  int threads = 0;
  /// Options that were given and have no effect on a drawing without strokes, and those that have
  /// none where every part is a mesh; as messages call them.
  std::vector<std::string> about_strokes = {}, about_exact = {};
  /// Options that were given and have no effect on any drawing.
  Diagnostics notes = {};
};

/// Throws UsageError that names the option; InputError for a style file that cannot be read.
DrawPlan make_plan(const DrawRequest& request, Spelling spelling);
/// The camera that a plan asks for, of what was read. Throws UsageError, GeometryError.
Camera make_camera(const Scene& scene, const DrawPlan& plan);
/// Draws it, with a diagnostic "option.unused" for each choice of the plan that changes nothing of
/// this drawing. Throws as `illustrate`.
Drawing draw(const Scene& scene, const Camera& camera, const DrawPlan& plan, RunContext& context);
ReadOptions make_read_options(const ReadRequest& request, Spelling spelling);

/// The style of a name or file, with no changes. Throws UsageError, InputError.
Style load_style(const std::string& name);

/// Sets an option about reading by its name without dashes ("bounds"). Throws UsageError that names
/// the nearest of these and of `others`.
void set_read_option(ReadRequest& request, const std::string& name, const std::string& value,
                     const std::vector<std::string>& others = {});

}  // namespace burin
