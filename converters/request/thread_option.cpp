#include "thread_option.h"

#include <burin/arrange/arrange.h>
#include <burin/converters/values.h>

namespace burin::detail {

ThreadRow thread_option(const std::string& spelled, const std::string& text) {
  const auto [name, size] = name_and_value(spelled, "NAME=SIZE, as screw*=M6", text);
  ThreadRow row{.select = {name}, .size = size, .place = spelled + ": "};
  check_thread_row(row);
  return row;
}

std::vector<RequestRow<Draft>> thread_rows() {
  return {
      {{.option = {.name = "thread",
                   .meaning = "draw a thread on the shafts and in the holes of parts that fit its "
                              "size, M6, M6x0.75 or 1/4 UNC, as ISO 6410 has it; repeatable",
                   .takes = FreeText{}},
        .group = kParts,
        .label = "NAME=SIZE",
        .many = true,
        .python = "str | Sequence[str]",
        .also = {"screw thread", "cosmetic thread", "iso 6410", "tapped hole", "tap", "bolt thread",
                 "metric"}},
       [](Draft& d, const Asked& a) {
         for (const std::string& text : a.texts) {
           d.plan.thread_rows.push_back(thread_option(a.spelled, text));
         }
       }},
  };
}

}  // namespace burin::detail
