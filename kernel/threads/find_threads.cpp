#include <burin/threads/find_threads.h>
#include <burin/threads/metric.h>

#include "cylinders.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace burin {
namespace {

using detail::Cylinder;

/// Of diameters: how far a shaft may be off the major one.
constexpr double kShaft = 0.015;
/// The same of a hole that is as wide as the thread: clearance holes are wider.
constexpr double kNominal = 0.005;
/// A hole is no narrower than this share of the minor diameter; drills for forming threads are
/// wider, by this share of the way to the major one at the most. Holes that are modelled as wide as
/// the thread have it, too.
constexpr double kNarrowest = 0.985, kWidest = 0.75;
/// The minor diameter of a thread that no table has, of its major one.
constexpr double kMinorShare = 0.85;
/// Of a length: ends that are nearer to each other are one.
constexpr double kSameEnd = 1e-9;
/// Radii of a cylinder within which a point means it.
constexpr double kNear = 3;
/// Of a radius: the same where an input tells both, whose numbers are rounded.
constexpr double kSameTold = 1e-3;

/// Diameters of a thread.
struct Size {
  double major = 0, minor = 0;
  bool in_table = true;
};

double minor_of(double major, double pitch, bool& in_table) {
  if (pitch > 0) return minor_diameter(major, pitch);
  const auto coarse = coarse_pitch(major);
  in_table = coarse.has_value();
  return coarse ? minor_diameter(major, *coarse) : kMinorShare * major;
}

/// Of what is wanted, on a cylinder where the wanted does not say it.
Size size_on(const WantedThread& wanted, double diameter, bool hollow) {
  Size size{wanted.diameter, wanted.minor};
  if (size.major <= 0 && !hollow) size.major = diameter;
  if (size.major <= 0) {
    const auto coarse = coarse_of_minor(diameter);
    size.in_table = coarse.has_value();
    size.major = coarse.value_or(diameter / kMinorShare);
  }
  if (size.minor <= 0) {
    bool in_table = true;
    size.minor = minor_of(size.major, wanted.pitch, in_table);
    size.in_table = size.in_table && in_table;
  }
  return size;
}

bool fits(const Size& size, double diameter, bool hollow) {
  if (std::abs(diameter - size.major) <= (hollow ? kNominal : kShaft) * size.major) return true;
  return hollow && diameter >= kNarrowest * size.minor &&
         diameter <= size.minor + kWidest * (size.major - size.minor);
}

/// From a point to the wall of a cylinder or to its axis, whichever is nearer.
double off(const Cylinder& cylinder, Vec3 point) {
  const double height = glm::dot(point - cylinder.axis.point, cylinder.axis.along);
  const double beyond =
      std::max({0.0, cylinder.extent.low - height, height - cylinder.extent.high});
  const double out = glm::length(cylinder.axis.to(point));
  return std::hypot(beyond, std::min(out, std::abs(out - cylinder.extent.radius)));
}

}  // namespace

struct ThreadFinder::Impl {
  Impl(const Surface& of, const RunContext& context)
      : surface(of), cylinders(detail::cylinders_of(of, context)), rays(of.proxy(), context) {}

  const Surface& surface;
  std::vector<Cylinder> cylinders;
  detail::OwnRays rays;

  Thread on(const Cylinder& cylinder, const Size& size) const;
  void limit(Thread& thread, const WantedThread& wanted) const;
  std::vector<const Cylinder*> asked(const WantedThread& wanted) const;
  std::string no_cylinder(const WantedThread& wanted) const;
  static std::string none_fits(const WantedThread& wanted,
                               const std::vector<const Cylinder*>& asked);
};

/// As far as the cylinder goes.
Thread ThreadFinder::Impl::on(const Cylinder& cylinder, const Size& size) const {
  Thread thread{.axis = cylinder.axis,
                .begin = cylinder.extent.low,
                .end = cylinder.extent.high,
                .major = 0.5 * size.major,
                .minor = 0.5 * size.minor,
                .internal = cylinder.hollow,
                .face = cylinder.faces.front(),
                .modelled = cylinder.extent.radius};
  const auto low = detail::open_end(cylinder, thread.thin(), false, surface, rays),
             high = detail::open_end(cylinder, thread.thin(), true, surface, rays);
  thread.open_begin = low.has_value();
  thread.open_end = high.has_value();
  thread.begin = low.value_or(thread.begin);
  thread.end = high.value_or(thread.end);
  return thread;
}

/// From an end, by the start and the length that are wanted.
void ThreadFinder::Impl::limit(Thread& thread, const WantedThread& wanted) const {
  const double whole = thread.end - thread.begin, least = kSameEnd * whole;
  bool from_high = thread.open_end && !thread.open_begin;
  if (thread.open_end == thread.open_begin) {
    from_high = true;
    if (wanted.at) {
      const double height = glm::dot(*wanted.at - thread.axis.point, thread.axis.along);
      from_high = thread.end - height < height - thread.begin;
    }
  }
  const double start = std::min(wanted.start, whole);
  const double rest = std::min(wanted.length.value_or(whole), whole - start);
  if (start > least) (from_high ? thread.open_end : thread.open_begin) = false;
  if (whole - start - rest > least) (from_high ? thread.open_begin : thread.open_end) = false;
  if (from_high) {
    thread.end -= start;
    thread.begin = thread.end - rest;
  } else {
    thread.begin += start;
    thread.end = thread.begin + rest;
  }
}

/// The cylinders that may be meant; those that fit are not chosen yet.
std::vector<const Cylinder*> ThreadFinder::Impl::asked(const WantedThread& wanted) const {
  std::vector<const Cylinder*> out;
  for (const Cylinder& one : cylinders) {
    if (!wanted.face || std::ranges::find(one.faces, *wanted.face) != one.faces.end()) {
      out.push_back(&one);
    }
  }
  return out;
}

std::string ThreadFinder::Impl::no_cylinder(const WantedThread& wanted) const {
  if (!wanted.face) return "it has no cylinder";
  const ProxyMesh& proxy = surface.proxy();
  std::int32_t last = -1;
  for (std::uint32_t t = 0; t < proxy.mesh.triangles.size(); ++t) {
    last = std::max(last, proxy.face_source(t));
  }
  if (*wanted.face < 0 || *wanted.face > last) {
    return fmt::format("it has no face {}; they are 0 to {}", *wanted.face, last);
  }
  return fmt::format("face {} is no cylinder", *wanted.face);
}

ThreadFinder::ThreadFinder(const Surface& surface, const RunContext& context)
    : impl_(std::make_unique<Impl>(surface, context)) {}
ThreadFinder::~ThreadFinder() = default;

/// Why none of the cylinders is as wide as it has to be.
std::string ThreadFinder::Impl::none_fits(const WantedThread& wanted,
                                          const std::vector<const Cylinder*>& asked) {
  const double first = 2 * asked.front()->extent.radius;
  const Size size = size_on(wanted, first, asked.front()->hollow);
  std::string out = fmt::format(
      "it has no shaft of {0:.4g} mm and no hole of {1:.4g} to {2:.4g} or {0:.4g} mm", size.major,
      kNarrowest * size.minor, size.minor + kWidest * (size.major - size.minor));
  if (wanted.face) out += fmt::format("; face {} has {:.4g} mm", *wanted.face, first);
  return out;
}

FoundThreads ThreadFinder::find(const WantedThread& wanted) const {
  FoundThreads found;
  const std::vector<const Cylinder*> asked = impl_->asked(wanted);
  if (asked.empty()) {
    found.missing = impl_->no_cylinder(wanted);
    return found;
  }
  std::vector<std::pair<const Cylinder*, Size>> fitting;
  for (const Cylinder* one : asked) {
    const double diameter = 2 * one->extent.radius;
    const Size size = size_on(wanted, diameter, one->hollow);
    if (fits(size, diameter, one->hollow)) fitting.emplace_back(one, size);
  }
  if (fitting.empty()) {
    found.missing = Impl::none_fits(wanted, asked);
    return found;
  }
  if (wanted.at) {
    const auto away = [&](const auto& one) { return off(*one.first, *wanted.at); };
    const auto nearest = std::ranges::min_element(fitting, {}, away);
    if (away(*nearest) > kNear * nearest->first->extent.radius) {
      found.missing =
          fmt::format("the next cylinder of that size is {:.4g} mm from its point", away(*nearest));
      return found;
    }
    fitting = {*nearest};
  }
  for (const auto& [cylinder, size] : fitting) {
    Thread thread = impl_->on(*cylinder, size);
    const double whole = thread.end - thread.begin;
    impl_->limit(thread, wanted);
    if (thread.end - thread.begin <= kSameEnd * whole) {
      found.missing = fmt::format("its cylinder is {:.4g} mm long, and it begins at {:.4g} mm",
                                  whole, wanted.start);
      continue;
    }
    if (wanted.length && wanted.start + *wanted.length > (1 + kSameTold) * whole) {
      found.shorter = fmt::format("its cylinder ends after {:.4g} mm", whole - wanted.start);
    }
    thread.designation =
        wanted.designation.empty() ? fmt::format("M{:g}", size.major) : wanted.designation;
    if (!size.in_table) found.without_table.push_back(size.major);
    found.threads.push_back(std::move(thread));
  }
  return found;
}

std::optional<Thread> ThreadFinder::settled(const Thread& told) const {
  const Size size{2 * told.major, 2 * told.minor};
  for (const Cylinder& cylinder : impl_->cylinders) {
    if (cylinder.hollow != told.internal) continue;
    if (!fits(size, 2 * cylinder.extent.radius, cylinder.hollow)) continue;
    const double near = kShaft * cylinder.extent.radius;
    const auto point = [&](double height) { return told.axis.point + height * told.axis.along; };
    if (glm::length(cylinder.axis.to(point(told.begin))) > near ||
        glm::length(cylinder.axis.to(point(told.end))) > near) {
      continue;
    }
    Thread whole = impl_->on(cylinder, size);
    const auto height = [&](double h) {
      return glm::dot(point(h) - cylinder.axis.point, cylinder.axis.along);
    };
    const double from = std::min(height(told.begin), height(told.end)),
                 to = std::max(height(told.begin), height(told.end));
    if (to < whole.begin || from > whole.end) continue;
    const double same = kSameTold * cylinder.extent.radius;
    if (from > whole.begin + same) {
      whole.begin = from;
      whole.open_begin = false;
    }
    if (to < whole.end - same) {
      whole.end = to;
      whole.open_end = false;
    }
    whole.designation = told.designation;
    return whole;
  }
  return std::nullopt;
}

}  // namespace burin
