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

}  // namespace
}  // namespace burin
