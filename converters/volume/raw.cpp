#include <burin/base/error.h>

#include "layout.h"
#include "text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace burin {
namespace {

[[noreturn]] void refuse(std::string_view text, const std::string& why) {
  throw UsageError(fmt::format(
      "a raw layout is NXxNYxNZ[:TYPE[:DX,DY,DZ]], e.g. 64x64x32:u16:1,1,2.5; {} {}", text, why));
}

// Up to the next `end`, which goes too.
std::string_view take(std::string_view& text, char end) {
  const std::size_t at = text.find(end);
  const std::string_view word = text.substr(0, at);
  text.remove_prefix(at == std::string_view::npos ? text.size() : at + 1);
  return word;
}

}  // namespace

RawLayout parse_raw_layout(std::string_view text) {
  RawLayout out;
  std::string_view rest = text;
  std::string_view sizes = take(rest, ':'), type = take(rest, ':'), steps = take(rest, ':');
  if (!rest.empty()) refuse(in_quotes(text), "has too many parts");
  for (std::int32_t& n : out.size) {
    const std::string_view word = take(sizes, 'x');
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), n);
    if (error != std::errc() || stop != word.data() + word.size() || n < 2) {
      refuse(in_quotes(text), "does not begin with three sizes of 2 or more");
    }
  }
  if (!sizes.empty()) refuse(in_quotes(text), "has more than three sizes");
  if (!type.empty()) {
    const std::string name = lowered(type);
    const bool ordered = name.ends_with("be") || name.ends_with("le");
    const auto found = volume::type_of(ordered ? name.substr(0, name.size() - 2) : name);
    if (!found)
      refuse(in_quotes(type),
             "is none of i8 u8 i16 u16 i32 u32 i64 u64 f32 f64, or these with le or be");
    out.type = *found;
    out.big_endian = name.ends_with("be");
  }
  if (steps.empty()) return out;
  for (int k = 0; k < 3; ++k) {
    double step = 0;
    const bool good = parse_double(take(steps, ','), step) && step > 0 && std::isfinite(step);
    if (!good) refuse(in_quotes(text), "does not end with three spacings over 0");
    out.spacing[k] = step;
  }
  if (!steps.empty()) refuse(in_quotes(text), "has more than three spacings");
  return out;
}

namespace volume {

Layout raw_layout(const RawLayout& raw) {
  Layout out;
  out.format = "raw";
  for (std::size_t k = 0; k < 3; ++k) out.size[k] = raw.size[k];
  out.type = raw.type;
  out.order = raw.big_endian ? std::endian::big : std::endian::little;
  for (int k = 0; k < 3; ++k) {
    out.steps[k] = Vec3(0);
    out.steps[k][k] = raw.spacing[k];
  }
  out.skip_bytes = raw.skip;
  return out;
}

}  // namespace volume
}  // namespace burin
