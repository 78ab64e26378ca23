// Announcements on the link that the daemon does not take: on another port, in another group, of the other family.
#ifndef GEMINGA_DOCTOR_OVERHEARING_HPP
#define GEMINGA_DOCTOR_OVERHEARING_HPP

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace geminga::doctor {

/// Announcements that came in by multicast, of one sender to one group and port.
struct Overheard {
  std::string interface;
  std::string source;
  std::string group;
  std::uint16_t port = 0;
  std::string participant;  ///< its identifier as in `query participants`; empty where the announcement is sealed
  friend auto operator<=>(const Overheard&, const Overheard&) = default;
  [[nodiscard]] bool is_ipv6() const { return source.find(':') != std::string::npos; }
};

/// How the own daemon speaks.
struct Habits {
  std::uint16_t port = 0;
  std::vector<std::string> groups;
};

/// Where announcements are listened for without a right: so many ports and groups to both sides of ours and of the
/// usual ones (4717, 239.192.47.17, ff02::4717).
inline constexpr int neighbouring_ports = 8;
inline constexpr int neighbouring_groups = 4;

/// The most senders that are told apart.
inline constexpr std::size_t max_overheard = 64;

/// The announcement in an IP packet without the header of the link; `interface` is left empty. False: it is none, or
/// not for a group. Takes bytes from anywhere.
[[nodiscard]] bool read_packet(std::span<const unsigned char> packet, bool is_ipv6, Overheard& into);

/// Whether octets begin as an announcement does (ANNOUNCEMENT.md, "Worked example"; SEALING.md, "The datagram").
/// `participant` as in Overheard. Takes bytes from anywhere.
[[nodiscard]] bool read_announcement(std::span<const unsigned char> octets, std::string& participant);

/// Listens for so long. With the capability CAP_NET_RAW it hears whole packets, and so every port and group, and joins
/// the usual groups meanwhile, so that a switch sends them here. Without it, it hears neighbouring ports and groups
/// (see above), and a family of IP only where the interface has an address of it. Sorted, each sender once.
[[nodiscard]] std::vector<Overheard> overhear(const std::vector<std::string>& interfaces, const Habits& ours,
                                              std::chrono::milliseconds time);

/// Whether this process hears every port and group.
[[nodiscard]] bool overhears_all();

}  // namespace geminga::doctor

#endif
