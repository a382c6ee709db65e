#include "narrow_faces.h"

#include <burin/mesh/whole_faces.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace burin::detail {
namespace {

constexpr std::size_t kAsked = 32;  // cells of a face
constexpr double kNarrow = 1.2;     // shortest strokes
constexpr double kSlim = 2;         // times as long as wide
constexpr std::uint32_t kCheckEvery = 65536;
constexpr double kGoesOn = 0.7;  // sine of the turn up to which lines go on

// Faces that seams alone divide: lines on one are lines on the other.
class WholeFaces {
 public:
  explicit WholeFaces(const Picture& picture) {
    for (const Surface* surface : picture.surfaces) parts_.push_back(whole_faces(surface->proxy()));
  }

  // One face for all of its pieces.
  std::int32_t whole(std::int32_t part, std::int32_t face) const {
    const auto& faces = parts_[static_cast<std::size_t>(part)];
    return faces.empty() ? face : faces[static_cast<std::size_t>(face)];
  }
  std::vector<std::int32_t> pieces(std::int32_t part, std::int32_t whole) const {
    const auto& faces = parts_[static_cast<std::size_t>(part)];
    if (faces.empty()) return {whole};
    std::vector<std::int32_t> out;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (faces[f] == whole) out.push_back(static_cast<std::int32_t>(f));
    }
    return out;
  }

 private:
  std::vector<std::vector<std::int32_t>> parts_;
};

class Finder {
 public:
  Finder(const Picture& picture, const ViewRaster& raster, const WaveGraph& graph)
      : picture_(picture),
        raster_(raster),
        graph_(graph),
        faces_(picture),
        narrow_(kNarrow * picture.options.length_min) {}

  FaceSet find(const RunContext& context) const {
    using Key = FaceSet::value_type;
    std::map<Key, std::vector<std::uint32_t>> faces;
    Key last{-1, -1};
    std::vector<std::uint32_t>* nodes = nullptr;
    for (std::uint32_t i = 0; i < graph_.nodes.size(); ++i) {
      if (i % kCheckEvery == 0) context.check();
      if (!inked(i)) continue;
      if (const Key key{cell(i).part, face(i)}; key != last || !nodes) {
        nodes = &faces[key];
        last = key;
      }
      nodes->push_back(i);
    }
    FaceSet out;
    for (const auto& [key, cells] : faces) {
      context.check();
      if (!is_narrow(cells)) continue;
      for (const std::int32_t piece : faces_.pieces(key.first, key.second)) {
        out.insert({key.first, piece});
      }
    }
    return out;
  }

 private:
  const RasterCell& cell(std::uint32_t node) const {
    return raster_.cells[graph_.nodes[node].cell];
  }
  std::int32_t face(std::uint32_t node) const {
    const RasterCell& c = cell(node);
    return faces_.whole(c.part, picture_.surface(c.part).proxy().face_source(c.face));
  }
  bool inked(std::uint32_t node) const {
    return picture_.share(cell(node).darkness, 1) >= picture_.options.tone_min;
  }

  bool is_narrow(const std::vector<std::uint32_t>& nodes) const {
    const std::size_t stride = std::max<std::size_t>(1, nodes.size() / kAsked);
    double along = 0, across = 0, asked = 0;
    for (std::size_t k = 0; k < nodes.size(); k += stride, ++asked) {
      const std::uint32_t own = nodes[k];
      const Vec2 wave = glm::normalize(graph_.nodes[own].wave), line(-wave.y, wave.x);
      const auto on_face = [&](std::uint32_t i) {
        return cell(i).part == cell(own).part && face(i) == face(own) && inked(i);
      };
      const auto goes_on = [&](std::uint32_t i) {
        const Vec2 there = graph_.nodes[i].wave;
        return graph_.component[i] == graph_.component[own] && inked(i) &&
               std::abs(glm::dot(there, line)) < kGoesOn * glm::length(there);
      };
      along += chord(own, line, goes_on);
      across += chord(own, wave, on_face);
    }
    return along < narrow_ * asked && across > kSlim * along;
  }

  // Paper mm from a node both ways along a direction as far as the nodes there fulfil a condition.
  template <class Condition>
  double chord(std::uint32_t node, Vec2 direction, const Condition& holds) const {
    const Vec2 from = raster_.center(std::size_t{graph_.nodes[node].cell});
    constexpr double kFar = 3;  // times what is narrow: no need to know more
    double sum = raster_.pitch;
    for (const double way : {1.0, -1.0}) {
      for (double s = raster_.pitch; s < kFar * narrow_; s += raster_.pitch) {
        const Vec2 p = from + way * s * direction;
        if (!raster_.contains(p)) break;
        const std::int32_t i = graph_.node[raster_.index(p)];
        if (i == kNone || !holds(static_cast<std::uint32_t>(i))) break;
        sum += raster_.pitch;
      }
    }
    return sum;
  }

  const Picture& picture_;
  const ViewRaster& raster_;
  const WaveGraph& graph_;
  WholeFaces faces_;
  double narrow_;
};

}  // namespace

FaceSet narrow_faces(const Picture& picture, const ViewRaster& raster, const WaveGraph& graph,
                     const RunContext& context) {
  return Finder(picture, raster, graph).find(context);
}

Field turned(const Picture& picture, FaceSet faces) {
  Field out = picture.field;
  const auto all = std::make_shared<const FaceSet>(std::move(faces));
  out.cross = [cross = picture.field.cross, surfaces = picture.surfaces,
               all](const FieldQuery& query) -> std::optional<Cross> {
    std::optional<Cross> found = cross(query);
    if (!found) return found;
    const Surface& surface = *surfaces[static_cast<std::size_t>(query.part)];
    const std::int32_t face = surface.proxy().face_source(surface.to_proxy(query.point).face);
    if (all->contains({query.part, face})) std::swap(found->first, found->second);
    return found;
  };
  return out;
}

}  // namespace burin::detail
