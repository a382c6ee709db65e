#include <burin/converters/live_page.h>
#include <burin/converters/output.h>

#include <filesystem>
#include <ostream>

namespace burin {

std::string live_file(const std::string& page) { return page + ".live.js"; }

void note_drawn(const std::string& page, std::int64_t number) {
  Output file(live_file(page), *format_named("html"));
  file.write([&](std::ostream& out) { out << "burin_drawn(" << number << ");\n"; });
  file.commit();
}

void forget_drawn(const std::string& page) {
  std::error_code error;
  std::filesystem::remove(live_file(page), error);
}

}  // namespace burin
