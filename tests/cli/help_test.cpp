// The options that the command prints are those that the manual lists, in the same words.
#include "models.h"

#include <map>
#include <sstream>

namespace burin {
namespace {

/// One blank for any white space, and none of the backslashes that Markdown needs.
std::string plain(const std::string& text) {
  std::string out;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    std::erase(word, '\\');
    out += (out.empty() ? "" : " ") + word;
  }
  return out;
}

/// "--scale S" and what is said about it.
std::map<std::string, std::string> options_of(const std::string& help) {
  constexpr std::size_t kColumn = 28;
  std::map<std::string, std::string> options;
  std::istringstream lines(help);
  std::string name;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("  -")) {
      // Names longer than their column have a line of their own.
      const bool both = line.size() > kColumn && line[kColumn - 1] == ' ';
      name = plain(both ? line.substr(0, kColumn) : line);
      if (name.ends_with(" ...")) name.resize(name.size() - 4);
      options[name] = both ? line.substr(kColumn) : "";
    } else if (!name.empty() && line.starts_with(std::string(kColumn, ' '))) {
      options[name] += " " + line.substr(kColumn);
    } else {
      name.clear();
    }
  }
  return options;
}

class CliHelp : public test::CliTest {};

TEST_F(CliHelp, TheManualHasTheSameOptionsInTheSameWords) {
  const std::string manual = plain(test::slurp(BURIN_SOURCE_DIR "/kernel/docs/reference.md"));
  for (const char* command : {"draw", "convert", "info"}) {
    ASSERT_EQ(run(std::string(command) + " --help"), 0);
    const auto options = options_of(out_);
    EXPECT_GE(options.size(), 8u) << out_;
    for (const auto& [name, text] : options) {
      if (name == "-h,--help") continue;
      EXPECT_FALSE(plain(text).empty()) << name;
      EXPECT_NE(manual.find("| `" + name + "` | " + plain(text) + " |"), std::string::npos)
          << command << ": | `" << name << "` | " << plain(text) << " |";
    }
  }
}

TEST_F(CliHelp, TheWordHelpIsTheOption) {
  for (const std::string command : {"", "draw", "styles", "plugins"}) {
    ASSERT_EQ(run(command + " --help"), 0) << err_;
    const std::string wanted = out_;
    EXPECT_GT(wanted.size(), 100U) << command;
    ASSERT_EQ(run("help " + command), 0) << err_;
    EXPECT_EQ(out_, wanted) << command;
    EXPECT_TRUE(err_.empty()) << err_;
  }
  ASSERT_EQ(run("help help"), 0) << err_;
  EXPECT_NE(out_.find("burin help COMMAND"), std::string::npos) << out_;
}

TEST_F(CliHelp, HelpOfNoCommandNamesTheNearest) {
  EXPECT_EQ(run("help drow"), 2);
  expect_error("unknown command 'drow'; the nearest is 'draw' (see burin --help)");
  EXPECT_EQ(run("hlep"), 2);
  expect_error("the nearest is 'help'");
  EXPECT_EQ(run("help --view"), 2);
  expect_error("unknown option --view; --view is an option of burin draw");
  EXPECT_EQ(run("help draw box.off"), 0) << "as with --help";
}

}  // namespace
}  // namespace burin
