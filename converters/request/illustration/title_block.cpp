#include <burin/annotate/title_block.h>

#include "key_row.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

constexpr const char* kTemplate = "template";
constexpr const char* kIso = "iso";

/// "iso" or "none" as they are; a template as it is found from here.
std::string block_named(const KeyedFile& in, const Json& value, const std::string& path) {
  std::string name = in.text(value, path);
  if (!std::filesystem::path(name).extension().empty()) name = in.found_path(name);
  in.check(draw_rows(), "title_block", {name}, path, "title_block");
  return name;
}

std::vector<std::string> field_names() {
  std::vector<std::string> names{kTemplate};
  for (const TitleBlockField& field : title_block_fields()) names.emplace_back(field.name);
  return names;
}

}  // namespace

void take_title_block(const KeyedFile& in, const Json& value, const std::string& path,
                      IllustrationFile& out) {
  Request& options = out.request.options;
  options.erase("title_block_field");
  if (!value.is_object()) {
    options["title_block"] = {block_named(in, value, path)};
    return;
  }
  const bool iso = !value.contains(kTemplate) || value[kTemplate] == kIso;
  options["title_block"] = {iso ? std::string(kIso)
                                : block_named(in, value[kTemplate], path + "/" + kTemplate)};
  const std::vector<std::string> known = field_names();
  for (const auto& [name, said] : value.items()) {
    if (name == kTemplate) continue;
    const std::string at = path + "/" + name;
    if (iso && std::ranges::find(known, name) == known.end()) in.unknown(at, name, known);
    if (!said.is_string()) in.fail(at, fmt::format("\"{}\" takes text", name));
    options["title_block_field"].push_back(name + "=" + said.get<std::string>());
  }
}

Json title_block_schema() {
  Json properties;
  properties[kTemplate] = text("iso (default), or an SVG file whose texts are fields");
  for (const TitleBlockField& field : title_block_fields()) {
    properties[field.name] = {{"description", field.meaning}, {"type", "string"}};
  }
  Json object = object_of(std::move(properties));
  // Templates have fields of their own.
  object["additionalProperties"] = {{"type", "string"}};
  return {{"description", "a title block in the lower right corner"},
          {"anyOf", {text("iso, none or an SVG file"), std::move(object)}}};
}

Json write_title_block(const Request& options) {
  const std::vector<std::string>& named = given_texts(options, "title_block");
  if (named.empty()) return {};
  const std::vector<std::string>& fields = given_texts(options, "title_block_field");
  if (fields.empty()) return named.back();
  Json object;
  if (named.back() != kIso) object[kTemplate] = named.back();
  for (const std::string& field : fields) {
    const std::size_t equals = field.find('=');
    if (equals != std::string::npos) object[field.substr(0, equals)] = field.substr(equals + 1);
  }
  return object;
}

}  // namespace burin::detail
