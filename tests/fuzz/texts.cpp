#include <burin/base/error.h>
#include <burin/base/run_context.h>
#include <burin/converters/illustration.h>
#include <burin/converters/implicit_reader.h>
#include <burin/converters/read_drawing.h>
#include <burin/converters/request.h>
#include <burin/converters/write.h>
#include <burin/illustrate/style.h>
#include <burin/plugin/plugins.h>

#include "targets.h"
#include "tree.h"

#include <cstdlib>
#include <sstream>
#include <vector>

namespace burin::fuzz {

void implicit(std::string_view text) {
  const Expression f = parse_implicit(text, "fuzz");
  f.bounds();
  const auto function = make_function(f);
  const std::vector<Vec3> points{Vec3(0), Vec3(1, -2, 3), Vec3(1e30, 0, -1)};
  std::vector<double> values(points.size());
  std::vector<Gradient2> hessians(points.size());
  function->values(points, values);
  function->hessians(points, hessians);
}

void csg(std::string_view text) {
  RunContext context;
  const burin::csg::Tree tree = burin::csg::parse(std::string(text), "fuzz", context);
  for (std::uint32_t n = 0; n < tree.nodes.size(); ++n) {
    const burin::csg::Node& node = tree.nodes[n];
    if (node.end <= n || node.end > tree.nodes.size()) std::abort();
    if (tree.text_of(n).size() > text.size()) std::abort();
    burin::csg::for_each_child(tree, n, [&](std::uint32_t child) {
      if (child <= n || tree.nodes[child].end > node.end) std::abort();
    });
    try {
      burin::csg::matrix_of(tree, n);
    } catch (const InputError&) {
      // The nodes behind it count too.
    }
  }
}

void style(std::string_view text) {
  const std::string once = style_to_json(parse_style(text, "fuzz"));
  if (style_to_json(parse_style(once, "again")) != once) std::abort();
}

void illustration(std::string_view text) {
  const IllustrationFile illustration = parse_illustration(text, "fuzz");
  make_plan(illustration.request, Spelling::Keywords);
}

void drawing(std::string_view text) {
  const RunContext context;
  const Drawing drawing = parse_drawing(text, "fuzz", context);
  for (const char* format : {"json", "svg", "eps", "dxf", "hpgl", "gcode"}) {
    std::ostringstream out;
    write_drawing(drawing, *format_named(format), {}, out, context);
  }
}

void options(std::string_view text) {
  DrawRequest request;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) continue;
    const std::string name = line.substr(0, equals);
    if (name == "style") continue;  // that may name a file
    request.options[find_option(all_options(), name).option.name].push_back(
        line.substr(equals + 1));
  }
  make_plan(request, Spelling::Options);
}

void plugin(std::string_view text) {
  const std::string fault = plugin::read_report(std::string(text));
  if (fault.size() > 1000 || fault.find('\n') != std::string::npos) std::abort();
  const std::string once = plugin::read_tried(std::string(text));
  if (plugin::read_tried(once) != once) std::abort();
}

}  // namespace burin::fuzz
