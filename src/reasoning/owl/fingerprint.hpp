// What a file held when it was read: enough to know later that it has changed.
#ifndef GEMINGA_REASONING_OWL_FINGERPRINT_HPP
#define GEMINGA_REASONING_OWL_FINGERPRINT_HPP

#include <cstdint>
#include <string>
#include <string_view>

namespace geminga::owl {

/// Size and XXH3-64 of a file's octets; not its time, which a copy or a checkout changes, and which would make the
/// compiled forms of equal files differ. Both 0: not known.
struct Fingerprint {
  std::uint64_t size = 0;
  std::uint64_t hash = 0;
  [[nodiscard]] bool is_known() const { return size != 0 || hash != 0; }
  friend bool operator==(const Fingerprint&, const Fingerprint&) = default;
};

[[nodiscard]] Fingerprint fingerprint_of(std::string_view octets);

/// Whether the file is there and holds something else than it did. What is gone, is no regular file or cannot be read
/// is not known to have changed. Reads the file, in pieces, only where its size is the same.
[[nodiscard]] bool has_changed(const std::string& path, const Fingerprint& known);

}  // namespace geminga::owl

#endif
