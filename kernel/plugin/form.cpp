#include <burin/forms/charted/nurbs.h>
#include <burin/forms/implicit/implicit_form.h>
#include <burin/forms/patches/parametric_form.h>
#include <burin/plugin/sources.h>

#include "declared.h"
#include "rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace burin::plugin {
namespace {

constexpr auto kFormRow = PluginError::Row::Form;
// Steps of central differences of first derivatives, as shares of the size of the domain: where
// rounding and the next term of the series weigh about the same.
constexpr double kStep = 1e-5;
// Points of a call.
constexpr std::size_t kBatch = 4096;

/// What a factory made, and how errors of it are told.
class MadeForm {
 public:
  MadeForm(const Source& source, const std::vector<OptionValue>& values) : source_(source) {
    const Values given(values);
    burin_error error{};
    void* self = nullptr;
    check(kFormRow, source_, functions().make(given.data(), &self, &error), error);
    self_ = std::make_shared<const Self>(self, functions().destroy,
                                         (functions().needs & BURIN_ONE_THREAD) != 0);
  }

  const burin_form_1& functions() const { return source_.functions<burin_form_1>(); }

  /// Calls a function, which gets `self` and where to write an error.
  template <class Call>
  void call(const Call& call) const {
    burin_error error;
    clear(error);
    check(kFormRow, source_, self_->call([&](const void* self) { return call(self, &error); }),
          error);
  }
  void finite(const double* numbers, std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i) {
      if (!std::isfinite(numbers[i])) fail(kFormRow, source_, "gives something that is no number");
    }
  }
  [[noreturn]] void refuse(const std::string& what) const { fail(kFormRow, source_, what); }

 private:
  Source source_;
  std::shared_ptr<const Self> self_;
};

class Function final : public ImplicitFunction {
 public:
  explicit Function(MadeForm made) : made_(std::move(made)) {
    made_.call([&](const void* self, burin_error* error) {
      return made_.functions().bounds(self, &bounds_.min.x, &bounds_.max.x, error);
    });
    for (int i = 0; i < 3; ++i) {
      const bool box = std::isfinite(bounds_.min[i]) && std::isfinite(bounds_.max[i]) &&
                       bounds_.min[i] < bounds_.max[i];
      if (!box) made_.refuse("has bounds that are no box");
    }
  }

  void values(std::span<const Vec3> points, std::span<double> out) const override {
    if (points.empty()) return;
    call(points, out.data(), nullptr);
  }

  void gradients(std::span<const Vec3> points, std::span<Gradient1> out) const override {
    std::array<double, kBatch> value;
    std::vector<Vec3> gradient(std::min(points.size(), kBatch));
    for (std::size_t first = 0; first < points.size(); first += kBatch) {
      const std::size_t n = std::min(kBatch, points.size() - first);
      call(points.subspan(first, n), value.data(), &gradient.front().x);
      for (std::size_t i = 0; i < n; ++i) out[first + i] = {value[i], gradient[i]};
    }
  }

  void hessians(std::span<const Vec3> points, std::span<Gradient2> out) const override {
    const double h = kStep * bounds_.diagonal();
    for (std::size_t k = 0; k < points.size(); ++k) {
      std::array<Vec3, 7> at{points[k], points[k], points[k], points[k],
                             points[k], points[k], points[k]};
      for (int i = 0; i < 3; ++i) {
        at[1 + 2 * static_cast<std::size_t>(i)][i] += h;
        at[2 + 2 * static_cast<std::size_t>(i)][i] -= h;
      }
      std::array<Gradient1, 7> g;
      gradients(at, g);
      const auto slope = [&](int of, std::size_t along) {
        return (g[1 + 2 * along].gradient[of] - g[2 + 2 * along].gradient[of]) / (2 * h);
      };
      const auto mixed = [&](int a, int b) {
        return 0.5 *
               (slope(a, static_cast<std::size_t>(b)) + slope(b, static_cast<std::size_t>(a)));
      };
      out[k] = {g[0].value,  g[0].gradient, slope(0, 0), slope(1, 1),
                slope(2, 2), mixed(0, 1),   mixed(0, 2), mixed(1, 2)};
    }
  }

  Box3 bounds() const override { return bounds_; }

 private:
  void call(std::span<const Vec3> points, double* value, double* gradient) const {
    made_.call([&](const void* self, burin_error* error) {
      return made_.functions().values(self, points.size(), &points.front().x, value, gradient,
                                      error);
    });
    made_.finite(value, points.size());
    if (gradient != nullptr) made_.finite(gradient, 3 * points.size());
  }

  MadeForm made_;
  Box3 bounds_{Vec3(0), Vec3(0)};
};

/// S(u,v); second derivatives by differences of the first.
class Patch {
 public:
  explicit Patch(MadeForm made) : made_(std::move(made)) {
    double domain[4]{};
    std::int32_t closed[2]{};
    made_.call([&](const void* self, burin_error* error) {
      return made_.functions().domain(self, domain, closed, error);
    });
    made_.finite(domain, 4);
    if (!(domain[0] < domain[1] && domain[2] < domain[3])) {
      made_.refuse("has a domain that is no rectangle");
    }
    options_.domain = {{domain[0], domain[2]}, {domain[1], domain[3]}};
    for (int i = 0; i < 2; ++i) {
      options_.period[i] = closed[i] == 1 ? options_.domain.size()[i] : 0;
    }
  }

  const FunctionChartOptions& options() const { return options_; }

  SurfaceDerivatives operator()(Vec2 uv) const {
    // The point, then a step back and forth along each parameter, no farther than the domain goes.
    std::array<Vec2, 5> at{uv, uv, uv, uv, uv};
    for (int i = 0; i < 2; ++i) {
      const double h = kStep * options_.domain.size()[i];
      double& back = at[1 + 2 * static_cast<std::size_t>(i)][i];
      double& forth = at[2 + 2 * static_cast<std::size_t>(i)][i];
      back -= h;
      forth += h;
      if (options_.period[i] > 0) continue;
      back = std::max(back, options_.domain.min[i]);
      forth = std::min(forth, options_.domain.max[i]);
    }
    std::array<Vec3, 5> p, du, dv;
    made_.call([&](const void* self, burin_error* error) {
      return made_.functions().points(self, at.size(), &at[0].x, &p[0].x, &du[0].x, &dv[0].x,
                                      error);
    });
    for (const auto* numbers : {&p, &du, &dv}) made_.finite(&(*numbers)[0].x, 3 * at.size());
    const double u = at[2].x - at[1].x, v = at[4].y - at[3].y;
    return {p[0],
            du[0],
            dv[0],
            (du[2] - du[1]) / u,
            0.5 * ((dv[2] - dv[1]) / u + (du[4] - du[3]) / v),
            (dv[4] - dv[3]) / v};
  }

 private:
  MadeForm made_;
  FunctionChartOptions options_;
};

std::shared_ptr<const Form> make(const Source& source, const std::vector<OptionValue>& values,
                                 const RunContext& context) {
  MadeForm made(source, values);
  if (made.functions().values != nullptr) {
    // The box belongs to the form: walls that reach it are closed there.
    const auto function = std::make_shared<Function>(std::move(made));
    return std::make_shared<ImplicitForm>(clip(function, function->bounds()), std::nullopt,
                                          context);
  }
  const Patch patch(std::move(made));
  const std::function<SurfaceDerivatives(Vec2)> evaluate = patch;
  return std::make_shared<ParametricForm>(
      std::vector{make_function_chart(evaluate, patch.options())});
}

}  // namespace

void add_form(const Source& source) {
  add(FormKind{.name = source.factory->name,
               .meaning = source.factory->meaning,
               .make = [source](const std::vector<OptionValue>& values,
                                RunContext& context) { return make(source, values, context); },
               .options = declared(*source.factory)});
}

}  // namespace burin::plugin
