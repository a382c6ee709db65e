#include "step_text.h"

#include <burin/drawing/text.h>

#include "text.h"

#include <algorithm>
#include <cstdlib>
#include <initializer_list>

namespace burin {
namespace {

bool is_step_type(char c) { return (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_' || c == '!'; }

/// The place behind blanks and comments.
std::size_t behind_blanks(std::string_view text, std::size_t at) {
  while (at < text.size()) {
    if (text[at] == ' ' || is_line_end(text[at]) || text[at] == '\t') {
      ++at;
    } else if (text.substr(at, 2) == "/*") {
      const std::size_t end = text.find("*/", at + 2);
      at = end == std::string_view::npos ? text.size() : end + 2;
    } else {
      break;
    }
  }
  return at;
}

/// The place of the semicolon that ends what begins at `at`.
std::size_t end_of(std::string_view text, std::size_t at) {
  for (; at < text.size() && text[at] != ';'; ++at) {
    if (text[at] == '\'') {
      at = std::min(text.find('\'', at + 1), text.size() - 1);
    } else if (text[at] == '/' && text.substr(at, 2) == "/*") {
      at = behind_blanks(text, at) - 1;
    }
  }
  return at;
}

/// The characters that a text has in hexadecimal digits, `digits` a character.
void append_hex(std::string_view hex, std::size_t digits, std::string& out) {
  for (std::size_t i = 0; i + digits <= hex.size(); i += digits) {
    const auto code = std::strtoul(std::string(hex.substr(i, digits)).c_str(), nullptr, 16);
    out += utf8_of(static_cast<char32_t>(code));
  }
}

/// The text between quotes: doubled quotes and control directives become what they stand for.
std::string decoded(std::string_view raw) {
  std::string out;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    const std::string_view rest = raw.substr(i);
    if (rest.starts_with("''")) {
      out += '\'';
      ++i;
    } else if (rest.starts_with("\\X2\\") || rest.starts_with("\\X4\\")) {
      const std::size_t end = std::min(rest.find("\\X0\\"), rest.size());
      append_hex(rest.substr(4, end - std::min<std::size_t>(4, end)), rest[2] == '2' ? 4 : 8, out);
      i += std::min(end + 4, rest.size()) - 1;
    } else if (rest.starts_with("\\X\\") && rest.size() >= 5) {
      append_hex(rest.substr(3, 2), 2, out);
      i += 4;
    } else if (rest.starts_with("\\S\\") && rest.size() >= 4) {
      out += utf8_of(static_cast<unsigned char>(rest[3]) + 128U);
      i += 3;
    } else if (rest.starts_with("\\\\")) {
      out += '\\';
      ++i;
    } else {
      out += raw[i];
    }
  }
  return clean_name(out);
}

/// Reads the parameters of entities.
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  std::vector<StepRecord> records() {
    std::vector<StepRecord> out;
    const bool several = take('(');
    do {
      StepRecord one{word()};
      if (one.type.empty()) break;
      one.values = list(0);
      out.push_back(std::move(one));
    } while (several && peek() != ')' && peek() != '\0');
    return out;
  }

 private:
  // Lists in each other; no schema has that many.
  static constexpr int kDeepest = 32;

  char peek() {
    at_ = behind_blanks(text_, at_);
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  std::string_view word() {
    peek();
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_step_type(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  std::vector<StepValue> list(int depth) {
    std::vector<StepValue> items;
    if (!take('(') || depth > kDeepest) return items;
    while (peek() != ')' && peek() != '\0') {
      items.push_back(value(depth));
      if (!take(',') && peek() != ')') break;
    }
    take(')');
    return items;
  }

  StepValue value(int depth) {
    using Kind = StepValue::Kind;
    const char c = peek();
    if (c == '(') return {.kind = Kind::List, .items = list(depth + 1)};
    if (c == '\'') return {.kind = Kind::Text, .text = quoted()};
    if (c == '.' && at_ + 1 < text_.size() && !is_digit(text_[at_ + 1])) return enumerated();
    if (c == '#') {
      ++at_;
      return {.kind = Kind::Reference, .entity = std::strtoll(digits().c_str(), nullptr, 10)};
    }
    if (is_step_type(c) && !is_digit(c)) {
      StepValue typed{.kind = Kind::Typed, .text = std::string(word())};
      typed.items = list(depth + 1);
      return typed;
    }
    return number();
  }

  std::string quoted() {
    const std::size_t begin = ++at_;
    while (at_ < text_.size() && (text_[at_] != '\'' || text_.substr(at_, 2) == "''")) {
      at_ += text_[at_] == '\'' ? 2 : 1;
    }
    const std::string_view raw = text_.substr(begin, std::min(at_, text_.size()) - begin);
    ++at_;
    return decoded(raw);
  }

  StepValue enumerated() {
    const std::size_t end = std::min(text_.find('.', at_ + 1), text_.size() - 1);
    StepValue out{.kind = StepValue::Kind::Word,
                  .text = std::string(text_.substr(at_ + 1, end - at_ - 1))};
    at_ = end + 1;
    return out;
  }

  std::string digits() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
    return std::string(text_.substr(begin, at_ - begin));
  }

  StepValue number() {
    StepValue out;
    const char* begin = text_.data() + at_;
    const char* end = scan_double(begin, text_.data() + text_.size(), out.number);
    if (end != nullptr) {
      out.kind = StepValue::Kind::Number;
      at_ += static_cast<std::size_t>(end - begin);
    } else {
      ++at_;  // `$`, `*`, or what is none of all this
    }
    return out;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

double StepValue::as_number() const {
  if (kind == Kind::Typed && items.size() == 1) return items.front().number;
  return number;
}

std::vector<std::int64_t> StepValue::references() const {
  if (kind == Kind::Reference) return {entity};
  std::vector<std::int64_t> all;
  for (const StepValue& item : items) {
    const std::vector<std::int64_t> more = item.references();
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

const StepValue& StepRecord::at(std::size_t i) const {
  static const StepValue none;
  return i < values.size() ? values[i] : none;
}

const StepRecord* StepEntity::as(std::string_view type) const {
  const auto found = std::ranges::find(records, type, &StepRecord::type);
  return found == records.end() ? nullptr : &*found;
}

const StepRecord* StepEntity::as_one_of(std::initializer_list<std::string_view> types) const {
  for (const std::string_view type : types) {
    if (const StepRecord* record = as(type)) return record;
  }
  return nullptr;
}

StepText::StepText(std::string_view text, const RunContext& context) : text_(text) {
  constexpr std::size_t kBetweenChecks = 1U << 20;
  std::size_t at = std::min(text.find("DATA"), text.size()), checked = at;
  while (at < text.size()) {
    if (at > checked + kBetweenChecks) context.check(), checked = at;
    at = behind_blanks(text, at);
    const std::size_t end = end_of(text, at);
    if (at < text.size() && text[at] == '#') {
      const std::size_t number = at + 1;
      while (++at < end && is_digit(text[at])) continue;
      const std::string digits(text.substr(number, at - number));
      at = behind_blanks(text, at);
      if (at < end && text[at] == '=') {
        add(std::strtoll(digits.c_str(), nullptr, 10), at + 1, end);
      }
    }
    at = end + 1;
  }
  std::ranges::stable_sort(entities_, {}, &std::pair<std::int64_t, std::string_view>::first);
}

void StepText::add(std::int64_t number, std::size_t begin, std::size_t end) {
  const std::string_view all = text_.substr(begin, end - begin);
  entities_.emplace_back(number, all);
  // The words outside of all parentheses, of an entity of several types outside of all but one.
  const std::size_t first = behind_blanks(all, 0);
  const int outside = first < all.size() && all[first] == '(' ? 1 : 0;
  int depth = 0;
  for (std::size_t at = first; at < all.size(); ++at) {
    const char c = all[at];
    if (c == '\'') {
      at = std::min(all.find('\'', at + 1), all.size() - 1);
    } else if (c == '(') {
      ++depth;
    } else if (c == ')') {
      --depth;
    } else if (depth == outside && is_step_type(c)) {
      std::size_t behind = at;
      while (behind < all.size() && is_step_type(all[behind])) ++behind;
      types_[all.substr(at, behind - at)].push_back(number);
      if (outside == 0) return;
      at = behind - 1;
    }
  }
}

StepEntity StepText::entity(std::int64_t number) const {
  const auto found = std::ranges::lower_bound(entities_, number, {},
                                              &std::pair<std::int64_t, std::string_view>::first);
  if (found == entities_.end() || found->first != number) return {};
  return {Parser(found->second).records()};
}

const std::vector<std::int64_t>& StepText::of_type(std::string_view type) const {
  static const std::vector<std::int64_t> none;
  const auto found = types_.find(type);
  return found == types_.end() ? none : found->second;
}

std::vector<std::string_view> StepText::types() const {
  std::vector<std::string_view> all;
  for (const auto& [type, numbers] : types_) all.push_back(type);
  return all;
}

}  // namespace burin
