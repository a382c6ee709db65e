#pragma once
// What burin-probe found in files, kept for the next program: a file in the user's cache folder.

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace burin::plugin {

/// What distinguishes a file from the one that was there before: device, number, size, times. Empty
/// where there is no file.
std::string identity_of(const std::filesystem::path& file);

/// Faults (empty: none) by file and identity.
class TriedBefore {
 public:
  /// Of a text that `to_text` made; of any other nothing.
  static TriedBefore from_text(const std::string& text);
  std::string to_text() const;

  /// `probe`: the identity of burin-probe; what another one said does not hold.
  std::optional<std::string> find(const std::filesystem::path& file, const std::string& identity,
                                  const std::string& probe) const;
  void set(const std::filesystem::path& file, const std::string& identity, const std::string& probe,
           const std::string& fault);

  /// That of the user; empty where there is none. `save` goes without where it cannot write.
  static TriedBefore load();
  void save() const;

 private:
  struct Entry {
    std::string identity, probe, fault;
  };
  std::map<std::string, Entry> files_;
};

}  // namespace burin::plugin
