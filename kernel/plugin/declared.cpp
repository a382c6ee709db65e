#include "declared.h"

#include <utility>

namespace burin::plugin {
namespace {

Takes takes_of(const burin_option& o) {
  switch (o.kind) {
    case BURIN_WHOLE:
      return WholeRange{static_cast<std::uint64_t>(o.low), static_cast<std::uint64_t>(o.high)};
    case BURIN_FLAG:
      return Switch{};
    case BURIN_WORD: {
      WordList list;
      for (const char* const* word = o.words; *word != nullptr; ++word)
        list.words.emplace_back(*word);
      return list;
    }
    case BURIN_VECTOR:
      return Direction{};
    case BURIN_TEXT:
      return FreeText{};
    default:
      return NumberRange{o.low, o.high, o.unit == nullptr ? "" : o.unit};
  }
}

OptionValue fallback_of(const burin_option& o) {
  switch (o.kind) {
    case BURIN_WHOLE:
    case BURIN_WORD:
      return static_cast<std::uint64_t>(o.fallback.number);
    case BURIN_FLAG:
      return o.fallback.number != 0;
    case BURIN_VECTOR:
      return Vec3(o.fallback.vector[0], o.fallback.vector[1], o.fallback.vector[2]);
    case BURIN_TEXT:
      return std::string(o.fallback.text);
    default:
      return o.fallback.number;
  }
}

burin_value value_of(const OptionValue& value) {
  burin_value out{};
  if (const auto* number = std::get_if<double>(&value)) out.number = *number;
  if (const auto* whole = std::get_if<std::uint64_t>(&value)) {
    out.number = static_cast<double>(*whole);
  }
  if (const auto* flag = std::get_if<bool>(&value)) out.number = *flag ? 1 : 0;
  if (const auto* text = std::get_if<std::string>(&value)) out.text = text->c_str();
  if (const auto* v = std::get_if<Vec3>(&value)) {
    for (int i = 0; i < 3; ++i) out.vector[i] = (*v)[i];
  }
  return out;
}

}  // namespace

std::vector<DeclaredOption> declared(const burin_factory& factory) {
  std::vector<DeclaredOption> out;
  for (std::size_t i = 0; i < factory.option_count; ++i) {
    const burin_option& o = factory.options[i];
    out.push_back({{o.name, o.meaning, takes_of(o)}, fallback_of(o)});
  }
  return out;
}

Values::Values(std::vector<OptionValue> values) : held_(std::move(values)) {
  for (const OptionValue& value : held_) values_.push_back(value_of(value));
}

}  // namespace burin::plugin
