#include "number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace burin::csg {
namespace {

constexpr std::size_t kMostBits = 2000;

mpz_class dot(const Exact& a, const Exact& b) {
  return a.c[0] * b.c[0] + a.c[1] * b.c[1] + a.c[2] * b.c[2] + a.c[3] * b.c[3];
}

/// Takes the common factor out: products gather the powers of ten of their decimals, and a number
/// is made once but multiplied many times.
void shorten(Exact& e) {
  mpz_class common = 0;
  for (const mpz_class& v : e.c) {
    mpz_gcd(common.get_mpz_t(), common.get_mpz_t(), v.get_mpz_t());
    if (common == 1) return;
  }
  if (common == 0) return;
  for (mpz_class& v : e.c) mpz_divexact(v.get_mpz_t(), v.get_mpz_t(), common.get_mpz_t());
}

void turn_positive(Exact& point) {
  if (point.c[3] < 0) {
    for (mpz_class& v : point.c) v = -v;
  }
  shorten(point);
}

Exact homogeneous(const std::array<mpq_class, 3>& p) {
  Exact out;
  mpz_class& w = out.c[3];
  w = 1;
  for (const mpq_class& v : p) mpz_lcm(w.get_mpz_t(), w.get_mpz_t(), v.get_den_mpz_t());
  for (std::size_t i = 0; i < 3; ++i) out.c[i] = p[i].get_num() * (w / p[i].get_den());
  return out;
}

/// GMP cuts off; the next double may be nearer.
double nearest_double(const mpq_class& v) {
  const double low = v.get_d(), high = std::nextafter(low, v > 0 ? HUGE_VAL : -HUGE_VAL);
  return abs(mpq_class(high) - v) < abs(mpq_class(low) - v) ? high : low;
}

void find_nearest(ExactMatrix& m) {
  m.identity = true;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      if (mpz_sizeinbase(m.row[i][j].get_den_mpz_t(), 2) > kMostBits ||
          mpz_sizeinbase(m.row[i][j].get_num_mpz_t(), 2) > kMostBits) {
        m.row[i][j] = decimal(m.row[i][j].get_d());
      }
      m.nearest.row[i][j] = nearest_double(m.row[i][j]);
      m.identity = m.identity && m.row[i][j] == (i == j ? 1 : 0);
    }
    m.plain[i] = decimal(m.nearest.row[i][3]) == m.row[i][3];
  }
}

mpz_class minor(const Exact& p, const Exact& q, const Exact& r, std::size_t i, std::size_t j,
                std::size_t k) {
  return p.c[i] * (q.c[j] * r.c[k] - q.c[k] * r.c[j]) -
         p.c[j] * (q.c[i] * r.c[k] - q.c[k] * r.c[i]) +
         p.c[k] * (q.c[i] * r.c[j] - q.c[j] * r.c[i]);
}

}  // namespace

mpq_class decimal(double v) {
  std::array<char, 40> text{};  // zeros behind the exponent
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), v, std::chars_format::scientific);
  const std::string_view word(text.data(), static_cast<std::size_t>(end.ptr - text.data()));
  const std::size_t e = word.find('e'), dot = word.find('.');
  std::string digits(word.substr(0, e));
  long power = std::strtol(word.data() + e + 1, nullptr, 10);
  if (dot != std::string_view::npos) {
    power -= static_cast<long>(e - dot - 1);
    digits.erase(dot, 1);
  }
  mpz_class scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(power)));
  mpq_class out{mpz_class(digits)};
  if (power < 0) {
    out.get_den() = scale;
    out.canonicalize();
  } else {
    out.get_num() *= scale;
  }
  return out;
}

ExactMatrix exact(const Matrix& m) {
  ExactMatrix out;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) out.row[i][j] = decimal(m.row[i][j]);
  }
  find_nearest(out);
  return out;
}

ExactMatrix multiply(const ExactMatrix& a, const ExactMatrix& b) {
  if (a.identity) return b;
  if (b.identity) return a;
  ExactMatrix out;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      if (j == 3) out.row[i][j] = a.row[i][3];
      for (std::size_t k = 0; k < 3; ++k) {
        if (a.row[i][k] != 0 && b.row[k][j] != 0) out.row[i][j] += a.row[i][k] * b.row[k][j];
      }
    }
  }
  find_nearest(out);
  return out;
}

ExactMatrix inverse(const ExactMatrix& m) {
  const auto& r = m.row;
  const auto cofactor = [&](std::size_t i, std::size_t j) {
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return mpq_class(r[a][c] * r[b][d] - r[a][d] * r[b][c]);
  };
  const mpq_class determinant =
      r[0][0] * cofactor(0, 0) + r[0][1] * cofactor(0, 1) + r[0][2] * cofactor(0, 2);
  ExactMatrix out;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      out.row[i][j] = cofactor(j, i) / determinant;
      out.row[i][3] -= out.row[i][j] * r[j][3];
    }
  }
  find_nearest(out);
  return out;
}

Exact transformed(const ExactMatrix& m, Vec3 p) {
  std::array<mpq_class, 3> out;
  for (std::size_t i = 0; i < 3; ++i) {
    out[i] = m.row[i][3];
    for (int j = 0; j < 3; ++j) {
      if (p[j] != 0) out[i] += m.row[i][static_cast<std::size_t>(j)] * decimal(p[j]);
    }
  }
  return homogeneous(out);
}

Exact exact_point(Vec3 p) { return homogeneous({decimal(p.x), decimal(p.y), decimal(p.z)}); }

Exact plane_through(const Exact& a, const Exact& b, const Exact& c) {
  Exact out;
  out.c[0] = minor(a, b, c, 1, 2, 3);
  out.c[1] = -minor(a, b, c, 0, 2, 3);
  out.c[2] = minor(a, b, c, 0, 1, 3);
  out.c[3] = -minor(a, b, c, 0, 1, 2);
  shorten(out);
  return out;
}

Exact meet(const Exact& u, const Exact& v, const Exact& plane) {
  const mpz_class a = dot(u, plane), b = dot(v, plane);
  Exact out;
  for (std::size_t i = 0; i < 4; ++i) out.c[i] = b * u.c[i] - a * v.c[i];
  turn_positive(out);
  return out;
}

Exact meet_planes(const Exact& p, const Exact& q, const Exact& r) {
  Exact out = plane_through(p, q, r);  // the same four determinants, points and planes being dual
  turn_positive(out);
  return out;
}

int side(const Exact& point, const Exact& plane) { return sgn(dot(point, plane)); }

int compare(const Exact& a, const Exact& b, std::size_t axis) {
  return sgn(mpz_class(a.c[axis] * b.c[3] - b.c[axis] * a.c[3]));
}

bool equal_points(const Exact& a, const Exact& b) {
  return compare(a, b, 0) == 0 && compare(a, b, 1) == 0 && compare(a, b, 2) == 0;
}

int turn(const Exact& a, const Exact& b, const Exact& c, std::size_t i, std::size_t j) {
  return sgn(minor(a, b, c, i, j, 3));
}

int in_circle(const std::array<const Exact*, 3>& triangle, const Exact& t, std::size_t i,
              std::size_t j) {
  // Of each corner what it is away from the point, times both weights; rows times their squares.
  std::array<Exact, 3> row;
  for (std::size_t k = 0; k < 3; ++k) {
    const Exact& p = *triangle[k];
    const mpz_class x = p.c[i] * t.c[3] - t.c[i] * p.c[3], y = p.c[j] * t.c[3] - t.c[j] * p.c[3];
    const mpz_class w = p.c[3] * t.c[3];
    row[k].c[0] = x * w;
    row[k].c[1] = y * w;
    row[k].c[2] = x * x + y * y;
  }
  return sgn(minor(row[0], row[1], row[2], 0, 1, 2));
}

Vec3 nearest(const Exact& point) {
  Vec3 out;
  mpz_class scaled;
  const auto w_bits = static_cast<long>(mpz_sizeinbase(point.c[3].get_mpz_t(), 2));
  for (std::size_t i = 0; i < 3; ++i) {
    // A quotient of 64 bits, cut off: one unit in the last place of a double at most.
    const auto bits = static_cast<long>(mpz_sizeinbase(point.c[i].get_mpz_t(), 2));
    const long shift = std::max(0L, 64 + w_bits - bits);
    mpz_mul_2exp(scaled.get_mpz_t(), point.c[i].get_mpz_t(), static_cast<mp_bitcnt_t>(shift));
    scaled /= point.c[3];
    out[static_cast<int>(i)] = std::ldexp(scaled.get_d(), static_cast<int>(-shift));
  }
  return out;
}

}  // namespace burin::csg
