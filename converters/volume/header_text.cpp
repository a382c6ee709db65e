#include "header_text.h"

#include "text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace burin::volume {
namespace {

constexpr std::size_t kMaxHeader = std::size_t{1} << 20;
constexpr std::size_t kMaxFields = 1000;

std::optional<std::int64_t> whole(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || error != std::errc() || stop != word.data() + word.size()) return {};
  return value;
}

}  // namespace

std::optional<std::string_view> Lines::next() {
  if (at_ == text_.size()) return std::nullopt;
  ++number_;
  const std::size_t end = text_.find('\n', at_);
  if ((end == std::string_view::npos ? text_.size() : end) > kMaxHeader) {
    fail("the header does not end within a megabyte; the file is damaged");
  }
  std::string_view line = text_.substr(at_, end - at_);
  at_ = end == std::string_view::npos ? text_.size() : end + 1;
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && (is_blank(text.back()) || text.back() == '\r')) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
    const auto end = std::ranges::find_if(text, is_blank);
    words.emplace_back(text.begin(), end);
    text.remove_prefix(words.back().size());
  }
  return words;
}

void Fields::add(Field field) {
  if (find(field.key) != nullptr) {
    fail(field, fmt::format("{} is given a second time", in_quotes(field.key)));
  }
  if (fields_.size() == kMaxFields) fail(field, "the header holds too many fields; it is damaged");
  fields_.push_back(std::move(field));
}

const Field* Fields::find(std::string_view key) const {
  const auto it = std::ranges::find(fields_, key, &Field::key);
  return it == fields_.end() ? nullptr : &*it;
}

const Field* Fields::find_any(std::initializer_list<std::string_view> keys) const {
  for (const std::string_view key : keys) {
    if (const Field* field = find(key)) return field;
  }
  return nullptr;
}

const Field& Fields::need(std::string_view key) const {
  const Field* field = find(key);
  if (field == nullptr) {
    source_.fail(fmt::format("the header has no '{}'; the file is damaged", key));
  }
  return *field;
}

void Fields::fail(const Field& field, const std::string& what) const {
  throw InputError(what, source_.file(), field.line);
}

std::vector<double> Fields::numbers(const Field& field, std::size_t count, bool any) const {
  std::vector<double> values;
  for (const std::string_view word : words_of(field.value)) {
    double value = 0;
    if (!parse_double(word, value) || !(any || std::isfinite(value))) {
      fail(field, fmt::format("{} is no number that '{}' can take", in_quotes(word), field.key));
    }
    values.push_back(value);
  }
  if (values.size() != count) {
    fail(field, fmt::format("'{}' takes {} number{}, not {}", field.key, count,
                            count == 1 ? "" : "s", values.size()));
  }
  return values;
}

std::vector<std::int64_t> Fields::integers(const Field& field, std::size_t count) const {
  std::vector<std::int64_t> values;
  for (const std::string_view word : words_of(field.value)) {
    const auto value = whole(word);
    if (!value) {
      fail(field,
           fmt::format("{} is no whole number, which '{}' takes", in_quotes(word), field.key));
    }
    values.push_back(*value);
  }
  if (values.size() != count) {
    fail(field, fmt::format("'{}' takes {} number{}, not {}", field.key, count,
                            count == 1 ? "" : "s", values.size()));
  }
  return values;
}

std::int64_t Fields::integer(const Field& field) const { return integers(field, 1).front(); }

}  // namespace burin::volume
