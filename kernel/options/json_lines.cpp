#include <burin/options/json_lines.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

namespace burin {
namespace {

using Json = nlohmann::ordered_json;

// Characters of a text, counting its lines as they are read.
class Counting {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  Counting(const char* at, std::int64_t* line) : at_(at), line_(line) {}
  reference operator*() const { return *at_; }
  Counting& operator++() {
    if (*at_ == '\n') ++*line_;
    ++at_;
    return *this;
  }
  Counting operator++(int) {
    const Counting before = *this;
    ++*this;
    return before;
  }
  bool operator==(const Counting& o) const { return at_ == o.at_; }
  bool operator!=(const Counting& o) const { return at_ != o.at_; }

 private:
  const char* at_;
  std::int64_t* line_;
};

// An object or array that is being read.
struct Level {
  bool array = false;
  std::int64_t index = -1;
  std::string key;
  std::set<std::string> keys = {};
};

}  // namespace

JsonLines::JsonLines(std::string_view text) {
  std::int64_t line = 1;
  std::vector<Level> levels;
  const auto note = [&] {
    std::string path;
    for (const Level& level : levels) {
      path += '/';
      path += level.array ? std::to_string(level.index) : level.key;
    }
    lines_.try_emplace(std::move(path), line);
  };
  const auto element = [&] {
    if (levels.empty() || !levels.back().array) return;
    ++levels.back().index;
    note();
  };
  const auto hear = [&](int /*depth*/, Json::parse_event_t event, Json& parsed) {
    switch (event) {
      case Json::parse_event_t::key:
        levels.back().key = parsed.get<std::string>();
        if (!levels.back().keys.insert(levels.back().key).second && !repeated_) {
          repeated_.emplace(levels.back().key, line);
        }
        note();
        break;
      case Json::parse_event_t::value:
        element();
        break;
      case Json::parse_event_t::object_start:
      case Json::parse_event_t::array_start:
        element();
        levels.push_back({event == Json::parse_event_t::array_start, -1, {}});
        break;
      case Json::parse_event_t::object_end:
      case Json::parse_event_t::array_end:
        levels.pop_back();
        break;
    }
    return true;
  };
  const Json read = Json::parse(Counting(text.data(), &line),
                                Counting(text.data() + text.size(), &line), hear, false, true);
  if (read.is_discarded()) lines_.clear();
  last_ = line;
}

std::int64_t JsonLines::line(std::string_view path) const {
  while (!path.empty()) {
    const auto found = lines_.find(path);
    if (found != lines_.end()) return found->second;
    path = path.substr(0, path.rfind('/'));
  }
  return 1;
}

std::int64_t line_at(std::string_view text, std::size_t position) {
  const auto end = static_cast<std::ptrdiff_t>(std::min(position, text.size()));
  return 1 + std::count(text.begin(), text.begin() + end, '\n');
}

void check_no_utf16(std::string_view text, const std::string& source) {
  if (!text.starts_with("\xff\xfe") && !text.starts_with("\xfe\xff")) return;
  throw InputError("is text in UTF-16; save it as UTF-8", source);
}

}  // namespace burin
