#pragma once
/// Small models as files, and what the tests of the command share.

#include <burin_test/command.h>
#include <burin_test/shapes.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace burin::test {

inline std::string off_text(const TriMesh& m) {
  std::string text = fmt::format("OFF\n{} {} 0\n", m.positions.size(), m.triangles.size());
  for (const Vec3& p : m.positions) text += fmt::format("{} {} {}\n", p.x, p.y, p.z);
  for (const Triangle& t : m.triangles) text += fmt::format("3 {} {} {}\n", t[0], t[1], t[2]);
  return text;
}

inline std::string box_off() { return off_text(box({0, 0, 0}, {40, 30, 20})); }

/// A folder with a box in it.
class CliTest : public ::testing::Test {
 protected:
  void SetUp() override { box_ = folder_.write("box.off", box_off()); }

  /// Runs with the words of a line split at blanks; "@" stands for the folder. `in`: a file of it
  /// that is piped into the command. Drawings have the sheet `kSheet` where neither the line nor an
  /// illustration says anything of it.
  int run(const std::string& line, const std::string& in = "") {
    std::vector<std::string> words = words_of(line);
    if (!words.empty() && words[0] == "draw") give_sheet(words);
    return run_words(words, in);
  }
  /// Without a word more.
  int run_as_it_stands(const std::string& line) { return run_words(words_of(line), ""); }

  std::vector<std::string> words_of(const std::string& line) const {
    std::vector<std::string> words;
    std::string word;
    for (const char c : line + " ") {
      if (c == '@') {
        word += folder_.path();
      } else if (c != ' ') {
        word += c;
      } else if (!word.empty()) {
        words.push_back(word);
        word.clear();
      }
    }
    return words;
  }
  int run_words(const std::vector<std::string>& words, const std::string& in) {
    Command command(folder_, words, "", in.empty() ? "/dev/null" : folder_ / in);
    const int status = command.wait();
    peak_mb_ = command.peak_megabytes;
    out_ = command.std_out;
    err_ = command.std_err;
    return status;
  }

  /// What drawing an illustration of this text is refused with: one line that names its third.
  std::string refused_illustration(const std::string& text) {
    folder_.write("a.burin.json", text);
    EXPECT_EQ(run("draw @/a.burin.json -o @/a.json"), 2) << text;
    EXPECT_NE(err_.find("a.burin.json:3: "), std::string::npos) << err_;
    EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
    return err_;
  }

  /// That the last run said one line of error that holds `part`.
  void expect_error(const std::string& part) const {
    EXPECT_TRUE(err_.starts_with("burin: error: ")) << err_;
    EXPECT_EQ(std::count(err_.begin(), err_.end(), '\n'), 1) << err_;
    EXPECT_NE(err_.find(part), std::string::npos) << err_ << " lacks " << part;
  }

  /// A quarter of A4, whose strokes take a fifth of the time.
  static constexpr const char* kSheet = "A6";
  static void give_sheet(std::vector<std::string>& words) {
    const auto names_one = [](const std::string& word) {
      if (word.starts_with("--paper") || word.starts_with("--scale")) return true;
      if (!word.ends_with(".burin.json")) return false;
      const std::string text = slurp(word);
      return text.find("\"paper\"") != text.npos || text.find("\"scale\"") != text.npos ||
             text.find("\"extends\"") != text.npos;
    };
    if (std::ranges::none_of(words, names_one))
      words.insert(words.begin() + 1, {"--paper", kSheet});
  }

  Folder folder_;
  std::string box_, out_, err_;
  double peak_mb_ = 0;
};

}  // namespace burin::test
