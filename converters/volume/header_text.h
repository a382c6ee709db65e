#pragma once
// Headers of lines.

#include "source.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace burin::volume {

// The lines of a text, without their ends.
class Lines {
 public:
  explicit Lines(const Source& source) : source_(source), text_(source.bytes()) {}

  // None at the end of the text. Throws where the header goes on for a megabyte.
  std::optional<std::string_view> next();
  // Of the line that `next` gave, from 1.
  std::int64_t number() const { return number_; }
  // The byte after that line.
  std::size_t offset() const { return at_; }
  [[noreturn]] void fail(const std::string& what) const { fail_at(number_, what); }
  [[noreturn]] void fail_at(std::int64_t line, const std::string& what) const {
    throw InputError(what, source_.file(), line);
  }

 private:
  const Source& source_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::int64_t number_ = 0;
};

std::string_view trimmed(std::string_view text);
std::vector<std::string_view> words_of(std::string_view text);

// What a header says about one thing, and where.
struct Field {
  std::string key;
  std::string_view value;
  std::int64_t line = 0;
};

// Values of fields; errors name the line.
class Fields {
 public:
  explicit Fields(const Source& source) : source_(source) {}
  void add(Field field);
  const Field* find(std::string_view key) const;
  // The first of these keys that is there.
  const Field* find_any(std::initializer_list<std::string_view> keys) const;
  const Field& need(std::string_view key) const;
  [[noreturn]] void fail(const Field& field, const std::string& what) const;

  // Exactly `count` numbers; all finite unless `any`.
  std::vector<double> numbers(const Field& field, std::size_t count, bool any = false) const;
  std::int64_t integer(const Field& field) const;
  std::vector<std::int64_t> integers(const Field& field, std::size_t count) const;

 private:
  const Source& source_;
  std::vector<Field> fields_;
};

}  // namespace burin::volume
