#include "function.h"

#include "arrays.h"
#include "held.h"
#include "run.h"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <span>
#include <vector>

namespace burin::python {
namespace {

// Steps of central differences as shares of the size of the domain: where rounding and the next
// term of the series weigh about the same, for first differences (error 1e-10 of the values' range)
// and for second ones (1e-8).
constexpr double kFirstStep = 1e-5;
constexpr double kSecondStep = 1e-4;

using Numbers = std::vector<double>;

class PythonFunction final : public ImplicitFunction {
 public:
  PythonFunction(const py::object& values, const py::object& gradients, const py::object& hessians,
                 const Box3& bounds)
      : values_(hold(values)),
        gradients_(gradients.is_none() ? nullptr : hold(gradients)),
        hessians_(hessians.is_none() ? nullptr : hold(hessians)),
        bounds_(bounds),
        size_(bounds.diagonal()) {}

  void values(std::span<const Vec3> points, std::span<double> out) const override {
    if (points.empty()) return;
    const Numbers v = call(*values_, "values", points, {});
    std::copy(v.begin(), v.end(), out.begin());
  }

  void gradients(std::span<const Vec3> points, std::span<Gradient1> out) const override {
    if (points.empty()) return;
    if (gradients_) {
      const Numbers v = call(*values_, "values", points, {});
      const Numbers g = call(*gradients_, "gradients", points, {3});
      for (std::size_t i = 0; i < points.size(); ++i) {
        out[i] = {v[i], {g[3 * i], g[3 * i + 1], g[3 * i + 2]}};
      }
      return;
    }
    const double h = kFirstStep * size_;
    std::vector<Vec3> at = star(points, h);
    const Numbers v = call(*values_, "values", at, {});
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double* s = v.data() + 7 * i;
      out[i].value = s[0];
      for (int k = 0; k < 3; ++k) out[i].gradient[k] = (s[1 + 2 * k] - s[2 + 2 * k]) / (2 * h);
    }
  }

  void hessians(std::span<const Vec3> points, std::span<Gradient2> out) const override {
    if (points.empty()) return;
    if (hessians_) return given_hessians(points, out);
    if (gradients_) return hessians_of_gradients(points, out);
    hessians_of_values(points, out);
  }

  Box3 bounds() const override { return bounds_; }

 private:
  /// A point and its six neighbours: p, p + hx, p - hx, p + hy ...
  static std::vector<Vec3> star(std::span<const Vec3> points, double h) {
    std::vector<Vec3> at;
    at.reserve(7 * points.size());
    for (const Vec3& p : points) {
      at.push_back(p);
      for (int k = 0; k < 3; ++k) {
        Vec3 step(0);
        step[k] = h;
        at.push_back(p + step);
        at.push_back(p - step);
      }
    }
    return at;
  }

  void given_hessians(std::span<const Vec3> points, std::span<Gradient2> out) const {
    std::vector<Gradient1> first(points.size());
    gradients(points, first);
    const Numbers h = call(*hessians_, "hessians", points, {3, 3});
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double* m = h.data() + 9 * i;
      out[i] = {first[i].value,      first[i].gradient,  m[0], m[4], m[8], 0.5 * (m[1] + m[3]),
                0.5 * (m[2] + m[6]), 0.5 * (m[5] + m[7])};
    }
  }

  void hessians_of_gradients(std::span<const Vec3> points, std::span<Gradient2> out) const {
    const double h = kFirstStep * size_;
    const std::vector<Vec3> at = star(points, h);
    const Numbers v = call(*values_, "values", points, {});
    const Numbers g = call(*gradients_, "gradients", at, {3});
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double* s = g.data() + 21 * i;
      const auto slope = [&](int of, int along) {
        return (s[3 * (1 + 2 * along) + of] - s[3 * (2 + 2 * along) + of]) / (2 * h);
      };
      const auto mixed = [&](int a, int b) { return 0.5 * (slope(a, b) + slope(b, a)); };
      out[i] = {v[i],        {s[0], s[1], s[2]}, slope(0, 0), slope(1, 1),
                slope(2, 2), mixed(0, 1),        mixed(0, 2), mixed(1, 2)};
    }
  }

  void hessians_of_values(std::span<const Vec3> points, std::span<Gradient2> out) const {
    constexpr std::array<std::array<int, 2>, 3> kPairs{{{0, 1}, {0, 2}, {1, 2}}};
    constexpr std::size_t kSamples = 19;
    const double h = kSecondStep * size_;
    std::vector<Vec3> at;
    at.reserve(kSamples * points.size());
    for (const Vec3& p : points) {
      const std::vector<Vec3> near = star({&p, 1}, h);
      at.insert(at.end(), near.begin(), near.end());
      for (const auto& [a, b] : kPairs) {
        for (const double sa : {h, -h}) {
          for (const double sb : {h, -h}) {
            Vec3 q = p;
            q[a] += sa;
            q[b] += sb;
            at.push_back(q);
          }
        }
      }
    }
    const Numbers v = call(*values_, "values", at, {});
    std::vector<Gradient1> first(points.size());
    gradients(points, first);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double* s = v.data() + kSamples * i;
      const auto pure = [&](std::size_t k) {
        return (s[1 + 2 * k] - 2 * s[0] + s[2 + 2 * k]) / (h * h);
      };
      const auto mixed = [&](std::size_t pair) {
        const double* m = s + 7 + 4 * pair;
        return (m[0] - m[1] - m[2] + m[3]) / (4 * h * h);
      };
      out[i] = {s[0], first[i].gradient, pure(0), pure(1), pure(2), mixed(0), mixed(1), mixed(2)};
    }
  }

  /// One call of Python; `tail` is the shape of what it gives a point.
  static Numbers call(const py::object& function, const char* name, std::span<const Vec3> points,
                      const std::vector<py::ssize_t>& tail) {
    Numbers out;
    in_python([&] {
      const auto n = static_cast<py::ssize_t>(points.size());
      py::array_t<double> argument({n, py::ssize_t{3}});
      std::memcpy(argument.mutable_data(), points.data(), points.size_bytes());
      const py::object result = function(argument);
      const Doubles array = Doubles::ensure(result);
      std::vector<py::ssize_t> shape{n};
      shape.insert(shape.end(), tail.begin(), tail.end());
      if (!array) {
        PyErr_Clear();
        throw py::type_error(fmt::format("{} must give an array of numbers", name));
      }
      if (!std::equal(shape.begin(), shape.end(), array.shape(), array.shape() + array.ndim())) {
        throw py::value_error(fmt::format("{} must give an array of shape ({}), not {}", name,
                                          fmt::join(shape, ", "),
                                          std::string(py::str(array.attr("shape")))));
      }
      out.assign(array.data(), array.data() + array.size());
    });
    return out;
  }

  std::shared_ptr<py::object> values_, gradients_, hessians_;
  Box3 bounds_;
  double size_;
};

}  // namespace

std::shared_ptr<const ImplicitFunction> make_python_function(const PythonFunctions& functions,
                                                             const Box3& bounds) {
  const auto check = [](const py::object& function, const char* name) {
    if (!PyCallable_Check(function.ptr())) {
      throw py::type_error(fmt::format("{} takes a function of points (n, 3)", name));
    }
  };
  check(functions.values, "values");
  if (!functions.gradients.is_none()) check(functions.gradients, "gradients");
  if (!functions.hessians.is_none()) check(functions.hessians, "hessians");
  return std::make_shared<PythonFunction>(functions.values, functions.gradients, functions.hessians,
                                          bounds);
}

}  // namespace burin::python
