#include "given_name.h"

#include <burin/base/ascii.h>
#include <burin/converters/mesh_reader.h>

#include "text.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace burin {
namespace {

bool is_model(const std::filesystem::path& file) {
  const std::string suffix = lowered(file.extension().string());
  return is_mesh_suffix(file) || suffix == ".step" || suffix == ".stp";
}

/// "4294f09b-1f2e-4b15-b14f-f6db5a48c747".
bool is_uuid(std::string_view name) {
  constexpr std::string_view kForm = "hhhhhhhh-hhhh-hhhh-hhhh-hhhhhhhhhhhh";
  constexpr std::string_view kDigits = "0123456789abcdefABCDEF";
  return std::ranges::equal(name, kForm, [&](char c, char form) {
    return form == '-' ? c == '-' : kDigits.find(c) != std::string_view::npos;
  });
}

}  // namespace

std::string given_name(const std::string& name) {
  std::string given = clean_name(name);
  const std::size_t folder = given.find_last_of("/\\");
  const std::filesystem::path file = given.substr(folder + 1);  // npos + 1 is 0
  if (is_model(file)) given = file.stem().string();
  return is_uuid(given) ? std::string() : given;
}

}  // namespace burin
