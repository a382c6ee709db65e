#include "trial.h"

#include "symbol_check.h"
#include "table_check.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <string_view>
#include <vector>

namespace burin::plugin {
namespace {

constexpr std::size_t kPlaces = 64;
// Behind the arrays that a plug-in fills: what it finds there it has to leave.
constexpr std::size_t kBeyond = 8;
constexpr double kMark = -12345.678;

using Numbers = std::vector<double>;

/// An array of `n` numbers and what lies behind it.
class Filled {
 public:
  explicit Filled(std::size_t n, double value = 0) : n_(n), all_(n + kBeyond, kMark) {
    std::fill_n(all_.begin(), n, value);
  }
  double* data() { return all_.data(); }
  double operator[](std::size_t i) const { return all_[i]; }
  std::string fault() const {
    for (std::size_t i = n_; i < all_.size(); ++i) {
      if (all_[i] != kMark) return "writes behind the end of an array";
    }
    for (std::size_t i = 0; i < n_; ++i) {
      if (!std::isfinite(all_[i])) return "gives something that is no number";
    }
    return {};
  }

 private:
  std::size_t n_;
  Numbers all_;
};

/// Places of a torus with radii 3 and 1.
struct Places {
  Numbers position, normal, k1, k2, d1, d2, zero = Numbers(3 * kPlaces);
  std::vector<std::int32_t> part = std::vector<std::int32_t>(kPlaces);

  Places() {
    for (std::size_t i = 0; i < kPlaces; ++i) {
      const double u = 2 * std::numbers::pi * static_cast<double>(i) / kPlaces, v = 5 * u + 0.1;
      const double c = std::cos(u), s = std::sin(u), r = 3 + std::cos(v);
      add(position, {r * c, r * s, std::sin(v)});
      add(normal, {std::cos(v) * c, std::cos(v) * s, std::sin(v)});
      const double around = std::cos(v) / r;
      k1.push_back(std::max(1.0, around));
      k2.push_back(std::min(1.0, around));
      add(d1, {-std::sin(v) * c, -std::sin(v) * s, std::cos(v)});
      add(d2, {-s, c, 0});
    }
  }
  burin_points from(std::size_t i, std::size_t count) const {
    return {count,      &position[3 * i], &normal[3 * i], &k1[i],       &k2[i],
            &d1[3 * i], &d2[3 * i],       &zero[3 * i],   &zero[3 * i], &part[i]};
  }

 private:
  static void add(Numbers& to, std::initializer_list<double> v) {
    to.insert(to.end(), v.begin(), v.end());
  }
};

const burin_view kView{{0.6, -0.6, std::sqrt(0.28)},
                       {0.7071067811865476, 0.7071067811865476, 0},
                       {-0.37416573867739417, 0.37416573867739417, 0.848528137423857},
                       {0, 0, 0},
                       0,
                       10,
                       {0, 0, 1},
                       {0, 0, 1},
                       {-4, -4, -1},
                       {4, 4, 1}};

std::vector<burin_value> fallbacks(const burin_factory& f) {
  std::vector<burin_value> values;
  for (std::size_t i = 0; i < f.option_count; ++i) values.push_back(f.options[i].fallback);
  return values;
}

/// What one function of a plug-in came to.
std::string reported(const char* what, std::int32_t code, const burin_error& error) {
  if (code == BURIN_OK) return {};
  const std::string_view text(error.message, ::strnlen(error.message, sizeof error.message));
  return std::string(what) + " gives error " + std::to_string(code) +
         (text.empty() ? "" : ": " + std::string(text));
}

/// What `make` made, until the end of the trial.
class MadeForTrial {
 public:
  explicit MadeForTrial(void (*destroy)(void*)) : destroy_(destroy) {}
  ~MadeForTrial() {
    if (whole && destroy_ != nullptr) destroy_(self);
  }
  MadeForTrial(const MadeForTrial&) = delete;
  MadeForTrial& operator=(const MadeForTrial&) = delete;

  void* self = nullptr;
  bool whole = false;

 private:
  void (*destroy_)(void*);
};

std::string first(std::initializer_list<std::string> faults) {
  for (const std::string& fault : faults) {
    if (!fault.empty()) return fault;
  }
  return {};
}

constexpr const char* kOneByOne = "answers otherwise when it is asked about one place at a time";

std::string try_direction(const burin_factory& f) {
  const auto& d = *static_cast<const burin_direction_1*>(f.functions);
  burin_error error{};
  MadeForTrial made(d.destroy);
  std::string fault =
      reported("make", d.make(&kView, fallbacks(f).data(), &made.self, &error), error);
  if (!fault.empty()) return fault;
  made.whole = true;
  const Places places;
  Filled a(3 * kPlaces), b(3 * kPlaces), certainty(kPlaces, 0.5);
  const burin_points all = places.from(0, kPlaces);
  fault =
      reported("directions",
               d.directions(made.self, &all, a.data(), b.data(), certainty.data(), &error), error);
  fault = first({fault, a.fault(), b.fault(), certainty.fault()});
  for (std::size_t i = 0; i < kPlaces && fault.empty(); ++i) {
    Filled one(3), second(3), sure(1, 0.5);
    const burin_points at = places.from(i, 1);
    fault = reported("directions",
                     d.directions(made.self, &at, one.data(), second.data(), sure.data(), &error),
                     error);
    fault = first({fault, one.fault(), second.fault(), sure.fault()});
    for (std::size_t k = 0; k < 3 && fault.empty(); ++k) {
      if (one[k] != a[3 * i + k] || second[k] != b[3 * i + k]) fault = kOneByOne;
    }
  }
  return fault;
}

std::string try_law(const burin_factory& f) {
  const auto& law = *static_cast<const burin_law_1*>(f.functions);
  burin_error error{};
  MadeForTrial made(law.destroy);
  std::string fault =
      reported("make", law.make(&kView, fallbacks(f).data(), &made.self, &error), error);
  if (!fault.empty()) return fault;
  made.whole = true;
  const Places places;
  Filled all(kPlaces);
  fault = reported("reflectances",
                   law.reflectances(made.self, kPlaces, places.position.data(),
                                    places.normal.data(), all.data(), &error),
                   error);
  fault = first({fault, all.fault()});
  for (std::size_t i = 0; i < kPlaces && fault.empty(); ++i) {
    Filled one(1);
    fault = reported("reflectances",
                     law.reflectances(made.self, 1, &places.position[3 * i], &places.normal[3 * i],
                                      one.data(), &error),
                     error);
    fault = first({fault, one.fault()});
    if (fault.empty() && one[0] != all[i]) fault = kOneByOne;
  }
  return fault;
}

std::string try_marks(const burin_factory& f) {
  const auto& k = *static_cast<const burin_stroke_kind_1*>(f.functions);
  burin_error error{};
  MadeForTrial made(k.destroy);
  std::string fault =
      reported("make", k.make(&kView, fallbacks(f).data(), &made.self, &error), error);
  if (!fault.empty()) return fault;
  made.whole = true;
  const Places places;
  Numbers ink, random;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    ink.push_back(static_cast<double>(i) / kPlaces);
    random.push_back(static_cast<double>((37 * i) % kPlaces) / kPlaces);
  }
  const burin_places at{kPlaces,    places.position.data(), places.normal.data(), places.d1.data(),
                        ink.data(), random.data()};
  std::vector<std::uint32_t> count(kPlaces + kBeyond, 0);
  std::vector<unsigned char> begins(k.most * kPlaces + kBeyond, 0);
  Filled points(2 * k.most * kPlaces);
  fault = reported(
      "marks", k.marks(made.self, &at, count.data(), points.data(), begins.data(), &error), error);
  fault = first({fault, points.fault()});
  for (std::size_t i = 0; i < count.size() && fault.empty(); ++i) {
    if (count[i] > (i < kPlaces ? k.most : 0)) fault = "gives more points than a mark may have";
  }
  return fault;
}

std::string try_function(const burin_form_1& s, const void* self) {
  burin_error error{};
  double low[3]{}, high[3]{};
  std::string fault = reported("bounds", s.bounds(self, low, high, &error), error);
  for (int i = 0; i < 3 && fault.empty(); ++i) {
    if (!(std::isfinite(low[i]) && std::isfinite(high[i]) && low[i] < high[i])) {
      fault = "has bounds that are no box";
    }
  }
  if (!fault.empty()) return fault;
  Numbers at;
  for (std::size_t i = 0; i < 3 * kPlaces; ++i) {
    const double share = static_cast<double>((29 * i) % (3 * kPlaces)) / (3 * kPlaces);
    at.push_back(low[i % 3] + share * (high[i % 3] - low[i % 3]));
  }
  Filled values(kPlaces), gradients(3 * kPlaces), alone(kPlaces);
  fault = reported(
      "values", s.values(self, kPlaces, at.data(), values.data(), gradients.data(), &error), error);
  fault = first({fault, values.fault(), gradients.fault()});
  if (fault.empty()) {
    fault = reported("values", s.values(self, kPlaces, at.data(), alone.data(), nullptr, &error),
                     error);
    fault = first({fault, alone.fault()});
  }
  for (std::size_t i = 0; i < kPlaces && fault.empty(); ++i) {
    if (alone[i] != values[i]) fault = "gives other values beside gradients than without";
  }
  return fault;
}

std::string try_patch(const burin_form_1& s, const void* self) {
  burin_error error{};
  double domain[4]{};
  std::int32_t closed[2]{};
  std::string fault = reported("domain", s.domain(self, domain, closed, &error), error);
  for (int i = 0; i < 4 && fault.empty(); ++i) {
    if (!std::isfinite(domain[i])) fault = "has a domain that is no rectangle";
  }
  if (fault.empty() && !(domain[0] < domain[1] && domain[2] < domain[3])) {
    fault = "has a domain that is no rectangle";
  }
  if (!fault.empty()) return fault;
  Numbers uv;
  for (std::size_t i = 0; i < 2 * kPlaces; ++i) {
    const double share = static_cast<double>((13 * i) % (2 * kPlaces)) / (2 * kPlaces);
    uv.push_back(i % 2 == 0 ? domain[0] + share * (domain[1] - domain[0])
                            : domain[2] + share * (domain[3] - domain[2]));
  }
  Filled position(3 * kPlaces), du(3 * kPlaces), dv(3 * kPlaces);
  fault = reported(
      "points", s.points(self, kPlaces, uv.data(), position.data(), du.data(), dv.data(), &error),
      error);
  return first({fault, position.fault(), du.fault(), dv.fault()});
}

std::string try_form(const burin_factory& f) {
  const auto& s = *static_cast<const burin_form_1*>(f.functions);
  burin_error error{};
  MadeForTrial made(s.destroy);
  std::string fault = reported("make", s.make(fallbacks(f).data(), &made.self, &error), error);
  if (!fault.empty()) return fault;
  made.whole = true;
  return s.values != nullptr ? try_function(s, made.self) : try_patch(s, made.self);
}

/// The first fault of what a symbol draws.
const char*& symbol_fault(burin_symbol* symbol) { return *reinterpret_cast<const char**>(symbol); }

std::int32_t noted(burin_symbol* symbol, const char* fault) {
  const char*& first_fault = symbol_fault(symbol);
  if (first_fault == nullptr) first_fault = fault;
  return fault == nullptr ? BURIN_OK : BURIN_FAILED;
}

constexpr burin_symbol_calls kSymbolCalls{
    [](burin_symbol* symbol, std::size_t count, const double* points, double width, std::int32_t) {
      return noted(symbol, line_fault(count, points, width));
    },
    [](burin_symbol* symbol, std::size_t rings, const std::size_t* counts, const double* points,
       const char* color) { return noted(symbol, fill_fault(rings, counts, points, color)); },
    [](burin_symbol* symbol, double x, double y, double height, std::int32_t anchor,
       const char* text) { return noted(symbol, text_fault(x, y, height, anchor, text)); },
    // About as wide as letters are.
    [](const char* text, double height) {
      return text == nullptr ? 0 : 0.7 * height * static_cast<double>(::strnlen(text, 4096));
    }};

std::string try_symbol(const burin_factory& f) {
  const auto& s = *static_cast<const burin_symbol_1*>(f.functions);
  for (const char* text : {"Ra 1.6\nmilled", ""}) {
    const burin_symbol_request request{text, 3.5, 0.18};
    const char* fault = nullptr;
    burin_symbol_box box{};
    burin_error error{};
    const std::int32_t code = s.draw(&request, fallbacks(f).data(), &kSymbolCalls,
                                     reinterpret_cast<burin_symbol*>(&fault), &box, &error);
    if (fault != nullptr) return fault;
    if (code != BURIN_OK) return reported("draw", code, error);
    if (const char* of_box = box_fault(box)) return of_box;
  }
  return {};
}

std::string try_factory(const burin_factory& f) {
  const std::string_view id = f.id;
  if (id == BURIN_DIRECTION_1) return try_direction(f);
  if (id == BURIN_LAW_1) return try_law(f);
  if (id == BURIN_STROKE_KIND_1) return try_marks(f);
  if (id == BURIN_FORM_1) return try_form(f);
  if (id == BURIN_SYMBOL_1) return try_symbol(f);
  return {};
}

}  // namespace

std::string tried(const burin_plugin_table& table) {
  for (std::size_t i = 0; i < table.factory_count; ++i) {
    const burin_factory& f = table.factories[i];
    const std::string fault = try_factory(f);
    if (!fault.empty()) return std::string(f.id) + " '" + f.name + "' " + fault;
  }
  return {};
}

}  // namespace burin::plugin
