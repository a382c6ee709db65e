#include <burin/base/run_context.h>
#include <burin/converters/implicit_reader.h>
#include <burin/converters/read_drawing.h>
#include <burin/converters/request.h>
#include <burin/converters/write.h>
#include <burin/illustrate/style.h>

#include "targets.h"

#include <cstdlib>
#include <map>
#include <sstream>
#include <vector>

namespace burin::fuzz {
namespace {

void set(DrawRequest& request, const std::string& name, const std::string& value) {
  static const std::map<std::string, std::string DrawRequest::*> fields{
      {"view", &DrawRequest::view},
      {"up", &DrawRequest::up},
      {"perspective", &DrawRequest::perspective},
      {"paper", &DrawRequest::paper},
      {"scale", &DrawRequest::scale},
      {"center", &DrawRequest::center},
      {"margin", &DrawRequest::margin},
      {"light", &DrawRequest::light},
      {"hidden", &DrawRequest::hidden},
      {"tolerance", &DrawRequest::tolerance},
      {"seed", &DrawRequest::seed},
      {"threads", &DrawRequest::threads}};
  const auto field = fields.find(name);
  if (field != fields.end()) {
    request.*field->second = value;
  } else if (name == "set") {
    request.set.push_back(value);
  } else if (name != "style") {  // that may name a file
    set_read_option(request.read, name, value);
  }
}

}  // namespace

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

void style(std::string_view text) {
  const std::string once = style_to_json(parse_style(text, "fuzz"));
  if (style_to_json(parse_style(once, "again")) != once) std::abort();
}

void drawing(std::string_view text) {
  const RunContext context;
  const Drawing drawing = parse_drawing(text, "fuzz", context);
  for (const Format format : {Format::Json, Format::Svg, Format::Eps, Format::Dxf}) {
    std::ostringstream out;
    write_drawing(drawing, format, {}, out, context);
  }
}

void options(std::string_view text) {
  DrawRequest request;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) continue;
    set(request, line.substr(0, equals), line.substr(equals + 1));
  }
  make_plan(request, Spelling::Options);
}

}  // namespace burin::fuzz
