// What README says, done.
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
  std::string heading;
  std::vector<std::string> commands;
};

/// The commands that README tells, without those that never end, under their headings.
std::vector<Part> parts() {
  std::vector<Part> found = {{"The beginning", {}}};
  std::ifstream in(std::string(BURIN_SOURCE_DIR) + "/README.md");
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("## ")) found.push_back({line.substr(3), {}});
    if (line.starts_with("    burin watch ")) continue;
    std::vector<std::string>& commands = found.back().commands;
    for (const std::string begin : {"    burin ", "    build/release/bin/burin "}) {
      if (line.starts_with(begin)) commands.push_back("burin " + line.substr(begin.size()));
    }
    for (const std::string begin : {"    mkdir ", "    cc "}) {
      if (line.starts_with(begin)) commands.push_back(line);
    }
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

class Readme : public ::testing::TestWithParam<Part> {};

TEST_P(Readme, ItsCommandsDoWhatTheySay) {
  const test::Folder folder;
  const fs::path root = folder.path();
  fs::create_directory_symlink(std::string(BURIN_SOURCE_DIR) + "/samples", root / "samples");
  fs::create_directory_symlink(std::string(BURIN_SOURCE_DIR) + "/kernel", root / "kernel");
  fs::create_directory(root / "bin");
  fs::create_symlink(BURIN_COMMAND, root / "bin" / "burin");
  // The reader's own part.
  fs::copy_file(std::string(BURIN_SOURCE_DIR) + "/samples/spindle.stl", root / "part.stl");
  for (const std::string& command : GetParam().commands) {
    // Some end in a remark, some write what they print to a file.
    const std::string line = "cd '" + root.string() +
                             "' && export HOME=\"$PWD\" PATH=\"$PWD/bin:$PATH\" && unset "
                             "XDG_DATA_HOME XDG_CACHE_HOME && {\n" +
                             command + "\n} > printed 2> said";
    const int status = std::system(line.c_str());
    // The samples of a difference differ.
    const int wanted = command.starts_with("burin diff ") ? 6 : 0;
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == wanted) << command << "\n"
                                                                    << test::slurp(root / "said");
    // ~ is a home of its own.
    for (const std::string& name : outputs_of(command)) {
      EXPECT_TRUE(name.starts_with("~") || fs::exists(root / name)) << command;
    }
    if (command.starts_with("burin batch report ")) {
      EXPECT_TRUE(fs::exists(root / "catalogue/index.html"));
      EXPECT_TRUE(fs::exists(root / "catalogue/coupling-apart.pdf"));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Parts, Readme, ::testing::ValuesIn(parts()), [](const auto& part) {
  std::string name;
  for (const char c : part.param.heading) {
    if (is_letter(c) || is_digit(c)) name += c;
  }
  return name;
});

}  // namespace
}  // namespace burin
