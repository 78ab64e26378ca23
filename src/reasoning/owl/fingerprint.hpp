// The size and hash of a file's content: enough to know later that it has changed.
#ifndef GEMINGA_REASONING_OWL_FINGERPRINT_HPP
#define GEMINGA_REASONING_OWL_FINGERPRINT_HPP

#include <cstdint>
#include <string>
#include <string_view>

namespace geminga::owl {

/// Size and XXH3-64 of a file's octets; both are 0 if they are not known. The time of the file is not part of it: a
/// copy or a checkout changes it, and compiled forms of equal files would differ.
struct Fingerprint {
  std::uint64_t size = 0;
  std::uint64_t hash = 0;
  [[nodiscard]] bool is_known() const { return size != 0 || hash != 0; }
  friend bool operator==(const Fingerprint&, const Fingerprint&) = default;
};

[[nodiscard]] Fingerprint fingerprint_of(std::string_view octets);

/// Whether the file is there and has other content than it had. False for what is gone, is no regular file or cannot be
/// read. Reads the file, in pieces, only if its size is the same.
[[nodiscard]] bool has_changed(const std::string& path, const Fingerprint& known);

}  // namespace geminga::owl

#endif
