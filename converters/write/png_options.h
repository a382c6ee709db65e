#pragma once
/// What a user chooses of PNG.

#include <burin/options/declared.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace burin {

struct PngOptions {
  static constexpr std::string_view kRow = "png";
  static std::vector<OptionRow<PngOptions>> rows() {
    return {
        options::number("dpi", &PngOptions::dpi, {10, 4800}, "pixels an inch"),
        options::word("background", &PngOptions::background, {"white", "transparent"},
                      "what is no ink"),
    };
  }
  static std::map<std::string, std::vector<std::string>> other_names() {
    return {{"dpi", {"resolution", "pixels", "ppi", "px", "image size", "pixel size"}},
            {"background", {"transparent background", "no background"}}};
  }

  /// Pixels per inch; also written into the file, so that pictures are shown in their true size.
  double dpi = 300;
  enum class Background { White, Transparent };
  Background background = Background::White;
};

}  // namespace burin
