#include "entity_numbers.h"

#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <set>
#include <tuple>
#include <vector>

namespace burin {
namespace {

// OCCT keeps numbers in 32 bits.
constexpr std::int64_t kHighest = std::numeric_limits<std::int32_t>::max();

/// `#12` somewhere in the text.
struct Number {
  std::int64_t value = 0;
  const char *begin = nullptr, *end = nullptr;  // of the digits
  bool quoted = false, defines = false;

  std::string_view digits() const { return {begin, static_cast<std::size_t>(end - begin)}; }
};

/// The numbers of a text that matter: those of entities, and all that are too large for OCCT.
class Numbers {
 public:
  explicit Numbers(std::string_view text) : at_(text.data()), end_(at_ + text.size()) {
    while (at_ != end_) step();
    // A quote too many or too few: what OCCT takes for a string cannot be known.
    if (quoted_ || !quotes_close_lists_) return;
    const auto quoted = [](const Number& number) { return number.quoted; };
    std::erase_if(entities, quoted);
    std::erase_if(large, quoted);
  }

  std::vector<Number> entities, large;
  /// Of all that OCCT can keep.
  std::int64_t highest = 0;

 private:
  void step() {
    const char c = *at_++;
    if (c == '\'') {
      quote();
    } else if (c == '#') {
      number();
    } else if (c == '/' && !quoted_ && at_ != end_ && *at_ == '*') {
      const std::string_view rest(at_ + 1, static_cast<std::size_t>(end_ - at_ - 1));
      const std::size_t close = rest.find("*/");
      at_ = close == std::string_view::npos ? end_ : at_ + 1 + close + 2;
    }
  }
  void quote() {
    if (!quoted_) {
      quoted_ = true;
    } else if (at_ != end_ && *at_ == '\'') {
      ++at_;  // one that belongs to the string
    } else {
      quoted_ = false;
      const char* next = at_;
      while (next != end_ && (*next == ' ' || *next == '\n' || *next == '\r')) ++next;
      if (next == end_ || (*next != ',' && *next != ')')) quotes_close_lists_ = false;
    }
  }
  void number() {
    Number number{0, at_, at_, quoted_, false};
    while (at_ != end_ && is_digit(*at_)) ++at_;
    number.end = at_;
    if (number.begin == at_) return;
    const char* next = at_;
    while (next != end_ && (*next == ' ' || *next == '\t')) ++next;
    number.defines = next != end_ && *next == '=';
    const auto [rest, fault] = std::from_chars(number.begin, at_, number.value);
    if (fault != std::errc() || number.value > kHighest) {
      large.push_back(number);
      return;
    }
    highest = std::max(highest, number.value);
    if (number.defines) entities.push_back(number);
  }

  const char *at_ = nullptr, *end_ = nullptr;
  bool quoted_ = false, quotes_close_lists_ = true;
};

/// Those entities whose number another one has already, in the order of the numbers.
std::vector<Number> later_ones(std::vector<Number>& entities) {
  // Of those that may be words of a name none keeps the number of another.
  std::ranges::sort(entities, {}, [](const Number& number) {
    return std::tuple(number.value, number.quoted, number.begin);
  });
  std::vector<Number> later;
  for (std::size_t i = 1; i < entities.size(); ++i) {
    if (entities[i - 1].value == entities[i].value) later.push_back(entities[i]);
  }
  return later;
}

void report(const Source& source, const std::vector<Number>& later, Diagnostics& diagnostics) {
  if (later.empty()) return;
  diagnostics.add(Severity::Warning, "step.same_number", std::ssize(later),
                  fmt::format("entities have the number of another, which is used in their place; "
                              "the first: #{} in line {}",
                              later.front().digits(), source.line_of(later.front().begin)));
}

}  // namespace

std::string unique_entity_numbers(const Source& source, Diagnostics& diagnostics) {
  const std::string_view text = source.bytes();
  Numbers numbers(text);
  std::vector<Number> changes = later_ones(numbers.entities);
  report(source, changes, diagnostics);
  if (changes.empty() && numbers.large.empty()) return {};

  std::int64_t next = numbers.highest;
  for (Number& number : changes) number.value = ++next;
  // Entities and what refers to them get the same one.
  std::map<std::string_view, std::int64_t> given;
  std::set<std::string_view> defined;
  for (Number& number : numbers.large) {
    const bool later = number.defines && !defined.insert(number.digits()).second;
    const auto [at, added] = given.try_emplace(number.digits(), next + 1);
    if (added || later) ++next;
    number.value = later ? next : at->second;
    changes.push_back(number);
  }
  if (next > kHighest) {
    source.fail(
        "has entity numbers up to the end of 32 bits and beyond, which OCCT cannot read; "
        "export the model again");
  }
  std::ranges::sort(changes, {}, &Number::begin);
  std::string changed;
  changed.reserve(text.size() + 10 * changes.size());
  const char* from = text.data();
  for (const Number& number : changes) {
    changed.append(from, number.begin).append(std::to_string(number.value));
    from = number.end;
  }
  return changed.append(from, text.data() + text.size());
}

}  // namespace burin
