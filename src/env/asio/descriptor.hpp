// A file descriptor with one owner, and reading and writing as a whole.
#pragma once

#include <unistd.h>

#include <string>
#include <string_view>
#include <utility>

namespace geminga::env {

/// Owns a descriptor, and closes it at its end; a negative number is none.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return number_; }
  [[nodiscard]] int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

/// Reads until the end or until the text is full, and cuts the text to what was read. The text never grows, so no copy
/// of a secret is left behind. False with errno.
[[nodiscard]] bool read_all(int descriptor, std::string& text);
/// Writes the whole text, and has the system store it (fsync). False with errno.
[[nodiscard]] bool write_all(int descriptor, std::string_view text);

}  // namespace geminga::env
