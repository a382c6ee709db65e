#pragma once
// Algebra of tensor Bezier fields over the unit square: products, derivatives, subdivision.

#include <cstddef>
#include <vector>

namespace burin {

/// Coefficients of the Bernstein polynomials of degrees (degree_u, degree_v), row-major along u.
template <class T>
struct BezierField {
  std::size_t degree_u = 0, degree_v = 0;
  std::vector<T> c;

  BezierField() = default;
  BezierField(std::size_t du, std::size_t dv)
      : degree_u(du), degree_v(dv), c((du + 1) * (dv + 1), T(0)) {}

  T& at(std::size_t i, std::size_t j) { return c[i * (degree_v + 1) + j]; }
  const T& at(std::size_t i, std::size_t j) const { return c[i * (degree_v + 1) + j]; }
};

inline std::vector<double> binomials(std::size_t n) {
  std::vector<double> b(n + 1, 1.0);
  for (std::size_t i = 1; i <= n; ++i) {
    b[i] = b[i - 1] * static_cast<double>(n - i + 1) / static_cast<double>(i);
  }
  return b;
}

/// Coefficients times their binomials: then products are plain convolutions.
template <class T>
void scale_by_binomials(BezierField<T>& f, bool inverse) {
  const std::vector<double> bu = binomials(f.degree_u), bv = binomials(f.degree_v);
  for (std::size_t i = 0; i <= f.degree_u; ++i) {
    for (std::size_t j = 0; j <= f.degree_v; ++j) {
      const double s = bu[i] * bv[j];
      f.at(i, j) *= inverse ? 1 / s : s;
    }
  }
}

/// The field of multiply(a, b).
template <class A, class B, class Multiply>
auto product(BezierField<A> a, BezierField<B> b, Multiply multiply) {
  scale_by_binomials(a, false);
  scale_by_binomials(b, false);
  using R = decltype(multiply(a.c[0], b.c[0]));
  BezierField<R> r(a.degree_u + b.degree_u, a.degree_v + b.degree_v);
  for (std::size_t i = 0; i <= a.degree_u; ++i) {
    for (std::size_t j = 0; j <= a.degree_v; ++j) {
      const A x = a.at(i, j);
      for (std::size_t k = 0; k <= b.degree_u; ++k) {
        const B* row = &b.at(k, 0);
        R* out = &r.at(i + k, j);
        for (std::size_t l = 0; l <= b.degree_v; ++l) out[l] += multiply(x, row[l]);
      }
    }
  }
  scale_by_binomials(r, true);
  return r;
}

template <class T>
BezierField<T> derivative_u(const BezierField<T>& f) {
  BezierField<T> r(f.degree_u - 1, f.degree_v);
  for (std::size_t i = 0; i < f.degree_u; ++i) {
    for (std::size_t j = 0; j <= f.degree_v; ++j) {
      r.at(i, j) = static_cast<double>(f.degree_u) * (f.at(i + 1, j) - f.at(i, j));
    }
  }
  return r;
}

template <class T>
BezierField<T> derivative_v(const BezierField<T>& f) {
  BezierField<T> r(f.degree_u, f.degree_v - 1);
  for (std::size_t i = 0; i <= f.degree_u; ++i) {
    for (std::size_t j = 0; j < f.degree_v; ++j) {
      r.at(i, j) = static_cast<double>(f.degree_v) * (f.at(i, j + 1) - f.at(i, j));
    }
  }
  return r;
}

/// De Casteljau's subdivision at the middle of u: `f` becomes the lower half, the upper is given
/// back.
template <class T>
BezierField<T> split_u(BezierField<T>& f) {
  BezierField<T> upper = f;
  const std::size_t n = f.degree_u;
  for (std::size_t j = 0; j <= f.degree_v; ++j) {
    for (std::size_t r = 1; r <= n; ++r) {
      upper.at(n - r + 1, j) = f.at(n, j);
      for (std::size_t i = n; i >= r; --i) f.at(i, j) = 0.5 * (f.at(i - 1, j) + f.at(i, j));
    }
    upper.at(0, j) = f.at(n, j);
  }
  return upper;
}

template <class T>
BezierField<T> split_v(BezierField<T>& f) {
  BezierField<T> upper = f;
  const std::size_t n = f.degree_v;
  for (std::size_t i = 0; i <= f.degree_u; ++i) {
    for (std::size_t r = 1; r <= n; ++r) {
      upper.at(i, n - r + 1) = f.at(i, n);
      for (std::size_t j = n; j >= r; --j) f.at(i, j) = 0.5 * (f.at(i, j - 1) + f.at(i, j));
    }
    upper.at(i, 0) = f.at(i, n);
  }
  return upper;
}

}  // namespace burin
