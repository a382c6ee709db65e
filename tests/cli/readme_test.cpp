// What README says, done.
#include "models.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace burin {
namespace {

namespace fs = std::filesystem;

/// The commands that README tells, without those that never end.
std::vector<std::string> commands() {
  std::vector<std::string> found;
  std::ifstream in(std::string(BURIN_SOURCE_DIR) + "/README.md");
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("    burin watch ")) continue;
    for (const std::string begin : {"    burin ", "    build/release/bin/burin "}) {
      if (line.starts_with(begin)) found.push_back("burin " + line.substr(begin.size()));
    }
    for (const std::string begin : {"    mkdir ", "    cc "}) {
      if (line.starts_with(begin)) found.push_back(line);
    }
  }
  return found;
}

TEST(Readme, ItsCommandsDoWhatTheySay) {
  const test::Folder folder;
  const fs::path root = folder.path();
  fs::create_directory_symlink(std::string(BURIN_SOURCE_DIR) + "/samples", root / "samples");
  fs::create_directory_symlink(std::string(BURIN_SOURCE_DIR) + "/kernel", root / "kernel");
  fs::create_directory(root / "bin");
  fs::create_symlink(BURIN_COMMAND, root / "bin" / "burin");
  // The reader's own part.
  fs::copy_file(std::string(BURIN_SOURCE_DIR) + "/samples/spindle.stl", root / "part.stl");
  const std::vector<std::string> all = commands();
  EXPECT_GE(all.size(), 10U);
  for (const std::string& command : all) {
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
  }
  // A catalogue, and an assembly explained: the exploded, numbered picture with its list, a
  // section, the page that can be clicked, and the step book.
  for (const char* name :
       {"pump.pdf", "pump.html", "section.svg", "pump.burin.json", "pump-steps.pdf",
        "pump-steps.html", "views.pdf", "caster.svg", "apart.svg", "catalogue/index.html",
        "catalogue/coupling-apart.pdf", "diff.svg", "diff.html"}) {
    EXPECT_TRUE(fs::exists(root / name)) << name;
  }
}

}  // namespace
}  // namespace burin
