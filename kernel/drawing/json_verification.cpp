#include "json_members.h"

#include <fmt/format.h>

namespace burin::detail {
namespace {

void append_contradiction(Buffer& out, const Contradiction& c) {
  append(out, "{\"what\": ");
  append_json(out, c.what);
  if (c.size > 0) {
    fmt::format_to(fmt::appender(out), ", \"part\": {}, \"face\": {}, \"size\": ", c.source.part,
                   c.source.face);
    append_exact(out, c.size);
  } else {
    fmt::format_to(fmt::appender(out),
                   ", \"kind\": \"{}\", \"part\": {}, \"face\": {}, \"edge\": {}, \"length\": ",
                   to_string(c.kind), c.source.part, c.source.face, c.source.edge);
    append_exact(out, c.length);
  }
  append(out, ", \"at\": [");
  append_exact(out, c.at.x);
  append(out, ", ");
  append_exact(out, c.at.y);
  append(out, "], \"model\": ");
  append_json_vec(out, c.model);
  out.push_back('}');
}

}  // namespace

void append_json_verification(Buffer& out, const Verification& v) {
  fmt::format_to(fmt::appender(out), ",\n    \"verify\": {{\"spans\": {}, \"length\": ", v.spans);
  append_exact(out, v.length);
  append(out, ", \"contradicted\": ");
  append_exact(out, v.contradicted);
  append(out, ", \"share\": ");
  append_exact(out, v.share());
  fmt::format_to(fmt::appender(out), ", \"count\": {}, \"loose_ends\": {}", v.count, v.loose_ends);
  if (v.area > 0) {
    append(out, ", \"area\": ");
    append_exact(out, v.area);
    append(out, ", \"wrong_area\": ");
    append_exact(out, v.wrong_area);
    fmt::format_to(fmt::appender(out), ", \"wrong_patches\": {}", v.wrong_patches);
  }
  append(out, ", \"contradictions\": [");
  for (std::size_t i = 0; i < v.contradictions.size(); ++i) {
    append(out, i > 0 ? ",\n      " : "\n      ");
    append_contradiction(out, v.contradictions[i]);
  }
  append(out, "]}");
}

}  // namespace burin::detail
