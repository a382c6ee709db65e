#include <burin/annotate/letters.h>

#include <algorithm>
#include <string_view>

namespace burin {

std::string next_letter(std::span<const std::string> taken) {
  constexpr std::string_view kLetters = "ABCDEFGHJKLMNPRSTUVWXYZ";
  std::string letter;
  for (const char c : kLetters) {
    letter = std::string(1, c);
    if (std::ranges::find(taken, letter) == taken.end()) break;
  }
  return letter;
}

}  // namespace burin
