#pragma once
/// Rows that are asked for by name.

#include <burin/base/error.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <list>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burin {

template <class Row>
std::vector<std::string> names_of(std::span<const Row> rows) {
  std::vector<std::string> names;
  for (const Row& row : rows) names.emplace_back(row.name);
  return names;
}

/// The row of that name. Throws UsageError that lists them all: "unknown hatch.field 'x'; there are
/// ...", where `what` is "hatch.field".
template <class Row>
const Row& find_row(std::span<const Row> rows, std::string_view name, const std::string& what) {
  const auto found = std::ranges::find(rows, name, &Row::name);
  if (found != rows.end()) return *found;
  std::string all;
  for (const Row& row : rows) all += (all.empty() ? "" : ", ") + std::string(row.name);
  throw UsageError("unknown " + what + " '" + std::string(name) + "'; there are " + all);
}

/// How often catalogues of this program have grown: what is made from their rows is made anew when
/// this has changed.
std::uint64_t catalogue_growth();
void note_catalogue_growth();

/// Rows that stand in the source and, behind them, rows that came from elsewhere. Rows stay where
/// they are for as long as the program runs. From many threads.
template <class Row>
class GrowingCatalogue {
 public:
  explicit GrowingCatalogue(std::vector<Row> own) : own_(own.size()) {
    versions_.push_back(std::move(own));
    now_ = &versions_.back();
  }

  std::span<const Row> rows() const { return *now_.load(); }

  /// Appends a row, in place of one of its name that was added before. Throws UsageError where the
  /// name is that of a row of our own.
  void add(Row row) {
    const std::lock_guard lock(mutex_);
    std::vector<Row> rows = versions_.back();
    const auto same = std::ranges::find(rows, row.name, &Row::name);
    if (same != rows.end() && static_cast<std::size_t>(same - rows.begin()) < own_) {
      throw UsageError("the name '" + std::string(row.name) + "' is taken by Burin's own");
    }
    if (same != rows.end()) {
      *same = std::move(row);
    } else {
      rows.push_back(std::move(row));
    }
    now_ = &versions_.emplace_back(std::move(rows));
    note_catalogue_growth();
  }

 private:
  std::size_t own_;
  std::mutex mutex_;
  std::list<std::vector<Row>> versions_;
  std::atomic<const std::vector<Row>*> now_;
};

/// What is made from the rows of catalogues, made anew when they have grown. What was given out
/// stays. From many threads.
template <class T>
class MadeOfCatalogues {
 public:
  template <class Make>
  const T& get(const Make& make) {
    const std::lock_guard lock(mutex_);
    const std::uint64_t growth = catalogue_growth();
    if (versions_.empty() || growth != growth_) versions_.push_back(make());
    growth_ = growth;
    return versions_.back();
  }

 private:
  std::mutex mutex_;
  std::uint64_t growth_ = 0;
  std::list<T> versions_;
};

}  // namespace burin
