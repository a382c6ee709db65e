#include "json_place.h"

#include <burin/base/error.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace burin {
namespace {

template <class Int>
void set_whole(const JsonPlace& place, Int& out) {
  const auto& value = place.value();
  constexpr auto kLow = std::numeric_limits<Int>::min();
  constexpr auto kHigh = std::numeric_limits<Int>::max();
  bool good = false;
  if (value.is_number_unsigned()) {
    const auto n = value.get<std::uint64_t>();
    good = n <= static_cast<std::uint64_t>(kHigh);
    if (good) out = static_cast<Int>(n);
  } else if (value.is_number_integer()) {
    const auto n = value.get<std::int64_t>();
    good = n >= static_cast<std::int64_t>(kLow) && (std::is_signed_v<Int> || n >= 0) &&
           (n < 0 || static_cast<std::uint64_t>(n) <= static_cast<std::uint64_t>(kHigh));
    if (good) out = static_cast<Int>(n);
  }
  if (!good) place.fail(fmt::format("takes a whole number from {} to {}", kLow, kHigh));
}

}  // namespace

void JsonPlace::append_to(std::string& out) const {
  if (!parent_) {
    out += root_;
    return;
  }
  parent_->append_to(out);
  if (key_) {
    if (!out.empty()) out += '.';
    out += key_;
  } else {
    out += fmt::format("[{}]", index_);
  }
}

std::string JsonPlace::where() const {
  std::string out;
  append_to(out);
  return out;
}

void JsonPlace::fail(const std::string& what) const {
  const std::string place = where();
  throw InputError(place.empty() ? "the drawing " + what : place + ": " + what);
}

void JsonPlace::set(std::string& out) const {
  if (!value_.is_string()) fail("takes text");
  out = value_.get_ref<const std::string&>();
}

void JsonPlace::set(bool& out) const {
  if (!value_.is_boolean()) fail("takes true or false");
  out = value_.get<bool>();
}

void JsonPlace::set(double& out) const {
  if (!value_.is_number()) fail("takes a number");
  out = value_.get<double>();
  if (!std::isfinite(out)) fail("takes a finite number");
}

void JsonPlace::set(std::int32_t& out) const { set_whole(*this, out); }
void JsonPlace::set(std::int64_t& out) const { set_whole(*this, out); }
void JsonPlace::set(std::uint32_t& out) const { set_whole(*this, out); }
void JsonPlace::set(std::uint64_t& out) const { set_whole(*this, out); }

}  // namespace burin
