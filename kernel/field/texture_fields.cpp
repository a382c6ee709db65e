// Directions that are told in the (u, v) of a surface: across the gradient of a picture, or by two
// formulas.

#include <burin/base/error.h>
#include <burin/expression/formula.h>
#include <burin/field/field.h>
#include <burin/field/options.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace burin::field {
namespace {

// Share of the part's size by which a point is moved to see how u and v change.
constexpr double kMove = 1e-4;
// Change of u or v over such a move from which it went over the seam of a texture.
constexpr double kJump = 0.05;
// Change of lightness over a tenth of the picture below which it is even.
constexpr double kEven = 1e-3;

// How u and v change along two tangents at a right angle: a 2 x 2 matrix of their derivatives.
struct Chart2 {
  Vec2 uv{0};
  Vec3 x{0}, y{0};
  Vec2 along_x{0}, along_y{0};  // of (u, v), 1/model mm

  double determinant() const { return along_x.x * along_y.y - along_x.y * along_y.x; }
};

// The change of (u, v) a mm along a tangent. On a texture that repeats a whole turn is none.
std::optional<Vec2> change(const Surface& surface, const SurfacePoint& from, Vec2 uv, Vec3 tangent,
                           double move) {
  for (const double sign : {1.0, -1.0}) {
    const MarchStep step = surface.march(from, sign * tangent, move);
    if (step.stop != MarchStop::Completed) continue;
    const auto there = surface.parameters(step.end);
    if (!there) continue;
    Vec2 by = *there - uv;
    by -= glm::round(by);
    if (std::max(std::abs(by.x), std::abs(by.y)) > kJump) continue;
    return sign / move * by;
  }
  return std::nullopt;
}

class TextureFrames {
 public:
  explicit TextureFrames(const std::vector<const Surface*>& surfaces) : surfaces_(surfaces) {
    for (const Surface* s : surfaces) moves_.push_back(kMove * s->proxy().mesh.bounds().diagonal());
  }

  std::optional<Chart2> at(const FieldQuery& q) const {
    const auto part = static_cast<std::size_t>(q.part);
    const Surface& surface = *surfaces_[part];
    const auto uv = surface.parameters(q.point);
    if (!uv) return std::nullopt;
    Chart2 c{.uv = *uv};
    c.x = any_orthogonal(q.frame.normal);
    c.y = glm::cross(q.frame.normal, c.x);
    const auto x = change(surface, q.point, *uv, c.x, moves_[part]);
    const auto y = change(surface, q.point, *uv, c.y, moves_[part]);
    if (!x || !y) return std::nullopt;
    c.along_x = *x;
    c.along_y = *y;
    return c;
  }

 private:
  std::vector<const Surface*> surfaces_;
  std::vector<double> moves_;
};

// A box blur along rows (`along` = 1) or columns of a picture that repeats.
void blur_lines(Image& image, std::int32_t radius, bool rows) {
  if (radius < 1) return;
  const std::int32_t n = rows ? image.width : image.height,
                     lines = rows ? image.height : image.width;
  const auto index = [&](std::int32_t line, std::int32_t i) {
    const auto w = static_cast<std::size_t>(image.width);
    return rows ? static_cast<std::size_t>(line) * w + static_cast<std::size_t>(i)
                : static_cast<std::size_t>(i) * w + static_cast<std::size_t>(line);
  };
  radius = std::min(radius, (n - 1) / 2);
  std::vector<double> sums(static_cast<std::size_t>(n + 2 * radius) + 1, 0);
  for (std::int32_t line = 0; line < lines; ++line) {
    for (std::int32_t i = 0; i < n + 2 * radius; ++i) {
      const double value = image.values[index(line, (i - radius + n) % n)];
      sums[static_cast<std::size_t>(i) + 1] = sums[static_cast<std::size_t>(i)] + value;
    }
    for (std::int32_t i = 0; i < n; ++i) {
      const auto begin = static_cast<std::size_t>(i),
                 end = begin + 2 * static_cast<std::size_t>(radius) + 1;
      image.values[index(line, i)] =
          static_cast<float>((sums[end] - sums[begin]) / (2 * radius + 1));
    }
  }
}

// As a Gaussian of a standard deviation of `share` of each side: three boxes.
Image blurred(Image image, double share) {
  constexpr int kBoxes = 3;
  for (int i = 0; i < kBoxes; ++i) {
    blur_lines(image, static_cast<std::int32_t>(std::lround(share * image.width)), true);
    blur_lines(image, static_cast<std::int32_t>(std::lround(share * image.height)), false);
  }
  return image;
}

constexpr std::array<std::string_view, 5> kNames{"u", "v", "x", "y", "z"};

expression::Formula compiled(const std::string& text, const std::string& key) {
  try {
    return {text, kNames};
  } catch (const UsageError& e) {
    throw UsageError("style key '" + key + "': " + e.what());
  }
}

std::optional<Cross> cross_along(const FieldQuery& q, Vec3 along) {
  const double size = glm::length(along);
  if (!(size > 0) || !std::isfinite(size)) return std::nullopt;
  const Vec3 first = along / size;
  return Cross{first, glm::cross(q.frame.normal, first), q.frame.confidence};
}

}  // namespace

void check_texts(const FieldOptions& options, const std::string& group) {
  compiled(options.along_u, group + "along_u");
  compiled(options.along_v, group + "along_v");
}

Field texture_image(const std::vector<const Surface*>& surfaces,
                    const std::shared_ptr<const Image>& image, double blur) {
  if (!image) {
    throw UsageError("hatch.field texture-image asks for a picture; name one by hatch.image");
  }
  return {"texture-image",
          [frames = TextureFrames(surfaces),
           soft = blurred(*image, blur)](const FieldQuery& q) -> std::optional<Cross> {
            const auto c = frames.at(q);
            if (!c) return std::nullopt;
            const double du = 1.0 / soft.width, dv = 1.0 / soft.height;
            const auto at = [&](double u, double v) { return soft.at(c->uv.x + u, c->uv.y + v); };
            const Vec2 gradient((at(du, 0) - at(-du, 0)) / (2 * du),
                                (at(0, dv) - at(0, -dv)) / (2 * dv));
            if (!(glm::length(gradient) > kEven / 0.1)) return std::nullopt;
            const Vec3 climb =
                glm::dot(gradient, c->along_x) * c->x + glm::dot(gradient, c->along_y) * c->y;
            return cross_along(q, glm::cross(q.frame.normal, climb));
          }};
}

Field texture_vector(const std::vector<const Surface*>& surfaces, const std::string& along_u,
                     const std::string& along_v) {
  return {"texture-vector",
          [frames = TextureFrames(surfaces), a = compiled(along_u, "hatch.along_u"),
           b = compiled(along_v, "hatch.along_v")](const FieldQuery& q) -> std::optional<Cross> {
            const auto c = frames.at(q);
            if (!c) return std::nullopt;
            const Vec3 p = q.point.position;
            const std::array<double, 5> values{c->uv.x, c->uv.y, p.x, p.y, p.z};
            const Vec2 way(a(values), b(values));
            const double det = c->determinant();
            if (det == 0 || !std::isfinite(way.x) || !std::isfinite(way.y)) return std::nullopt;
            // The tangent along which (u, v) changes so.
            const double s = (way.x * c->along_y.y - way.y * c->along_y.x) / det;
            const double t = (c->along_x.x * way.y - c->along_x.y * way.x) / det;
            return cross_along(q, s * c->x + t * c->y);
          }};
}

}  // namespace burin::field
