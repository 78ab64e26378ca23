#include "discovery/announcement/reader.hpp"

#include <string_view>

#include "base/hash.hpp"

namespace geminga::announcement {

std::expected<const Announcement*, DecodeError> Reader::read(std::span<const std::byte> datagram) {
  if (remembered_.empty()) {
    ++decoded_;
    if (const auto error = decode(datagram, last_)) return std::unexpected(*error);
    return &last_;
  }
  const std::string_view octets(reinterpret_cast<const char*>(datagram.data()), datagram.size());
  Remembered& one = remembered_[base::hash64(octets) % remembered_.size()];
  if (!octets.empty() && one.octets == octets) return &one.announcement;
  one.octets.clear();
  ++decoded_;
  if (const auto error = decode(datagram, one.announcement)) return std::unexpected(*error);
  one.octets = octets;
  return &one.announcement;
}

}  // namespace geminga::announcement
