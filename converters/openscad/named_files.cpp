#include "named_files.h"

#include <burin/base/input_files.h>

#include "text.h"

#include <fstream>
#include <iterator>
#include <set>
#include <string>

namespace burin::detail {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 1000;
constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} << 20;

bool is_regular(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

class NamedFiles {
 public:
  explicit NamedFiles(fs::path folder) : top_(std::move(folder)) {}

  void look_into(std::string_view program, const fs::path& folder) {
    for (std::size_t i = 0; i < program.size();) {
      if (program.substr(i).starts_with("//")) {
        i = after(program, "\n", i + 2);
      } else if (program.substr(i).starts_with("/*")) {
        i = after(program, "*/", i + 2);
      } else if (program[i] == '"') {
        const std::size_t end = after(program, "\"", i + 1);
        take_text(program.substr(i + 1, end - i - 1), folder);
        i = end;
      } else if (is_letter(program[i])) {
        i = word(program, i, folder);
      } else {
        ++i;
      }
    }
  }

 private:
  /// Behind the next `mark`.
  static std::size_t after(std::string_view program, std::string_view mark, std::size_t from) {
    const std::size_t at = program.find(mark, from);
    return at == std::string_view::npos ? program.size() : at + mark.size();
  }

  /// A word, and the name in angle brackets that follows `include` and `use`.
  std::size_t word(std::string_view program, std::size_t begin, const fs::path& folder) {
    std::size_t end = begin;
    while (end < program.size() &&
           (is_letter(program[end]) || is_digit(program[end]) || program[end] == '_')) {
      ++end;
    }
    const std::string_view name = program.substr(begin, end - begin);
    if (name != "include" && name != "use") return end;
    std::size_t open = end;
    while (open < program.size() && (is_blank(program[open]) || is_line_end(program[open]))) ++open;
    if (open >= program.size() || program[open] != '<') return end;
    const std::size_t close = after(program, ">", open + 1);
    take_program(program.substr(open + 1, close - open - 2), folder);
    return close;
  }

  void take_text(std::string_view text, const fs::path& folder) {
    constexpr std::size_t kLongestName = 4096;
    if (text.empty() || text.size() > kLongestName) return;
    const std::string name(text.substr(0, text.size() - (text.ends_with('"') ? 1 : 0)));
    for (const fs::path& from : {folder, top_}) {
      if (!name.empty() && is_regular(from / name)) InputFiles::opens(from / name);
    }
  }

  void take_program(std::string_view name, const fs::path& folder) {
    const fs::path path = (folder / std::string(name)).lexically_normal();
    if (seen_.size() >= kMostFiles || !seen_.insert(path).second) return;
    InputFiles::opens(path);
    std::error_code error;
    if (!is_regular(path) || fs::file_size(path, error) > kMostBytes) return;
    std::ifstream in(path, std::ios::binary);
    const std::string program{std::istreambuf_iterator<char>(in), {}};
    look_into(program, path.parent_path());
  }

  fs::path top_;
  std::set<fs::path> seen_;
};

}  // namespace

void note_named_files(std::string_view program, const fs::path& folder) {
  NamedFiles(folder).look_into(program, folder);
}

}  // namespace burin::detail
