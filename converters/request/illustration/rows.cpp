#include "rows.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

/// Sets an option of the drawing, once its row takes the value.
void set_option(const KeyedFile& in, const std::string& option, const Json& value,
                const std::string& path, const std::string& key, IllustrationFile& out) {
  in.check_type(value, path, value_of_option(option));
  const bool size = option == "paper" && value.is_array() && value.size() == 2;
  const std::string given = size
                                ? fmt::format("{}x{}", option_text(value[0]), option_text(value[1]))
                                : option_text(value);
  in.check(draw_rows(), option, {given}, path, key);
  out.request.options[option] = {given};
}

/// Values of an option of a drawing, where they are said or where they hold without.
Json write_option(const IllustrationKey& key, const IllustrationFile& file) {
  const RequestOption& option = option_named(key.option);
  const Request& options = file.request.options;
  const std::vector<std::string> texts = asked_texts(option, options);
  if (texts.empty()) return {};
  // What holds without being asked for is written to be edited, where it has an effect.
  const bool apart = !file.request.explode.steps.empty();  // the view is then found
  const bool idle = key.option == "projection" || (key.option == "view" && apart);
  if (idle && given_texts(options, key.option).empty()) return {};
  return written_value(option, texts.back());
}

using Row = KeyRow<IllustrationFile>;

/// A key that is an option.
Row option_row(const IllustrationKey& key, std::string name) {
  return {
      .name = std::move(name),
      .schema = value_of_option(key.option),
      .read =
          [key](const KeyedFile& in, const Json& value, const std::string& path,
                IllustrationFile& out) { set_option(in, key.option, value, path, key.path, out); },
      .write = [key](const IllustrationFile& file) { return write_option(key, file); }};
}

/// Options that stand in an object, "view" or "paper".
Row group_row(const std::string& name) {
  std::vector<Row> members;
  for (const IllustrationKey& key : illustration_keys()) {
    if (!key.path.starts_with(name + ".")) continue;
    members.push_back(option_row(key, key.path.substr(name.size() + 1)));
  }
  Json schema = object_schema(members);
  return {.name = name,
          .schema = std::move(schema),
          .read =
              [members](const KeyedFile& in, const Json& value, const std::string& path,
                        IllustrationFile& out) {
                check_members(members, in, value, path);
                read_members(members, in, value, path, out);
              },
          .write =
              [members](const IllustrationFile& file) {
                const Json object = write_object(members, file);
                return object.empty() ? Json() : object;
              }};
}

/// An object, or the size alone.
Row paper_row() {
  Row row = group_row("paper");
  row.schema = {{"anyOf", {row.schema, value_of_option("paper")}}};
  row.read = [members = row.read](const KeyedFile& in, const Json& value, const std::string& path,
                                  IllustrationFile& out) {
    if (value.is_object()) return members(in, value, path, out);
    set_option(in, "paper", value, path, "paper", out);
  };
  return row;
}

/// A key that says what the file is; read before all others, or by nobody.
Row head_row(const char* name, Json schema, Json written = {}) {
  return {.name = name,
          .schema = std::move(schema),
          .read = {},
          .write = [written = std::move(written)](const IllustrationFile&) { return written; }};
}

/// A list that is left out where it is empty.
Json unless_empty(Json list) {
  if (list.empty()) return {};
  return list;
}

Json write_explosion(const IllustrationFile& file) {
  if (file.request.explode.steps.empty()) return {};
  Json explode = write_explode(file.request.explode);
  const std::vector<std::string> factor = given_texts(file.request.options, "explode_factor");
  if (!factor.empty()) {
    explode["factor"] = written_value(option_named("explode_factor"), factor.back());
  }
  return explode;
}

Json write_parts_list(const IllustrationFile& file) {
  const std::vector<std::string> lists = given_texts(file.request.options, "parts_list");
  return std::ranges::find(lists, "sheet") == lists.end() ? Json() : Json("sheet");
}

}  // namespace

const std::vector<IllustrationKey>& illustration_keys() {
  static const std::vector<IllustrationKey> keys = {
      {"view.from", "view"},
      {"view.up", "up"},
      {"view.perspective", "perspective"},
      {"view.scale", "scale"},
      {"view.center", "center"},
      {"paper.size", "paper"},
      {"paper.margin", "margin"},
      {"hidden", "hidden"},
      {"centre_lines", "centre_lines"},
      {"tolerance", "tolerance"},
      {"seed", "seed"},
      {"callouts", "callouts"},
      {"legend", "legend"},
      {"views", "views"},
      {"hidden_views", "hidden_views"},
      {"projection", "projection"},
      {"view.saved", "saved_view"},
  };
  return keys;
}

const RequestOption& option_named(const std::string& name) {
  return find_option(all_options(), name);
}

const std::vector<Row>& rows_of_file() {
  static const std::vector<Row> all = [] {
    using File = IllustrationFile;
    std::vector<Row> rows = {
        head_row("burin", {{"const", "illustration"}}, "illustration"),
        head_row("version", {{"const", 1}}, 1),
        head_row("$schema", {{"type", "string"}}),
        head_row("extends", text("an illustration file whose keys hold where this one has none")),
        {.name = "parts",
         .schema = parts_schema(),
         .read = take_parts,
         .write = [](const File& file) { return write_parts(file.inputs); }},
        {.name = "style",
         .schema = style_value_schema(),
         .read = take_style,
         .write = [](const File& file) { return write_style(file.request.options); }},
        {.name = "looks",
         .schema = looks_schema(),
         .read = take_looks,
         .write = [](const File& file) { return write_looks(file.request.looks); }},
        {.name = "lights",
         .schema = lights_schema(),
         .read = take_lights,
         .write = [](const File& file) { return unless_empty(write_lights(file.request.lights)); }},
        {.name = "title",
         .schema = text("what the drawing is called (default: by its parts)"),
         .read = take_title,
         .write =
             [](const File& file) {
               return file.request.title.empty() ? Json() : Json(file.request.title);
             }},
        {.name = "items",
         .schema = items_schema(),
         .read = take_items,
         .write = [](const File& file) { return unless_empty(write_items(file.request.items)); }},
        {.name = "parts_list",
         .schema = {{"description", "a parts list on the sheet"}, {"const", "sheet"}},
         .read = take_parts_list,
         .write = write_parts_list},
        {.name = "title_block",
         .schema = title_block_schema(),
         .read = take_title_block,
         .write = [](const File& file) { return write_title_block(file.request.options); }},
        group_row("view"),
        paper_row(),
        {.name = "section",
         .schema = section_schema(),
         .read = take_sections,
         .write =
             [](const File& file) { return unless_empty(write_sections(file.request.options)); }},
        {.name = "explode",
         .schema = explode_schema(),
         .read = take_explode,
         .write = write_explosion},
        {.name = "dimensions",
         .schema = dimensions_schema(),
         .read = take_dimensions,
         .write = [](const File& file) { return write_dimensions(file.request); }},
        {.name = "notes",
         .schema = notes_schema(),
         .read = take_notes,
         .write = [](const File& file) { return unless_empty(write_notes(file.request)); }},
        {.name = "arrows",
         .schema = arrows_schema(),
         .read = take_arrows,
         .write = [](const File& file) { return unless_empty(write_arrows(file.request)); }},
        {.name = "breaks",
         .schema = breaks_schema(),
         .read = take_breaks,
         .write =
             [](const File& file) {
               return unless_empty(Json(given_texts(file.request.options, "break_view")));
             }},
        {.name = "details",
         .schema = details_schema(),
         .read = take_details,
         .write =
             [](const File& file) {
               return unless_empty(Json(given_texts(file.request.options, "detail")));
             }},
        {.name = "threads",
         .schema = threads_schema(),
         .read = take_threads,
         .write =
             [](const File& file) {
               return unless_empty(write_threads(file.request.threads, file.request.options));
             }},
    };
    for (const IllustrationKey& key : illustration_keys()) {
      const bool grouped = key.path.find('.') != std::string::npos;
      if (!grouped) rows.push_back(option_row(key, key.path));
    }
    return rows;
  }();
  return all;
}

}  // namespace burin::detail
