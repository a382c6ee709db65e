#include <burin/stroke/marks.h>

#include "declared.h"
#include "rows.h"

#include <cmath>
#include <memory>

namespace burin::plugin {
namespace {

constexpr auto kStrokeKindRow = PluginError::Row::StrokeKind;

class MarkMaker {
 public:
  MarkMaker(const Source& source, const MarkRequest& request) : source_(source) {
    const auto& functions = source_.functions<burin_stroke_kind_1>();
    const burin_view view = view_of(request.camera, request.shown, Vec3(0), Vec3(0, 0, 1));
    const auto options = declared(*source_.factory);
    const Values values(values_of(request.options.declared, source_.factory->name, options));
    burin_error error{};
    void* self = nullptr;
    check(kStrokeKindRow, source_, functions.make(&view, values.data(), &self, &error), error);
    self_ = std::make_shared<const Self>(self, functions.destroy,
                                         (functions.needs & BURIN_ONE_THREAD) != 0);
  }

  MarkLines operator()(const MarkPlace& place) const {
    const auto& functions = source_.functions<burin_stroke_kind_1>();
    const burin_places at{1,          &place.position.x, &place.normal.x, &place.direction.x,
                          &place.ink, &place.random};
    std::uint32_t count = 0;
    std::vector<double> points(2 * functions.most);
    std::vector<unsigned char> begins(functions.most);
    burin_error error;
    clear(error);
    const std::int32_t code = self_->call([&](const void* self) {
      return functions.marks(self, &at, &count, points.data(), begins.data(), &error);
    });
    check(kStrokeKindRow, source_, code, error);
    if (count > functions.most)
      fail(kStrokeKindRow, source_, "gives more points than a mark may have");
    MarkLines lines;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec2 p(points[2 * i], points[2 * i + 1]);
      if (!std::isfinite(p.x + p.y))
        fail(kStrokeKindRow, source_, "gives something that is no number");
      if (i == 0 || begins[i] != 0) lines.emplace_back();
      lines.back().push_back(p);
    }
    return lines;
  }

 private:
  Source source_;
  std::shared_ptr<const Self> self_;
};

}  // namespace

void add_marks(const Source& source) {
  add(MarkKind{.name = source.factory->name,
               .meaning = source.factory->meaning,
               .make = [source](const MarkRequest& r) -> Marks { return MarkMaker(source, r); },
               .options = declared(*source.factory)});
}

}  // namespace burin::plugin
