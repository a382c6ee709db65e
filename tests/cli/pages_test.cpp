// The commands of README and of the first pages of the manual, carried out.
#include <burin/base/ascii.h>

#include "models.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace burin {
namespace {

namespace fs = std::filesystem;

struct Part {
  std::string page, heading;
  std::vector<std::string> commands;
};

/// The commands of a page, without those that never end, under their headings.
void read_page(const std::string& page, std::vector<Part>& found) {
  found.push_back({page, "The beginning", {}});
  std::ifstream in(std::string(BURIN_SOURCE_DIR) + "/" + page);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("## ")) found.push_back({page, line.substr(3), {}});
    if (line.starts_with("    burin watch ")) continue;
    for (const std::string begin : {"burin ", "gzip ", "cp "}) {
      if (line.starts_with("    " + begin)) found.back().commands.push_back(line.substr(4));
    }
  }
}

std::vector<Part> parts() {
  std::vector<Part> found;
  for (const char* page : {"README.md", "kernel/docs/index.md", "kernel/docs/draw.md"}) {
    read_page(page, found);
  }
  std::erase_if(found, [](const Part& part) { return part.commands.empty(); });
  return found;
}

/// The files after `-o`.
std::vector<std::string> outputs_of(const std::string& command) {
  std::vector<std::string> found;
  std::istringstream words(command.substr(0, command.find(" #")));
  std::string before;
  for (std::string word; words >> word; before = word) {
    if (before == "-o" && word != "-") found.push_back(word);
  }
  return found;
}

class Pages : public ::testing::TestWithParam<Part> {};

TEST_P(Pages, CommandsDoWhatTheySay) {
  const test::Folder folder;
  const fs::path root = folder.path();
  fs::create_directory_symlink(std::string(BURIN_SOURCE_DIR) + "/samples", root / "samples");
  fs::create_directory(root / "bin");
  fs::create_symlink(BURIN_COMMAND, root / "bin" / "burin");
  for (const std::string& command : GetParam().commands) {
    // Some end in a comment, some write what they print to a file.
    const std::string line = "cd '" + root.string() +
                             "' && export HOME=\"$PWD\" PATH=\"$PWD/bin:$PATH\" && unset "
                             "XDG_DATA_HOME XDG_CACHE_HOME && {\n" +
                             command + "\n} > printed 2> errors";
    const int status = std::system(line.c_str());
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << command << "\n"
                                                               << test::slurp(root / "errors");
    for (const std::string& name : outputs_of(command)) {
      EXPECT_TRUE(fs::exists(root / name)) << command;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Manual, Pages, ::testing::ValuesIn(parts()), [](const auto& part) {
  std::string name = fs::path(part.param.page).stem().string() + "_";
  for (const char c : part.param.heading) {
    if (is_letter(c) || is_digit(c)) name += c;
  }
  return name;
});

}  // namespace
}  // namespace burin
