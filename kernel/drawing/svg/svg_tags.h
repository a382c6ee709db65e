#pragma once
/// What all kinds of SVG files that are written here begin with.

#include <burin/drawing/drawing.h>
#include <burin/drawing/ink.h>
#include <burin/drawing/text.h>
#include <burin/drawing/writers.h>

#include <iosfwd>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace burin {

/// All before the first layer; `more` are attributes of the root, each with a space before it.
std::string svg_head(const Drawing& drawing, std::string_view more = {});
/// The opening tag of a layer's group; its lines are `ink`, as `svg_ink` has it.
std::string svg_layer_tag(const InkLayer& layer, const std::string& id, std::string_view ink,
                          const SvgOptions& options);
/// A colour as SVG writes it.
std::string svg_ink(const std::string& color);

/// Names as XML ids of one file, each once.
class SvgIds {
 public:
  explicit SvgIds(std::string prefix) : prefix_(std::move(prefix)) {}
  std::string make(std::string_view name);

 private:
  std::string prefix_;
  std::set<std::string> taken_;
};

/// A text as an element of its own; with `flatten` its outlines as polylines.
std::string svg_text(const Text& text, double paper_height, std::string_view ink,
                     const SvgOptions& options);

void append_pen(Buffer& out, double width);
/// As an attribute; nothing where there are none.
void append_dashes(Buffer& out, const std::vector<double>& dashes);
/// Paper mm that fitted curves may be off before their numbers are rounded.
double curve_tolerance(const SvgOptions& options);

/// See SvgOptions::merge.
void write_merged_svg(const Drawing& drawing, const SvgOptions& options, std::ostream& out,
                      const RunContext& context);

}  // namespace burin
