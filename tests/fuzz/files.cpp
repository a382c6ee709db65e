#include <burin/base/run_context.h>
#include <burin/converters/read.h>

#include "targets.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace burin::fuzz {
namespace {

/// A file in memory, one a process, with other bytes each time.
class File {
 public:
  File(std::string_view bytes, const std::string& suffix) {
    static Place place(suffix);
    path_ = place.path;
    const int file = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const auto length = static_cast<ssize_t>(bytes.size());
    if (file < 0 || ::write(file, bytes.data(), bytes.size()) != length || ::close(file) != 0) {
      std::perror(path_.c_str());
      std::exit(2);
    }
  }
  const std::string& path() const { return path_; }

 private:
  struct Place {
    explicit Place(const std::string& suffix) {
      const std::filesystem::path memory = "/dev/shm";
      const auto folder =
          std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path();
      path = folder / ("burin-fuzz-" + std::to_string(::getpid()) + suffix);
    }
    ~Place() { ::unlink(path.c_str()); }
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;
    std::string path;
  };
  std::string path_;
};

void put(std::string& out, std::uint32_t value, int bytes) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i) & 0xff);
}

/// A zip archive of one member that is stored as it is.
std::string zip_of(std::string_view bytes, const std::string& name) {
  const auto size = static_cast<std::uint32_t>(bytes.size());
  const auto sum = static_cast<std::uint32_t>(
      ::crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(size)));
  const auto entry = [&](std::string& out) {
    put(out, 20, 2);  // version needed
    put(out, 0, 4);   // flags, method: stored
    put(out, 0, 4);   // time, date
    put(out, sum, 4);
    put(out, size, 4);
    put(out, size, 4);
    put(out, static_cast<std::uint32_t>(name.size()), 2);
    put(out, 0, 2);  // extra field
  };
  std::string out = "PK\3\4";
  entry(out);
  out += name;
  out += bytes;
  const auto directory = static_cast<std::uint32_t>(out.size());
  out += "PK\1\2";
  put(out, 20, 2);  // version made by
  entry(out);
  out.append(2 + 2 + 2 + 4 + 4, '\0');  // comment, disk, attributes; where the member begins
  out += name;
  const auto length = static_cast<std::uint32_t>(out.size()) - directory;
  out += "PK\5\6";
  put(out, 0, 4);  // disks
  put(out, 1, 2);
  put(out, 1, 2);
  put(out, length, 4);
  put(out, directory, 4);
  put(out, 0, 2);  // comment
  return out;
}

}  // namespace

void file(std::string_view bytes, const std::string& suffix) {
  const File file(bytes, suffix);
  RunContext context;
  read_scene({file.path()}, {}, context);
}

void member(std::string_view bytes, const std::string& name, const std::string& suffix) {
  file(zip_of(bytes, name), suffix);
}

}  // namespace burin::fuzz
