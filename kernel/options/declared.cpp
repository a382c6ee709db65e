#include <burin/options/declared.h>

namespace burin {
namespace {

std::string key_of(std::string_view row, const DeclaredOption& declared) {
  return std::string(row) + "." + declared.option.name;
}

}  // namespace

OptionValue value_of(const DeclaredValues& values, std::string_view row,
                     const DeclaredOption& declared) {
  const auto found = values.changed.find(key_of(row, declared));
  return found == values.changed.end() ? declared.fallback : found->second;
}

std::vector<OptionValue> values_of(const DeclaredValues& values, std::string_view row,
                                   std::span<const DeclaredOption> declared) {
  std::vector<OptionValue> out;
  for (const DeclaredOption& one : declared) out.push_back(value_of(values, row, one));
  return out;
}

void set_value(DeclaredValues& values, std::string_view row, const DeclaredOption& declared,
               const OptionValue& value) {
  if (value == declared.fallback) {
    values.changed.erase(key_of(row, declared));
  } else {
    values.changed[key_of(row, declared)] = value;
  }
}

}  // namespace burin
