#include "tried_before.h"

#include <burin/base/input_files.h>
#include <burin/base/platform.h>
#include <burin/plugin/plugins.h>

#include "search.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <system_error>

namespace burin::plugin {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "burin-plugins-tried-1";
constexpr std::size_t kMostEntries = 1000;
constexpr std::uintmax_t kLargestFile = 1 << 20;

fs::path cache_file() {
  const fs::path folder = cache_folder();
  return folder.empty() ? folder : folder / "plugins.json";
}

std::string json_text(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

}  // namespace

std::string identity_of(const fs::path& file) {
  const FileStamp s = stamp_of(file);
  if (!s.there) return {};
  return fmt::format("{}-{}-{}-{}-{}", s.device, s.node, s.size, s.changed, s.renewed);
}

TriedBefore TriedBefore::from_text(const std::string& text) {
  TriedBefore all;
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || json_text(json, "format") != kFormat) return all;
  const auto files = json.find("files");
  if (files == json.end() || !files->is_object()) return all;
  for (const auto& [file, entry] : files->items()) {
    if (all.files_.size() == kMostEntries || !entry.is_object()) break;
    const std::string identity = json_text(entry, "identity"), probe = json_text(entry, "probe");
    const auto fault = entry.find("fault");
    if (identity.empty() || probe.empty() || fault == entry.end() || !fault->is_string()) continue;
    all.files_[file] = {identity, probe, fault->get<std::string>()};
  }
  return all;
}

std::string TriedBefore::to_text() const {
  Json json{{"format", kFormat}, {"files", Json::object()}};
  for (const auto& [file, e] : files_) {
    json["files"][file] = {{"identity", e.identity}, {"probe", e.probe}, {"fault", e.fault}};
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::optional<std::string> TriedBefore::find(const fs::path& file, const std::string& identity,
                                             const std::string& probe) const {
  const auto found = files_.find(file.string());
  if (found == files_.end() || found->second.identity != identity || identity.empty() ||
      found->second.probe != probe) {
    return std::nullopt;
  }
  return found->second.fault;
}

void TriedBefore::set(const fs::path& file, const std::string& identity, const std::string& probe,
                      const std::string& fault) {
  if (files_.size() >= kMostEntries) files_.clear();  // of files that are long gone, most likely
  files_[file.string()] = {identity, probe, fault};
}

TriedBefore TriedBefore::load() {
  const fs::path file = cache_file();
  std::error_code error;
  if (file.empty() || fs::file_size(file, error) > kLargestFile || error) return {};
  std::ifstream in(file, std::ios::binary);
  return from_text({std::istreambuf_iterator<char>(in), {}});
}

void TriedBefore::save() const {
  const fs::path file = cache_file();
  if (file.empty()) return;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  const fs::path aside = file.string() + fmt::format(".{}", platform::process_number());
  {
    std::ofstream out(aside, std::ios::binary);
    out << to_text();
    if (!out.flush()) error = std::make_error_code(std::errc::io_error);
  }
  if (!error) fs::rename(aside, file, error);
  if (error) fs::remove(aside, error);
}

std::string read_tried(const std::string& text) { return TriedBefore::from_text(text).to_text(); }

}  // namespace burin::plugin
