#include <burin/arrange/arrange.h>
#include <burin/assembly/select.h>
#include <burin/base/error.h>
#include <burin/base/short_list.h>
#include <burin/threads/find_threads.h>
#include <burin/threads/unified.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace burin {
namespace {

/// Of a part's size: chord tolerance of what its cylinders are found on, whose corners are exact.
constexpr double kTolerance = 1e-3;
/// Of the diameter: no thread has a longer pitch, and no smaller minor diameter.
constexpr double kMostPitch = 0.4, kLeastMinor = 0.4;

[[noreturn]] void refuse(const ThreadRow& row, const std::string& what) {
  throw UsageError(row.place + what);
}

/// "thread 'M6'", "thread".
std::string called(const ThreadRow& row) {
  return row.size.empty() ? "a thread" : fmt::format("thread '{}'", row.size);
}

void check_number(const ThreadRow& row, const std::optional<double>& value, const char* name) {
  if (!value || (std::isfinite(*value) && *value > 0)) return;
  refuse(row, fmt::format("{}: {} takes mm over 0, not {:g}", called(row), name, *value));
}

WantedThread wanted_of(const ThreadRow& row) {
  check_number(row, row.diameter, "diameter");
  check_number(row, row.pitch, "pitch");
  check_number(row, row.minor, "minor");
  check_number(row, row.length, "length");
  if (!(std::isfinite(row.start) && row.start >= 0)) {
    refuse(row, fmt::format("{}: start takes mm from 0, not {:g}", called(row), row.start));
  }
  const auto said = known_size(row.size);
  if (!row.size.empty() && !said && !row.diameter) {
    refuse(row, fmt::format("'{}' is no size that is known, as M6, M6x0.75 or 1/4 UNC; of others "
                            "say diameter and pitch, too",
                            row.size));
  }
  if (row.size.empty() && !row.diameter && !row.at && !row.face) {
    refuse(row, "a thread has a size, a diameter, a face or a point of its cylinder (at)");
  }
  WantedThread wanted{.diameter = row.diameter.value_or(said ? said->diameter : 0),
                      .pitch = row.pitch.value_or(said ? said->pitch.value_or(0) : 0),
                      .minor = row.minor.value_or(0),
                      .designation = row.size,
                      .at = row.at,
                      .face = row.face,
                      .start = row.start,
                      .length = row.length};
  if (wanted.diameter > 0 && wanted.pitch > kMostPitch * wanted.diameter) {
    refuse(row, fmt::format("{}: a pitch of {:g} mm is too long for {:g} mm; the length of a "
                            "thread is `length`",
                            called(row), wanted.pitch, wanted.diameter));
  }
  const bool odd = wanted.minor >= wanted.diameter || wanted.minor < kLeastMinor * wanted.diameter;
  if (wanted.diameter > 0 && wanted.minor > 0 && odd) {
    refuse(row, fmt::format("{}: a minor diameter of {:g} mm is none of {:g} mm", called(row),
                            wanted.minor, wanted.diameter));
  }
  return wanted;
}

/// A row with the parts that it is about.
struct Asked {
  const ThreadRow* row;
  WantedThread wanted;
  std::vector<std::size_t> parts;
  std::size_t found = 0;
  /// Why a part has none, and why one of its threads is shorter than asked.
  std::string missing = {}, shorter = {};
};

std::vector<Asked> asked_of(const Scene& scene, const std::vector<ThreadRow>& rows) {
  std::vector<Asked> out;
  for (const ThreadRow& row : rows) {
    Asked& one = out.emplace_back(Asked{&row, wanted_of(row), {}});
    try {
      for (const std::string& selector : row.select) {
        for (const std::size_t part : select(scene, selector)) one.parts.push_back(part);
      }
    } catch (const UsageError& e) {
      throw UsageError(row.place + e.what());
    }
    std::ranges::sort(one.parts);
    one.parts.erase(std::unique(one.parts.begin(), one.parts.end()), one.parts.end());
  }
  return out;
}

/// Finds the threads of one part after the other.
class Finding {
 public:
  Finding(Scene& scene, const Illustration& illustration, RunContext& context)
      : scene_(scene), illustration_(illustration), context_(context) {}

  void part(std::size_t i, std::vector<Asked>& asked) {
    Part& part = scene_.parts[i];
    const auto surface = realised(i);
    std::optional<ThreadFinder> finder;
    if (surface) finder.emplace(*surface, context_);
    std::vector<Thread> told = std::exchange(part.threads, {});
    for (const Thread& one : told) {
      const auto found = finder ? finder->settled(one) : std::nullopt;
      if (found) {
        put(*found, part.threads);
      } else if (!part.whole) {  // else it is of another body
        lost_.insert(fmt::format("'{}': {}", part.name, one.designation));
      }
    }
    std::vector<Thread> of_rows;
    for (Asked& row : asked) {
      if (!finder || !std::ranges::binary_search(row.parts, i)) continue;
      FoundThreads found = finder->find(row.wanted);
      for (const Thread& one : found.threads) {
        for (const Thread& other : of_rows) {
          if (meet(one, other) && one.designation != other.designation) {
            replaced_.insert(fmt::format("'{}': {} instead of {}", part.name, one.designation,
                                         other.designation));
          }
        }
        put(one, part.threads);
      }
      of_rows.insert(of_rows.end(), found.threads.begin(), found.threads.end());
      row.found += found.threads.size();
      if (!found.shorter.empty()) row.shorter = fmt::format("'{}': {}", part.name, found.shorter);
      if (!found.missing.empty() && row.missing.empty()) {
        row.missing = fmt::format("'{}': {}", part.name, found.missing);
      }
      without_table_.insert(found.without_table.begin(), found.without_table.end());
    }
  }

  void report(const std::vector<Asked>& asked) {
    for (const Asked& one : asked) {
      if (!one.shorter.empty()) {
        scene_.diagnostics.add(Severity::Warning, "threads.shorter", 1,
                               fmt::format("{}{} is shorter than its length: {}", one.row->place,
                                           called(*one.row), one.shorter));
      }
      if (one.found > 0) continue;
      scene_.diagnostics.add(
          Severity::Warning, "threads.no_face", 1,
          fmt::format("{}{} is not drawn: {}", one.row->place, called(*one.row),
                      one.missing.empty() ? "its parts are not drawn" : one.missing));
    }
    if (!replaced_.empty()) {
      scene_.diagnostics.add(
          Severity::Warning, "threads.replaced", static_cast<std::int64_t>(replaced_.size()),
          fmt::format("of two threads on one cylinder the last is drawn: {}; name the cylinder by "
                      "`face` or `at`",
                      short_list(replaced_, 4)));
    }
    if (!lost_.empty()) {
      scene_.diagnostics.add(
          Severity::Info, "threads.lost", static_cast<std::int64_t>(lost_.size()),
          fmt::format("threads without a cylinder that they are on are not drawn: {}",
                      short_list(lost_, 4)));
    }
    for (const double diameter : without_table_) {
      scene_.diagnostics.add(
          Severity::Info, "threads.no_table", 1,
          fmt::format("ISO 261 has no coarse thread of {:.4g} mm: its minor diameter is drawn as "
                      "0.85 of that, where a row has no pitch",
                      diameter));
    }
  }

 private:
  std::shared_ptr<const Surface> realised(std::size_t i) {
    const Form& form = *scene_.parts[i].form;
    const std::optional<Style>& own = illustration_.illustrate.part_styles[i].style;
    const Style& style = own ? *own : illustration_.style;
    try {
      return form.realise(
          {.tolerance = std::max(kTolerance * form.bounds(Mat3(1)).diagonal(), 1e-12),
           .crease_angle = style.feature.crease_angle,
           .curvature = false},
          context_);
    } catch (const GeometryError&) {
      return nullptr;  // drawing it says why
    }
  }

  static bool meet(const Thread& a, const Thread& b) {
    return a.face == b.face && a.begin < b.end && b.begin < a.end;
  }

  /// Over another one on its face that it meets.
  static void put(const Thread& thread, std::vector<Thread>& all) {
    std::erase_if(all, [&](const Thread& other) { return meet(thread, other); });
    all.push_back(thread);
  }

  Scene& scene_;
  const Illustration& illustration_;
  RunContext& context_;
  std::set<std::string> lost_, replaced_;
  std::set<double> without_table_;
};

}  // namespace

void check_thread_row(const ThreadRow& row) { wanted_of(row); }

void find_threads(Scene& scene, const Illustration& illustration, RunContext& context) {
  std::vector<Asked> asked = asked_of(scene, illustration.thread_rows);
  std::vector<bool> wanted(scene.parts.size(), false);
  for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] = !scene.parts[i].threads.empty();
  for (const Asked& one : asked) {
    for (const std::size_t part : one.parts) wanted[part] = true;
  }
  const std::vector<bool> drawn = drawn_parts(scene, illustration.illustrate.part_styles);
  if (std::ranges::find(wanted, true) == wanted.end()) return;
  context.begin_stage(RunStage::Build);
  Finding finding(scene, illustration, context);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    context.check();
    if (wanted[i] && drawn[i]) finding.part(i, asked);
  }
  context.end_stage();
  finding.report(asked);
}

}  // namespace burin
