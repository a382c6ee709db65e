#include "path_piece.h"

#include <algorithm>
#include <cmath>

namespace burin {
namespace {

template <class T>
std::vector<T> opened(const std::vector<T>& values, const Path& path) {
  std::vector<T> out = values;
  if (path.closed && values.size() == path.points.size()) out.push_back(values.front());
  return out;
}

template <class T>
T at(const std::vector<T>& values, double place) {
  const auto i = std::min(static_cast<std::size_t>(place), values.size() - 2);
  return glm::mix(values[i], values[i + 1], place - static_cast<double>(i));
}

}  // namespace

OpenedPath::OpenedPath(const Path& path)
    : path_(path),
      points_(opened(path.points, path)),
      points3_(opened(path.points3, path)),
      width_(opened(path.width, path)) {
  double sum = 0;
  along_.reserve(points_.size());
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (i > 0) sum += glm::distance(points_[i - 1], points_[i]);
    along_.push_back(sum);
  }
}

double OpenedPath::length(double begin, double end) const {
  return at(along_, end) - at(along_, begin);
}

Path OpenedPath::piece(double begin, double end) const {
  Path piece = without_points(path_);
  const auto take = [&](const auto& values, auto& to) {
    if (values.size() != points_.size()) {
      to = values;
      return;
    }
    to.push_back(at(values, begin));
    const auto first = static_cast<std::size_t>(std::floor(begin)) + 1;
    for (std::size_t i = first; static_cast<double>(i) < end; ++i) to.push_back(values[i]);
    to.push_back(at(values, end));
  };
  take(points_, piece.points);
  take(points3_, piece.points3);
  take(width_, piece.width);
  const auto before = static_cast<std::uint32_t>(std::floor(begin));
  for (const PathFace& run : path_.faces) {
    if (static_cast<double>(run.first_point) >= end) break;
    if (run.first_point <= before) {
      piece.faces = {{0, run.face}};
    } else {
      piece.faces.push_back({run.first_point - before, run.face});
    }
  }
  if (piece.faces.size() == 1) {
    piece.source.face = piece.faces.front().face;
    piece.faces.clear();
  }
  return piece;
}

void add_also(Path& path, const PathSource& source) {
  if (source == PathSource{path.source, path.kind}) return;
  if (std::ranges::find(path.also, source) == path.also.end()) path.also.push_back(source);
}

void append(Path& to, const Path& more) {
  const auto add = [&](auto& values, const auto& others, std::size_t points) {
    if (values.size() == points && !others.empty()) {
      values.insert(values.end(), others.begin() + 1, others.end());
    }
  };
  const std::size_t points = to.points.size(), joint = points - 1;
  const auto face = [](const Path& path) {
    return path.faces.empty() ? std::vector<PathFace>{{0, path.source.face}} : path.faces;
  };
  std::vector<PathFace> faces = face(to);
  for (const PathFace& run : face(more)) {
    if (run.face == faces.back().face) continue;
    faces.push_back({run.first_point + static_cast<std::uint32_t>(joint), run.face});
  }
  if (faces.size() > 1) to.faces = std::move(faces);
  add(to.points3, more.points3, points);
  if (to.width.size() == points && points > 1) add(to.width, more.width, points);
  add(to.points, more.points, points);
}

}  // namespace burin
