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

/// The most senders that are told apart.
inline constexpr std::size_t max_overheard = 64;

/// The announcement in an IP packet without the header of the link; `interface` is left empty. False: it is none, or
/// not for a group. Takes bytes from anywhere.
[[nodiscard]] bool read_packet(std::span<const unsigned char> packet, bool is_ipv6, Overheard& into);

/// Listens to whole packets for so long, which needs the capability CAP_NET_RAW; without it, gives nothing at once.
/// Joins the usual groups meanwhile, so that a switch sends them here. Sorted, each sender once.
[[nodiscard]] std::vector<Overheard> overhear(const std::vector<std::string>& interfaces,
                                              std::chrono::milliseconds time);

}  // namespace geminga::doctor

#endif
