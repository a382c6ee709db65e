#pragma once
/// What a user chooses of strokes.

#include <burin/base/ascii.h>
#include <burin/options/declared.h>

#include <string>
#include <vector>

namespace burin {

/// The pen and the hatching; lengths in paper mm, tones as ink coverage (1 - reflectance).
struct HatchOptions {
  /// How strokes are placed: the name of a row of kernel/stroke/placing.cpp.
  std::string placing = "even";
  /// Distance of neighbouring strokes of a family where the tone is darkest and where it is
  /// lightest: strokes that swell keep the first and fade out one after the other towards the
  /// second.
  double spacing_min = 0.9;
  double spacing_max = 1.6;
  double width_min = 0.08;
  double width_max = 0.22;
  /// No ink where the tone asks for less than this.
  double tone_min = 0.35;
  /// The second family crosses the first where the tone asks for more than this; over 1 = never.
  double cross_from = 1.1;
  /// Degrees on the surface between the families; 90: the second one is the field's own.
  double cross_angle = 60;
  /// A stroke shorter than this is not drawn, but from edge to edge; one longer than this is cut.
  double length_min = 2.5;
  double length_max = 2000;
  /// About how long the stroke on a point is (a third more or less, by chance), where strokes stand
  /// on points.
  double length = 4;
  /// Of what the field keeps, between lines that stand along levels of it (model mm; of isophotes
  /// a cosine); 0: a round number by which they are about `spacing_min` apart.
  double level_step = 0;
  /// Formulas (burin/expression/formula.h), which may call image(u, v), over x y z (model mm), nx
  /// ny nz (the normal), u v (0 to 1 over the chart), facing (cosine to the viewer), lean (sine of
  /// the angle between the direction of the field and the normal), ink. What strokes cover of the
  /// paper, by what the tone asks for:
  std::string ink_law = "ink";
  /// ... and by what factor they stand closer, none where it is 0 or less;
  std::string density_law = "1";
  /// ... which also know `random`, of the stroke in [0,1), and t, along it from 0 to 1: factors of
  /// widths; of lengths of strokes on points and the chance that a stroke is drawn (no t).
  std::string width_law = "1", length_law = "1", presence_law = "1";
  /// What stands on points in the place of strokes: path data of SVG (burin/drawing/path_data.h),
  /// `length` large along its longer side; "none": strokes.
  std::string motif = "none";
  /// The name of a picture that laws know as image(u, v), and fields by its gradient; "none".
  std::string image = "none";
  /// Length over which a stroke's end thins out.
  double taper = 2.5;
  /// 0: equal spacing on paper whatever the slant of the surface; 1: equal spacing on the surface.
  double foreshortening = 0;
  /// Of the options that kinds of strokes from elsewhere declare.
  DeclaredValues declared{};

  bool has_motif() const { return motif != "none"; }
  /// Whether `motif` names an SVG file: whoever reads styles puts its path data in its place.
  bool motif_is_file() const { return lowered(motif).ends_with(".svg"); }
  bool has_image() const { return image != "none"; }

  bool operator==(const HatchOptions&) const = default;
};

/// Whether strokes have a direction: dots have none, and ask no field. Throws UsageError where no
/// way to place strokes has that name.
bool follows_field(const HatchOptions& options);

/// Whether strokes stand along levels of their field, which then has to have some. Throws as
/// `follows_field`.
bool uses_level_lines(const HatchOptions& options);

/// Whether motifs, and lengths of single strokes, mean something: strokes stand on points. Throws
/// as `follows_field`.
bool takes_motif(const HatchOptions& options);

/// Throws UsageError where a law is no formula, or a motif no path; `group` is what the key begins
/// with ("hatch.").
void check_texts(const HatchOptions& options, const std::string& group);

/// Names without a group: "spacing_min" ...
const std::vector<OptionRow<HatchOptions>>& hatch_option_rows();

}  // namespace burin
