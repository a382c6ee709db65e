#include "solid_store.h"

#include <burin/base/disjoint_sets.h>

#include "affine.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>

namespace burin::detail {
namespace {

// What six digits leave of a matrix, and of the product of eight within each other: shares of 1.
constexpr double kStoredDigits = 3e-6, kDigitsOfMany = 1.5e-5;

/// The scale that was meant, where one of three or four digits is as near: copies of one thing are
/// of one size, whichever way they are turned.
double meant_scale(double scale) {
  const auto near = [&](double meant, double digits) {
    return std::abs(scale - meant) <= digits * scale;
  };
  const double three = std::round(1e3 * scale) / 1e3, four = std::round(1e4 * scale) / 1e4;
  return near(three, kDigitsOfMany) ? three : near(four, kStoredDigits) ? four : scale;
}

/// A placement within what six digits leave of its matrices; nothing where it does more than turn,
/// mirror, move and scale alike in all directions.
std::optional<Placement> placement_of(const csg::Matrix& m) {
  const Affine by(m);
  const double scale = meant_scale(std::cbrt(std::abs(glm::determinant(by.linear))));
  if (!(scale > 0) || off_rotation(by.linear / scale) > kDigitsOfMany) return std::nullopt;
  // The nearest rotation, by Newton's method for the polar decomposition.
  Mat3 turn = by.linear / scale;
  for (int i = 0; i < 4; ++i) turn = 0.5 * (turn + glm::transpose(glm::inverse(turn)));
  return Placement{scale * turn, by.offset};
}

/// A placement that stretches or shears, where it is far from flat.
std::optional<Placement> stretch_of(const csg::Matrix& m) {
  constexpr double kFlattest = 1e-2;
  const Affine by(m);
  const Vec3 size(glm::length(by.linear[0]), glm::length(by.linear[1]), glm::length(by.linear[2]));
  const double least = std::min({size.x, size.y, size.z}),
               most = std::max({size.x, size.y, size.z});
  const bool finite = std::isfinite(most) && std::isfinite(glm::length(by.offset));
  if (!finite || !(least >= kFlattest * most) || !(most > 0)) return std::nullopt;
  if (std::abs(glm::determinant(by.linear)) < kFlattest * size.x * size.y * size.z) {
    return std::nullopt;
  }
  return Placement{by.linear, by.offset};
}

/// Whether spheres are among what makes a node.
bool holds_sphere(const csg::Tree& tree, std::uint32_t node) {
  for (std::uint32_t n = node; n < tree.nodes[node].end; ++n) {
    if (tree.nodes[n].module == csg::Module::Sphere) return true;
  }
  return false;
}

csg::Matrix product(const csg::Matrix& outer, const csg::Matrix& inner) {
  return outer == csg::Matrix{} ? inner : outer * inner;
}

std::string matrix_text(const csg::Matrix& m) {
  std::string text = "multmatrix([";
  for (const auto& row : m.row) {
    text += fmt::format("[{},{},{},{}],", row[0], row[1], row[2], row[3]);
  }
  return text + "[0,0,0,1]])";
}

/// A part as the text of what it is an instance of, and where that stands.
struct Instance {
  std::string text;
  /// How many nodes the text has.
  std::uint32_t nodes = 0;
  Placement place;
  double growth = 1;

  void stands(const Placement& at, const csg::Matrix& m) {
    place = at;
    growth = std::abs(m.determinant());
  }
};

Instance instance_of(const csg::Tree& tree, const TreePart& part) {
  Instance out;
  for (const TreePart::Piece& piece : part.pieces) {
    out.nodes += tree.nodes[piece.node].end - piece.node;
  }
  if (part.pieces.size() == 1) {
    const csg::Matrix m = product(part.frame, part.pieces.front().at);
    auto place = placement_of(m);
    // The form of a ball knows what it becomes; facets that were stretched would not.
    if (!place && holds_sphere(tree, part.pieces.front().node)) place = stretch_of(m);
    if (place) {
      out.stands(*place, m);
      out.text = std::string(tree.text_of(part.pieces.front().node));
      return out;
    }
  }
  const auto frame = placement_of(part.frame);
  if (frame) out.stands(*frame, part.frame);
  for (const TreePart::Piece& piece : part.pieces) {
    const std::string_view text = tree.text_of(piece.node);
    const csg::Matrix at = frame ? piece.at : product(part.frame, piece.at);
    if (at == csg::Matrix{}) {
      out.text += text;
    } else {
      out.text += fmt::format("{}{{{}}}", matrix_text(at), text);
      ++out.nodes;
    }
    out.text += '\n';
  }
  return out;
}

double volume_of(const csg::Solid& solid) {
  double sum = 0;
  if (solid.empty()) return sum;
  const Vec3 origin = solid.positions[solid.triangles[0][0]];  // far solids lose no digits
  for (const auto& t : solid.triangles) {
    sum += glm::dot(solid.positions[t[0]] - origin,
                    glm::cross(solid.positions[t[1]] - origin, solid.positions[t[2]] - origin));
  }
  return sum / 6;
}

/// What hangs together by points in one place.
std::size_t shells_of(const csg::Solid& solid) {
  std::vector<std::uint32_t> order(solid.positions.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto less = [&](std::uint32_t i, std::uint32_t j) {
    const Vec3 &a = solid.positions[i], &b = solid.positions[j];
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  };
  std::ranges::sort(order, less);
  DisjointSets sets(order.size());
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (!less(order[k - 1], order[k])) sets.join(order[k - 1], order[k]);
  }
  for (const auto& t : solid.triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[1], t[2]);
  }
  std::vector<char> counted(order.size(), 0);
  std::size_t count = 0;
  for (const auto& t : solid.triangles) {
    char& seen = counted[sets.find(t[0])];
    count += seen == 0 ? 1 : 0;
    seen = 1;
  }
  return count;
}

}  // namespace

std::string key_of(const std::string& text) {
  if (text.find('"') != std::string::npos) return text;
  std::string out;
  out.reserve(text.size());
  bool begins = true;
  for (const char c : text) {
    if (begins && (c == '\t' || c == ' ')) continue;
    begins = c == '\n';
    out += c;
  }
  return out;
}

csg::ChildOptions evaluation_of(const std::filesystem::path& path) {
  csg::ChildOptions options;
  options.folder = std::filesystem::absolute(path).parent_path();
  options.file = path.string();
  return options;
}

SolidStore::SolidStore(const csg::Tree& tree, std::filesystem::path path, RunContext& context)
    : tree_(tree), path_(std::move(path)), context_(context) {}

std::vector<StoredPart> SolidStore::store(const std::vector<TreePart>& parts,
                                          Diagnostics& diagnostics) {
  std::vector<StoredPart> out;
  // One text of what has to be evaluated, and the numbers of its objects.
  std::string text;
  std::vector<std::uint32_t> objects;
  std::map<std::int64_t, std::string> begins;  // lines of the text, and what part they are of
  std::int64_t line = 1;
  std::uint32_t next = 1;
  for (const TreePart& part : parts) {
    const Instance instance = instance_of(tree_, part);
    const auto [entry, fresh] =
        known_.try_emplace(key_of(instance.text), solids_.size() + objects.size());
    if (fresh) {
      begins.emplace(line, part.assembly.empty() ? part.name : part.assembly);
      line += 2 + std::ranges::count(instance.text, '\n') + 1;
      text += fmt::format("group(){{\n{}}}\n", instance.text);
      objects.push_back(next);
      next += 1 + instance.nodes;
    }
    out.push_back({entry->second, instance.place, instance.growth});
  }
  if (objects.empty()) return out;
  csg::ChildOptions options = evaluation_of(path_);
  options.where = [&](std::int64_t of) {
    const auto after = begins.upper_bound(of);
    return after == begins.begin() ? std::string() : "in " + std::prev(after)->second;
  };
  std::vector<csg::Solid> made =
      csg::evaluate_in_child(text, objects, options, context_, diagnostics);
  std::ranges::move(made, std::back_inserter(solids_));
  return out;
}

Bulk SolidStore::bulk(const StoredPart& part) {
  const auto [at, fresh] = bulks_.try_emplace(part.solid);
  if (fresh) at->second = {volume_of(solids_[part.solid]), shells_of(solids_[part.solid])};
  return {part.growth * at->second.volume, at->second.shells};
}

}  // namespace burin::detail
