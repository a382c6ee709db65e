// What the command prints about itself: versions, manual pages, completions.
#include "models.h"

#include <sys/wait.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <regex>

namespace burin {
namespace {

class CliSelfDescription : public test::CliTest {
 protected:
  /// What a program prints, its errors too; its status is that of the shell.
  std::string said(const std::string& line, int* status = nullptr) {
    std::string out;
    FILE* pipe = popen((line + " 2>&1").c_str(), "r");
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) out += static_cast<char>(c);
    const int ended = pclose(pipe);
    if (status) *status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
    return out;
  }
  bool there(const std::string& program) {
    int status = 0;
    said("command -v " + program, &status);
    return status == 0;
  }
};

TEST_F(CliSelfDescription, TheVersionNamesTheLibraries) {
  ASSERT_EQ(run("--version"), 0);
  EXPECT_TRUE(std::regex_match(
      out_, std::regex("burin \\d+\\.\\d+\\.\\d+\nbuilt with CGAL [\\d.]+, OpenMesh [\\d.]+, .*"
                       "OCCT [\\d.]+.*cairo [\\d.]+\n")))
      << out_;
}

TEST_F(CliSelfDescription, EachCommandHasAPageOfTheManualWithItsOptions) {
  ASSERT_EQ(run("options --manual burin"), 0);
  const std::string all = out_;
  const std::regex named("\\.BR burin\\\\-(\\w+) \\(1\\)");
  std::size_t commands = 0;
  for (auto it = std::sregex_iterator(all.begin(), all.end(), named); it != std::sregex_iterator();
       ++it, ++commands) {
    const std::string command = (*it)[1];
    ASSERT_EQ(run("options --manual " + command), 0) << err_;
    const std::string page = out_;
    EXPECT_TRUE(page.starts_with(".TH BURIN")) << page;
    if (command == "batch" || command == "book") continue;  // these have a parser of their own
    ASSERT_EQ(run(command + " --help"), 0);
    const std::regex option("\n  (?:-\\w,)?(--[a-z-]+)");
    const std::string help = out_;
    for (auto o = std::sregex_iterator(help.begin(), help.end(), option);
         o != std::sregex_iterator(); ++o) {
      const std::string name = std::regex_replace((*o)[1].str(), std::regex("-"), "\\-");
      EXPECT_NE(page.find("\\fB" + name + "\\fR"), std::string::npos) << command << " " << name;
    }
  }
  EXPECT_GE(commands, 11U);
  EXPECT_EQ(run("options --manual drow"), 2);
  EXPECT_NE(err_.find("there is no command drow"), std::string::npos) << err_;
}

TEST_F(CliSelfDescription, ThePagesAreWellFormed) {
  if (!there("groff")) GTEST_SKIP() << "groff is not there";
  for (const char* command : {"burin", "draw", "steps", "diff", "convert"}) {
    const std::string shown = said(std::string(BURIN_COMMAND) + " options --manual " + command +
                                   " | groff -ww -man -Tutf8 -P-cbou -rLL=80n");
    EXPECT_EQ(shown.find("warning"), std::string::npos) << shown.substr(0, 400);
    EXPECT_NE(shown.find("SYNOPSIS"), std::string::npos) << command;
  }
}

TEST_F(CliSelfDescription, BashCompletesCommandsOptionsAndWords) {
  if (!there("bash")) GTEST_SKIP() << "bash is not there";
  const auto completed = [&](const std::string& words) {
    return said("bash -c 'source <(" BURIN_COMMAND " options --completion bash); COMP_WORDS=(" +
                words +
                "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _burin; echo \"${COMPREPLY[@]}\"'");
  };
  EXPECT_EQ(completed("burin dr"), "draw\n");
  EXPECT_EQ(completed("burin draw --expl"), "--explode --explode-factor\n");
  EXPECT_EQ(completed("burin draw --hidden d"), "dashed\n");
  EXPECT_EQ(completed("burin draw --style engr"), "engraving\n");
  EXPECT_EQ(completed("burin info --expl"), "\n");
}

TEST_F(CliSelfDescription, FishCompletesThem) {
  if (!there("fish")) GTEST_SKIP() << "fish is not there";
  const auto completed = [&](const std::string& line) {
    return said("HOME=" + folder_.path() +
                " fish -c '" BURIN_COMMAND " options --completion fish | source; complete -C \"" +
                line + "\"'");
  };
  EXPECT_NE(completed("burin dr").find("draw\t"), std::string::npos);
  EXPECT_NE(completed("burin draw --expl").find("--explode-factor"), std::string::npos);
  EXPECT_NE(completed("burin draw --style engr").find("engraving"), std::string::npos);
}

TEST_F(CliSelfDescription, ZshCompletesThem) {
  if (!there("zsh")) GTEST_SKIP() << "zsh is not there";
  said(BURIN_COMMAND " options --completion zsh > " + folder_.path() + "/_burin");
  // A terminal in which TAB is pressed; it ends where the wanted text stands on the line.
  std::ofstream(folder_.path() + "/tab.zsh") <<
      R"(zmodload zsh/zpty
zpty z zsh -f -i
zpty -w z "PS1='READY '; fpath=($1 "'$fpath); autoload -Uz compinit; compinit -u -D; print GO'
zpty -r z line '*GO*READY '
zpty -w -n z "$2"$'\t'
zpty -r z line "*$3*"
zpty -d z
)";
  const auto completes = [&](const std::string& words, const std::string& wanted) {
    const std::string command = "HOME=" + folder_.path() + " timeout 60 zsh " + folder_.path() +
                                "/tab.zsh " + folder_.path() + " '" + words + "' '" + wanted +
                                "' >/dev/null 2>&1; echo $?";
    return said(command) == "0\n";
  };
  EXPECT_TRUE(completes("burin dr", "burin draw"));
  EXPECT_TRUE(completes("burin draw --sty", "--style"));
  EXPECT_TRUE(completes("burin draw --hidden d", "dashed"));
  EXPECT_TRUE(completes("burin draw --style engr", "engraving"));
}

TEST_F(CliSelfDescription, OtherShellsAreNamed) {
  EXPECT_EQ(run("options --completion tcsh"), 2);
  EXPECT_NE(err_.find("bash, zsh or fish"), std::string::npos) << err_;
  ASSERT_EQ(run("options --completion zsh"), 0);
  EXPECT_TRUE(out_.starts_with("#compdef burin\n"));
}

}  // namespace
}  // namespace burin
