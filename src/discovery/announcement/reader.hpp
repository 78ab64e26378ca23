// Datagrams read into announcements, which several participants of one process may share.
#ifndef GEMINGA_DISCOVERY_ANNOUNCEMENT_READER_HPP
#define GEMINGA_DISCOVERY_ANNOUNCEMENT_READER_HPP

#include <cstddef>
#include <cstdint>
#include <expected>
#include <span>
#include <string>
#include <vector>

#include "discovery/announcement/announcement.hpp"
#include "discovery/announcement/codec.hpp"

namespace geminga::announcement {

/// Reads datagrams by decode(). A daemon has one of its own, which remembers nothing and uses its memory again. In a
/// simulation a thousand receivers get the same octets: their reader remembers the last announcements, so that each
/// datagram is decoded once. What is read never depends on what is remembered. Not thread-safe.
class Reader {
 public:
  /// `remembers`: how many announcements; 0: none.
  explicit Reader(std::size_t remembers = 0) : remembered_(remembers) {}
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// The announcement of a datagram. It is valid until the next call.
  [[nodiscard]] std::expected<const Announcement*, DecodeError> read(std::span<const std::byte> datagram);
  /// How many datagrams were decoded.
  [[nodiscard]] std::uint64_t decoded() const { return decoded_; }

 private:
  struct Remembered {
    std::string octets;  ///< empty: nothing is remembered
    Announcement announcement;
  };

  std::vector<Remembered> remembered_;  ///< by a hash of the octets
  Announcement last_;                   ///< where nothing is remembered
  std::uint64_t decoded_ = 0;
};

}  // namespace geminga::announcement

#endif
