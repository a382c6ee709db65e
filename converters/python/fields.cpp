#include "fields.h"

#include "arrays.h"
#include "held.h"
#include "picture_samples.h"
#include "run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace burin::python {
namespace {

// Points a call: Ctrl-C and progress are heard between calls.
constexpr std::size_t kBatch = 65536;
// Sine of the smallest angle to the normal at which a direction still has a tangent part to follow.
constexpr double kSteepest = 0.01;

/// A function of positions and normals that gives `columns` numbers a point.
class Asked {
 public:
  Asked(const py::object& function, const char* name, py::ssize_t columns)
      : function_(hold(function)), name_(name), columns_(columns) {}

  std::vector<double> operator()(std::span<const Vec3> positions, std::span<const Vec3> normals,
                                 RunId run) const {
    std::vector<double> all;
    for (std::size_t first = 0; first < positions.size(); first += kBatch) {
      const std::size_t n = std::min(kBatch, positions.size() - first);
      in_python([&] { call(positions.subspan(first, n), normals.subspan(first, n), all); }, run);
    }
    return all;
  }

 private:
  static py::array_t<double> array(std::span<const Vec3> v) {
    need_numpy();
    py::array_t<double> out({static_cast<py::ssize_t>(v.size()), py::ssize_t{3}});
    std::memcpy(out.mutable_data(), v.data(), v.size_bytes());
    return out;
  }

  void call(std::span<const Vec3> positions, std::span<const Vec3> normals,
            std::vector<double>& all) const {
    const auto n = static_cast<py::ssize_t>(positions.size());
    const py::object result = (*function_)(array(positions), array(normals));
    const Doubles numbers = Doubles::ensure(result);
    if (!numbers) {
      PyErr_Clear();
      throw py::type_error(fmt::format("{} must give an array of numbers", name_));
    }
    const bool right = columns_ == 1 ? numbers.ndim() == 1 && numbers.shape(0) == n
                                     : numbers.ndim() == 2 && numbers.shape(0) == n &&
                                           numbers.shape(1) == columns_;
    if (!right) {
      const std::string wanted =
          columns_ == 1 ? fmt::format("({},)", n) : fmt::format("({}, {})", n, columns_);
      throw py::value_error(fmt::format("{} must give an array of shape {}, not {}", name_, wanted,
                                        std::string(py::str(numbers.attr("shape")))));
    }
    all.insert(all.end(), numbers.data(), numbers.data() + numbers.size());
  }

  std::shared_ptr<py::object> function_;
  const char* name_;
  py::ssize_t columns_;
};

/// The unit tangent part; nothing where there is none.
std::optional<Vec3> tangent(Vec3 direction, Vec3 normal) {
  const double length = glm::length(direction);
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  const Vec3 t = reject(direction / length, normal);
  const double size = glm::length(t);
  if (size < kSteepest) return std::nullopt;
  return t / size;
}

class SampledField {
 public:
  SampledField(const HatchScene& scene, const Asked& function)
      : samples_(scene), function_(function), run_(this_run()) {
    const std::vector<double> v = function_(samples_.positions(), samples_.normals(), run_);
    directions_.resize(samples_.positions().size());
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      directions_[i] = tangent({v[3 * i], v[3 * i + 1], v[3 * i + 2]}, samples_.normals()[i]);
    }
  }

  std::optional<Cross> operator()(const FieldQuery& q) const {
    const Vec3 n = q.frame.normal;
    const std::optional<Vec3> sampled = direction(q.point.position, turned(n, q));
    const auto t = sampled ? tangent(*sampled, n) : std::nullopt;
    if (!t) return std::nullopt;
    return Cross{*t, glm::cross(n, *t), q.frame.confidence};
  }

 private:
  /// The normal on the side that is seen.
  Vec3 turned(Vec3 normal, const FieldQuery& q) const {
    return glm::dot(normal, camera().to_viewer(q.point.position)) < 0 ? -normal : normal;
  }
  const Camera& camera() const { return samples_.camera(); }

  /// A line has no sign: samples are turned to agree with the nearest.
  std::optional<Vec3> direction(Vec3 position, Vec3 normal) const {
    const PictureSamples::Near near = samples_.near(position, normal);
    if (near.count == 0) {
      if (!samples_.seen(position)) return std::nullopt;
      const std::vector<double> v = function_({&position, 1}, {&normal, 1}, run_);
      return tangent({v[0], v[1], v[2]}, normal);
    }
    const auto& lead = directions_[near.sample[0]];
    if (!lead) return std::nullopt;
    Vec3 sum(0);
    for (std::size_t k = 0; k < static_cast<std::size_t>(near.count); ++k) {
      const auto& d = directions_[near.sample[k]];
      if (d) sum += near.weight[k] * (glm::dot(*d, *lead) < 0 ? -*d : *d);
    }
    return sum;
  }

  PictureSamples samples_;
  Asked function_;
  RunId run_;
  std::vector<std::optional<Vec3>> directions_;
};

class SampledTone {
 public:
  SampledTone(const HatchScene& scene, const Asked& function)
      : samples_(scene), function_(function), run_(this_run()) {
    darkness_ = function_(samples_.positions(), samples_.normals(), run_);
    for (double& d : darkness_) {
      d = clean(d);
      mean_ += d / static_cast<double>(darkness_.size());
    }
  }

  double operator()(Vec3 position, Vec3 normal) const {
    const PictureSamples::Near near = samples_.near(position, normal);
    if (near.count == 0) {
      // Behind something, where no ink shows: any tone will do. White would have points for seeds
      // looked for again and again.
      if (!samples_.seen(position)) return 1 - mean_;
      return 1 - clean(function_({&position, 1}, {&normal, 1}, run_).front());
    }
    double sum = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(near.count); ++k) {
      sum += near.weight[k] * darkness_[near.sample[k]];
    }
    return 1 - sum;
  }

 private:
  /// NaN is no ink.
  static double clean(double d) { return std::isnan(d) ? 0 : std::clamp(d, 0.0, 1.0); }

  PictureSamples samples_;
  Asked function_;
  RunId run_;
  std::vector<double> darkness_;
  double mean_ = 0;
};

void check(const py::object& function, const char* name, const char* gives) {
  if (PyCallable_Check(function.ptr())) return;
  throw py::type_error(fmt::format(
      "argument {} takes a function of positions (n, 3) and normals (n, 3) that gives {}", name,
      gives));
}

}  // namespace

std::function<Field(const HatchScene&)> python_field(const py::object& function) {
  if (function.is_none()) return {};
  check(function, "field", "directions (n, 3)");
  return [asked = Asked(function, "field", 3)](const HatchScene& scene) {
    const auto sampled = std::make_shared<SampledField>(scene, asked);
    return Field{"python", [sampled](const FieldQuery& q) { return (*sampled)(q); }};
  };
}

std::function<Tone(const HatchScene&)> python_tone(const py::object& function) {
  if (function.is_none()) return {};
  check(function, "tone", "darkness (n,)");
  return [asked = Asked(function, "tone", 1)](const HatchScene& scene) -> Tone {
    const auto sampled = std::make_shared<SampledTone>(scene, asked);
    return [sampled](Vec3 position, Vec3 normal) { return (*sampled)(position, normal); };
  };
}

}  // namespace burin::python
