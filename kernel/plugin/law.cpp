#include <burin/tone/catalogue.h>

#include "declared.h"
#include "rows.h"

#include <cmath>
#include <memory>
#include <utility>

namespace burin::plugin {
namespace {

constexpr auto kLawRow = PluginError::Row::Law;

class Law {
 public:
  Law(const Source& source, const tone::LawRequest& request) : source_(source) {
    const auto& functions = source_.functions<burin_law_1>();
    const burin_view view = view_of(request.camera, request.shown,
                                    tone::to_light(request.camera, request.options), Vec3(0, 0, 1));
    const auto options = declared(*source_.factory);
    const Values values(values_of(request.options.declared, source_.factory->name, options));
    burin_error error{};
    void* self = nullptr;
    check(kLawRow, source_, functions.make(&view, values.data(), &self, &error), error);
    self_ = std::make_shared<const Self>(self, functions.destroy,
                                         (functions.needs & BURIN_ONE_THREAD) != 0);
  }

  double operator()(Vec3 position, Vec3 normal) const {
    double reflectance = 0;
    burin_error error;
    clear(error);
    const auto& functions = source_.functions<burin_law_1>();
    const std::int32_t code = self_->call([&](const void* self) {
      return functions.reflectances(self, 1, &position.x, &normal.x, &reflectance, &error);
    });
    check(kLawRow, source_, code, error);
    if (!std::isfinite(reflectance)) fail(kLawRow, source_, "gives something that is no number");
    return reflectance;
  }

 private:
  Source source_;
  std::shared_ptr<const Self> self_;
};

}  // namespace

void add_law(const Source& source) {
  const std::uint32_t needs = source.functions<burin_law_1>().needs;
  tone::add({.name = source.factory->name,
             .meaning = source.factory->meaning,
             .uses_light = (needs & BURIN_NEEDS_LIGHT) != 0,
             .make = [source](const tone::LawRequest& r) -> Tone { return Law(source, r); },
             .options = declared(*source.factory)});
}

}  // namespace burin::plugin
