#include <burin/field/catalogue.h>

#include "declared.h"
#include "rows.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace burin::plugin {
namespace {

constexpr auto kDirectionRow = PluginError::Row::Direction;
// As of directions of our own: the sine of the smallest angle to the normal at which a tangent part
// is worth following.
constexpr double kSteepest = 0.01;
constexpr double kHuge = 1e300;
constexpr double kNone[3] = {0, 0, 0};

class Direction {
 public:
  Direction(const Source& source, const field::FieldRequest& request) : source_(source) {
    const auto& functions = source_.functions<burin_direction_1>();
    const burin_view view =
        view_of(request.camera, request.shown, request.light, request.options.direction);
    const auto options = declared(*source_.factory);
    const Values values(values_of(request.options.declared, source_.factory->name, options));
    burin_error error{};
    void* self = nullptr;
    check(kDirectionRow, source_, functions.make(&view, values.data(), &self, &error), error);
    self_ = std::make_shared<const Self>(self, functions.destroy,
                                         (functions.needs & BURIN_ONE_THREAD) != 0);
    directions_ = functions.directions;
    if ((functions.needs & BURIN_ONE_THREAD) == 0) raw_ = self;
  }

  std::optional<Cross> operator()(const FieldQuery& q) const {
    const Frame& f = q.frame;
    const double* const d1 = f.umbilic ? kNone : &f.d1.x;
    const double* const d2 = f.umbilic ? kNone : &f.d2.x;
    const burin_points at{
        1, &q.point.position.x, &f.normal.x, &f.k1, &f.k2, d1, d2, &f.du.x, &f.dv.x, &q.part};
    Vec3 first(0), second(0);
    double certainty = 0.5;
    burin_error error;
    clear(error);
    const std::int32_t code =
        raw_ ? directions_(raw_, &at, &first.x, &second.x, &certainty, &error)
             : self_->call([&](const void* self) {
                 return directions_(self, &at, &first.x, &second.x, &certainty, &error);
               });
    if (code != BURIN_OK) check(kDirectionRow, source_, code, error);
    // What is no number is not below any.
    const double a = glm::dot(first, first), b = glm::dot(second, second);
    if (!(a + b + std::abs(certainty) < kHuge)) {
      fail(kDirectionRow, source_, "gives something that is no number");
    }
    if (!make_tangent(first, a, f.normal)) return std::nullopt;
    if (!make_tangent(second, b, f.normal)) second = glm::cross(f.normal, first);
    return Cross{first, second, std::clamp(certainty, 0.0, 1.0)};
  }

 private:
  /// Leaves the unit part along the surface of a vector, whose square is given.
  static bool make_tangent(Vec3& v, double square, Vec3 normal) {
    if (square <= 0) return false;
    v = reject(v, normal);
    const double part = glm::dot(v, v);
    if (part < kSteepest * kSteepest * square) return false;
    v /= std::sqrt(part);
    return true;
  }

  Source source_;
  std::shared_ptr<const Self> self_;
  /// The same without the way round; null where threads take turns.
  const void* raw_ = nullptr;
  decltype(burin_direction_1::directions) directions_ = nullptr;
};

}  // namespace

void add_direction(const Source& source) {
  const std::uint32_t needs = source.functions<burin_direction_1>().needs;
  field::add({.name = source.factory->name,
              .meaning = source.factory->meaning,
              .needs_curvature = (needs & BURIN_NEEDS_CURVATURE) != 0,
              .missing = "the plug-in gives it no direction there",
              .make =
                  [source](const field::FieldRequest& r) {
                    return Field{source.factory->name, Direction(source, r)};
                  },
              .uses_light = (needs & BURIN_NEEDS_LIGHT) != 0,
              .options = declared(*source.factory)});
}

}  // namespace burin::plugin
