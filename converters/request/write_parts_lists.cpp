#include <burin/base/ascii.h>
#include <burin/converters/output.h>
#include <burin/converters/request.h>
#include <burin/drawing/parts_list.h>

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

namespace burin {

void write_parts_lists(const Drawing& drawing, const DrawPlan& plan) {
  std::vector<Output> files;
  for (const std::string& name : plan.parts_list_files) {
    Output& file = files.emplace_back(name, *format_named("json"));
    const bool csv = lowered(std::filesystem::path(name).extension().string()) != ".json";
    file.write([&](std::ostream& out) {
      out << (csv ? parts_list_csv(drawing.items) : parts_list_json(drawing.items));
    });
  }
  for (Output& file : files) file.commit();
}

}  // namespace burin
