/// Functions that nobody should draw: each ends with a surface or with one line, within a bound on
/// what is asked of the function, and soon after the run was cancelled.

#include <burin/base/error.h>
#include <burin/converters/implicit_reader.h>
#include <burin/forms/implicit/expression.h>
#include <burin/forms/implicit/implicit_form.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <mutex>
#include <string>

namespace burin {
namespace {

/// Operations asked for in all, and the number of them after which the run is cancelled.
struct Meter {
  std::atomic<double> operations{0};
  double cancel_at = 0;
  RunContext* context = nullptr;

  void add(double n) {
    double before = operations.load();
    while (!operations.compare_exchange_weak(before, before + n)) {
    }
    if (context && before + n >= cancel_at) context->cancel();
  }
};

/// A function that counts; its parts count with it.
class Metered final : public ImplicitFunction {
 public:
  Metered(const ImplicitFunction& f, Meter& meter) : f_(f), meter_(meter) {}
  Metered(std::shared_ptr<const ImplicitFunction> f, Meter& meter)
      : own_(std::move(f)), f_(*own_), meter_(meter) {}

  void values(std::span<const Vec3> points, std::span<double> out) const override {
    meter_.add(static_cast<double>(points.size()) * f_.cost());
    f_.values(points, out);
  }
  void gradients(std::span<const Vec3> points, std::span<Gradient1> out) const override {
    meter_.add(3 * static_cast<double>(points.size()) * f_.cost());
    f_.gradients(points, out);
  }
  void hessians(std::span<const Vec3> points, std::span<Gradient2> out) const override {
    meter_.add(8 * static_cast<double>(points.size()) * f_.cost());
    f_.hessians(points, out);
  }
  Interval range(const Box3& box) const override {
    meter_.add(4 * f_.cost());
    return f_.range(box);
  }
  Interval slope(const Box3& box, Vec3 direction) const override {
    meter_.add(8 * f_.cost());
    return f_.slope(box, direction);
  }
  bool has_slopes() const override { return f_.has_slopes(); }
  Box3 bounds() const override { return f_.bounds(); }
  double cost() const override { return f_.cost(); }
  std::uint64_t piece(Vec3 p) const override {
    meter_.add(f_.cost());
    return f_.piece(p);
  }
  bool has_pieces() const override { return f_.has_pieces(); }
  const ImplicitFunction& piece_function(Vec3 p) const override {
    meter_.add(f_.cost());
    const ImplicitFunction& piece = f_.piece_function(p);
    const std::lock_guard lock(mutex_);
    auto& mine = pieces_[&piece];
    if (!mine) mine = std::make_unique<Metered>(piece, meter_);
    return *mine;
  }
  std::shared_ptr<const ImplicitFunction> restricted(const Box3& box) const override {
    auto part = f_.restricted(box);
    return part ? std::make_shared<Metered>(std::move(part), meter_) : nullptr;
  }

 private:
  std::shared_ptr<const ImplicitFunction> own_;
  const ImplicitFunction& f_;
  Meter& meter_;
  mutable std::mutex mutex_;
  mutable std::map<const ImplicitFunction*, std::unique_ptr<Metered>> pieces_;
};

enum class End { Drawn, Refused, Either };

struct Nasty {
  std::string name, text;
  End end = End::Either;
  double half = 10;  // of the domain
};

void PrintTo(const Nasty& n, std::ostream* out) { *out << n.name; }

std::string sum(int n, const char* term) {
  // In groups, as a sum may not be nested deeper than 4,000.
  std::string s = "0";
  for (int k = 1; k <= n; ++k) s += fmt::format(fmt::runtime(term), k, 1.0 / k);
  return s;
}

std::string mandelbrot(int rounds) {
  std::string s = "a0 = x; b0 = y;";
  for (int k = 0; k < rounds; ++k) {
    s += fmt::format("a{1}=a{0}*a{0}-b{0}*b{0}+x; b{1}=2*a{0}*b{0}+y;", k, k + 1);
  }
  return s + fmt::format("max(a{0}*a{0}+b{0}*b{0}-4, abs(z)-0.2)", rounds);
}

std::string balls(int n, const char* join) {
  std::string s = "s = sphere(0.4); u0 = s;";
  for (int k = 0; k < n; ++k) {
    s += fmt::format("u{} = {}(u{}, translate(s, {}, {}, {}){});", k + 1, join, k, k * 37 % 17 - 8,
                     k * 53 % 17 - 8, k * 71 % 17 - 8, std::string(join) == "union" ? "" : ", 0.5");
  }
  return s + fmt::format("u{}", n);
}

std::vector<Nasty> nasties() {
  return {
      {"NowhereZero", "x^2 + y^2 + z^2 + 1", End::Refused},
      {"EverywhereZero", "0 * x", End::Refused},
      {"NegativeEverywhere", "-1 - x^2", End::Refused},
      {"NaNEverywhere", "sqrt(-1 - x^2)", End::Refused},
      {"NaNInHalf", "sqrt(x) + y^2 + z^2 - 25"},
      {"InfiniteOnAPlane", "log(x) + z"},
      {"Poles", "1/x + 1/y + 1/z - 0.1"},
      {"PolesInRows", "tan(x) * tan(y) - z"},
      {"Overflowing", "exp(exp(x*y)) - exp(exp(z))"},
      {"SteepAsCanBe", "(x^2 + y^2 + z^2)^60 - 1e90"},
      {"TinyValues", "1e-300 * (x^2 + y^2 + z^2 - 25)"},
      {"HugeValues", "1e300 * (x^2 + y^2 + z^2 - 25)"},
      {"Steps", "round(x/3) + round(y/3) + round(z/3) - 0.5"},
      {"StepsOfWaves", "round(sin(3*x)*sin(3*y)*sin(3*z)*4) - 0.5"},
      {"SquaredBall", "(x^2 + y^2 + z^2 - 25)^2", End::Refused},
      {"ThinShell", "abs(x^2 + y^2 + z^2 - 25) - 0.001"},
      {"HighFrequency", "sin(50*x) * sin(50*y) * sin(50*z)"},
      {"HighFrequencySum", "sin(50*x) + sin(50*y) + sin(50*z)"},
      {"FrequencyThatGrows", "sin(1000*x*y) + sin(1000*y*z) + sin(1000*z*x)"},
      {"Fractal", sum(10, " + {1}*sin(1.7*{0}*{0}*x+{0})*sin(1.9*{0}*{0}*y)*sin({0}*{0}*z+2*{0})")},
      {"Hash", "h = sin(x*127.1 + y*311.7 + z*74.7) * 43758.5453; h - round(h)"},
      {"NoisyCreases", "min(sin(9*x), sin(9*y+1), sin(9*z+2)) + max(sin(7*x+y), sin(7*y+z))"},
      {"ManyCopies", "repeat(box(0.3, 0.3, 0.3), 0.5, 0.5, 0.5)"},
      {"Unbounded", "z - sin(x)", End::Drawn},
      {"Cusp", "x^2 + y^2 - z^3", End::Drawn},
      {"Whitney", "x^2 - y^2*z", End::Drawn},
      {"DoubleCone", "x^2 + y^2 - z^2", End::Drawn},
      {"FractionalPowers", "abs(x)^0.1 + abs(y)^0.1 + abs(z)^0.1 - 3.5"},
      {"Topologist", "sin(1/x) + y + z", End::Either, 1},
      {"Windings", "atan2(y, x) - z", End::Drawn},
      {"TwistedTooFar", "twist(box(8, 1, 15), 400)"},
      {"Mandelbrot", mandelbrot(14), End::Either, 2},
      {"VeryDeep", sum(1500, " + {1}*sin({0}*0.01*y+x)")},
      {"ManyBalls", balls(400, "union"), End::Drawn},
      {"ManyBlendedBalls", balls(150, "smooth_union")},
      {"VastDomain", "sphere(1)", End::Refused, 1e8},
  };
}

class Nasties : public testing::TestWithParam<Nasty> {
 protected:
  /// The line of the error, empty where a surface was made.
  std::string draw(Meter& meter, RunContext& context) const {
    const Nasty& n = GetParam();
    const auto f = std::make_shared<Metered>(make_function(parse_implicit(n.text, n.name)), meter);
    try {
      const ImplicitForm form(f, Box3{Vec3(-n.half), Vec3(n.half)}, context);
      const auto surface = form.realise({.tolerance = 1e-3 * n.half}, context);
      EXPECT_FALSE(surface->proxy().mesh.triangles.empty());
      for (const Vec3& p : surface->proxy().mesh.positions) {
        EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
      }
      // Marches end wherever they get to.
      for (const SurfacePoint& p : surface->cover({.count = 20}, context)) {
        const MarchStep step = surface->march(p, surface->frame(p).d1, 0.5 * n.half);
        EXPECT_LE(step.length, 0.5 * n.half * (1 + 1e-9));
      }
      return "";
    } catch (const GeometryError& e) {
      return e.what();
    }
  }
};

// A core does some 5e8 of them a second.
constexpr double kMostOperations = 5e9, kMostAfterCancel = 1e8;

TEST_P(Nasties, EndWithASurfaceOrOneLine) {
  Meter meter;
  RunContext context;
  const std::string line = draw(meter, context);
  EXPECT_EQ(line.find('\n'), std::string::npos);
  if (GetParam().end != End::Either) {
    EXPECT_EQ(line.empty(), GetParam().end == End::Drawn) << line;
  }
  EXPECT_LT(meter.operations.load(), kMostOperations);
  RecordProperty("operations", fmt::format("{:.2g}", meter.operations.load()));
  RecordProperty("refused", line);
}

TEST_P(Nasties, EndSoonAfterTheyAreCancelled) {
  for (const double at : {1e5, 3e7, 3e8}) {
    RunContext context;
    Meter meter;
    meter.cancel_at = at;
    meter.context = &context;
    try {
      draw(meter, context);
      continue;  // ended before that
    } catch (const Cancelled&) {
    }
    EXPECT_LT(meter.operations.load() - at, kMostAfterCancel);
  }
}

INSTANTIATE_TEST_SUITE_P(Implicit, Nasties, testing::ValuesIn(nasties()),
                         [](const auto& n) { return n.param.name; });

}  // namespace
}  // namespace burin
