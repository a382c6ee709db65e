#include <burin/arrange/arrange.h>

#include "key_row.h"
#include "thread_option.h"

#include <cmath>

namespace burin::detail {
namespace {

const std::vector<KeyRow<ThreadRow>>& thread_key_rows() {
  static const std::vector<KeyRow<ThreadRow>> rows = {
      {.name = "select",
       .schema = one_or_list_of(selector()),
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  ThreadRow& row) { row.select = in.text_list(value, path); },
       .write = [](const ThreadRow& row) { return Json(row.select); },
       .missing = "a thread has \"{}\", the parts that it is on"},
      text_row("size",
               "M6, M6x0.75, 1/4 UNC; of others any text, beside \"diameter\" and \"pitch\"",
               &ThreadRow::size),
      vector_row("at", "of several cylinders the one next to this point, model mm", &ThreadRow::at,
                 true),
      {.name = "face",
       .schema = {{"description", "of several cylinders the one with this number of a face"},
                  {"type", "integer"},
                  {"minimum", 0}},
       .read =
           [](const KeyedFile& in, const Json& value, const std::string& path, ThreadRow& row) {
             const double given = in.within(value, path, 0, 2147483647, "the number of a face");
             if (given != std::floor(given)) in.fail(path, "\"face\" takes a whole number");
             row.face = static_cast<std::int32_t>(given);
           },
       .write = [](const ThreadRow& row) { return row.face ? Json(*row.face) : Json(); }},
      positive_row("diameter", "nominal, model mm; default: by \"size\"", &ThreadRow::diameter,
                   kLarge),
      positive_row("pitch", "model mm; default: that of a coarse thread of ISO 261",
                   &ThreadRow::pitch, kLarge),
      positive_row("minor", "minor diameter, model mm; default: that of ISO 724", &ThreadRow::minor,
                   kLarge),
      {.name = "start",
       .schema = {{"description", "model mm from the open end (next to \"at\")"},
                  {"type", "number"},
                  {"minimum", 0},
                  {"maximum", kLarge}},
       .read = [](const KeyedFile& in, const Json& value, const std::string& path,
                  ThreadRow& row) { row.start = in.within(value, path, 0, kLarge, "mm from 0"); },
       .write = [](const ThreadRow& row) { return row.start > 0 ? Json(row.start) : Json(); }},
      positive_row("length", "model mm; default: as far as the cylinder goes", &ThreadRow::length,
                   kLarge),
  };
  return rows;
}

ThreadRow read_thread(const KeyedFile& in, const Json& value, const std::string& path) {
  ThreadRow row;
  row.place = in.place(path);
  if (!value.is_object()) {
    const std::string given = in.text(value, path);
    in.check(draw_rows(), "thread", {given}, path, "threads");
    row = thread_option("threads", given);
    row.place = in.place(path);
    return row;
  }
  row = read_object(thread_key_rows(), in, value, path, std::move(row));
  check_thread_row(row);
  return row;
}

}  // namespace

void take_threads(const KeyedFile& in, const Json& value, const std::string& path,
                  IllustrationFile& out) {
  in.check_array(value, path);
  out.request.threads.clear();
  for (std::size_t i = 0; i < value.size(); ++i) {
    out.request.threads.push_back(read_thread(in, value[i], fmt::format("{}/{}", path, i)));
  }
}

Json threads_schema() {
  Json object = object_schema(thread_key_rows());
  object["anyOf"] = either({"size", "diameter", "at", "face"});
  return list_of({{"anyOf", {text("parts and a size, as screw*=M6"), std::move(object)}}});
}

Json write_threads(const std::vector<ThreadRow>& threads, const Request& options) {
  Json list = Json::array();
  for (const ThreadRow& row : threads) list.push_back(write_object(thread_key_rows(), row));
  for (const std::string& text : given_texts(options, "thread")) list.push_back(text);
  return list;
}

}  // namespace burin::detail
