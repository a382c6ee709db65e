// INRIA: lines "KEY=value" in a header of 256 bytes or a multiple, which ends with "##}".
#include "header_text.h"
#include "layout.h"
#include "text.h"

#include <fmt/format.h>

namespace burin::volume {
namespace {

constexpr std::size_t kBlock = 256;

SampleType type_of_fields(const Fields& fields) {
  const Field& type = fields.need("TYPE");
  const Field& pixel = fields.need("PIXSIZE");
  const auto words = words_of(pixel.value);
  const std::string bits(words.empty() ? std::string_view() : words[0]);
  const std::string kind = lowered(type.value);
  const char letter = kind == "float" || kind == "double"         ? 'f'
                      : kind == "unsigned fixed"                  ? 'u'
                      : kind == "signed fixed" || kind == "fixed" ? 'i'
                                                                  : '?';
  const auto found = volume::type_of(letter + bits);
  if (letter == '?') {
    fields.fail(type, fmt::format("{} is not float, unsigned fixed or signed fixed",
                                  in_quotes(type.value)));
  }
  if (!found) {
    fields.fail(pixel, fmt::format("samples of {} are not read: 8 to 64 bits are, floats of 32 "
                                   "and 64",
                                   in_quotes(pixel.value)));
  }
  return *found;
}

std::endian order_of(const Fields& fields) {
  const Field& cpu = fields.need("CPU");
  const std::string name = lowered(cpu.value);
  if (name == "decm" || name == "alpha" || name == "pc") return std::endian::little;
  if (name == "sun" || name == "sgi") return std::endian::big;
  fields.fail(cpu, fmt::format("{} is no CPU whose byte order is known (decm, alpha, pc, sun, sgi)",
                               in_quotes(cpu.value)));
}

double number(const Fields& fields, std::string_view key, double otherwise) {
  const Field* field = fields.find(key);
  return field ? fields.numbers(*field, 1).front() : otherwise;
}

}  // namespace

Layout read_inrimage(const Head& head) {
  Lines lines(head.source);
  Fields fields(head.source);
  lines.next();  // the magic
  bool ended = false;
  while (!ended) {
    const auto line = lines.next();
    if (!line) head.source.fail("the header has no end, ##}; the file is truncated");
    ended = line->starts_with("##}");
    if (ended || trimmed(*line).empty() || line->starts_with('#')) continue;
    const std::size_t equals = line->find('=');
    if (equals == std::string_view::npos) {
      lines.fail(fmt::format("{} is no field of an INRIA header", in_quotes(*line)));
    }
    fields.add({std::string(trimmed(line->substr(0, equals))), trimmed(line->substr(equals + 1)),
                lines.number()});
  }
  Layout out;
  out.format = "INRIA image";
  constexpr std::string_view kAxes = "XYZ";
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string axis(1, kAxes[k]);
    const Field& size = fields.need(axis + "DIM");
    out.size[k] = fields.integer(size);
    out.size_line = size.line;
    const auto i = static_cast<int>(k);
    out.steps[i] = Vec3(0);
    out.steps[i][i] = number(fields, "V" + axis, 1);
    out.origin[i] = number(fields, "T" + axis, 0);
  }
  if (const Field* values = fields.find("VDIM"); values && fields.integer(*values) != 1) {
    fields.fail(*values, "vectors and colours are not drawn; save one volume of scalars");
  }
  out.type = type_of_fields(fields);
  out.order = order_of(fields);
  out.header_bytes = (lines.offset() + kBlock - 1) / kBlock * kBlock;
  return out;
}

}  // namespace burin::volume
