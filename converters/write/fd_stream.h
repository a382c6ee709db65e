#pragma once
/// A stream into a file descriptor that remembers why it failed.

#include <burin/base/platform.h>

#include <cerrno>
#include <streambuf>
#include <vector>

namespace burin {

class FdBuffer : public std::streambuf {
 public:
  explicit FdBuffer(int fd) : fd_(fd), buffer_(1u << 16) { reset(); }

  /// errno of the first write that failed, 0 for none.
  int error() const { return error_; }

 protected:
  int_type overflow(int_type c) override {
    if (!flush()) return traits_type::eof();
    if (c == traits_type::eof()) return traits_type::not_eof(c);
    *pptr() = traits_type::to_char_type(c);
    pbump(1);
    return c;
  }
  std::streamsize xsputn(const char* text, std::streamsize n) override {
    if (n < epptr() - pptr()) {
      traits_type::copy(pptr(), text, static_cast<std::size_t>(n));
      pbump(static_cast<int>(n));
      return n;
    }
    return flush() && put(text, static_cast<std::size_t>(n)) ? n : 0;
  }
  int sync() override { return flush() ? 0 : -1; }

 private:
  void reset() { setp(buffer_.data(), buffer_.data() + buffer_.size()); }
  bool flush() {
    const bool good = put(pbase(), static_cast<std::size_t>(pptr() - pbase()));
    reset();
    return good;
  }
  bool put(const char* text, std::size_t n) {
    if (error_ == 0 && !platform::write_all(fd_, {text, n})) error_ = errno;
    return error_ == 0;
  }

  int fd_;
  int error_ = 0;
  std::vector<char> buffer_;
};

}  // namespace burin
