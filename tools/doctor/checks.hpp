// The causes of silence, each looked for in what the host, the daemon and the team say of themselves.
#ifndef GEMINGA_DOCTOR_CHECKS_HPP
#define GEMINGA_DOCTOR_CHECKS_HPP

#include <string>
#include <string_view>
#include <vector>

#include "doctor/answers.hpp"
#include "doctor/finding.hpp"
#include "doctor/firewall.hpp"
#include "doctor/host.hpp"
#include "doctor/overhearing.hpp"
#include "geminga/client.hpp"

namespace geminga::doctor {

/// The share of lost announcements that deadlines bear: above it they stretch, and living robots are told as gone now
/// and then (src/discovery/announcement/ANNOUNCEMENT.md). A loss is above it where its lower confidence bound is
/// (`loss_least` of `query participants`), so that chance is no finding.
inline constexpr double bearable_loss = 0.4;
/// The time after which a daemon that hears nobody is alone, in seconds and in its intervals, whichever is longer:
/// every neighbour has spoken twice by then.
inline constexpr double time_to_hear = 10;
inline constexpr double intervals_to_hear = 4;
/// The least MTU that IPv6 needs and announcements are made for (RFC 8200, section 5).
inline constexpr std::size_t least_mtu = 1280;
/// The intervals without any datagram on an interface, not even our own from the link, after which something keeps them
/// out. Ours comes back without loss.
inline constexpr double quiet_intervals = 4;
/// The difference between the wall clock and the time that has passed, in seconds, that is no matter of its pace.
inline constexpr double clock_step = 2;
/// The members of a team: so many on both sides of a difference are two teams, and not one host with an old file.
inline constexpr std::size_t least_team = 2;

/// Interfaces, daemons, rights and key files of this host. `uses_loopback`: its daemon was started for one host alone.
[[nodiscard]] Findings check_host(const Host& host, bool uses_loopback = false);
/// Why no daemon answers at `connect`.
[[nodiscard]] Findings check_absent_daemon(const Host& host, const ClientError& error, std::string_view connect);
/// The daemon's own troubles: configuration, ontology, memory, limits, clock. `version` is that of this program.
[[nodiscard]] Findings check_daemon(const Answers& answers, std::string_view version);

/// The outcome of the experiments with what goes out.
using TryToSend = Sending (*)(const Crossing&);
/// Looks for what keeps announcements from coming in or going out, by the firewall's own list and by experiment.
[[nodiscard]] Findings check_firewall(const Host& host, const Answers& answers, TryToSend try_to_send);
/// Interfaces on which the kernel has no route to a group of a family that they have addresses of.
[[nodiscard]] Findings check_multicast_routes(const Answers& answers, TryToSend try_to_send);

/// Loss, hosts that do not hear us, keys, digests, and strangers on the link.
/// `hears_all`: every port and group was listened to (overhears_all()).
[[nodiscard]] Findings check_team(const Answers& answers, bool hears_all);
/// Addresses at which services are announced, and to which no route leads.
[[nodiscard]] Findings check_addresses(const Host& host, const Answers& answers, bool (*has_route)(const std::string&));
/// Announcements that the daemon does not take: another port, another multicast group, the other family.
[[nodiscard]] Findings check_overheard(const Host& host, const Answers& answers,
                                       const std::vector<Overheard>& overheard);
/// Requests that nobody serves, grouped by their reason, and services without a place for another listener.
[[nodiscard]] Findings check_requests(const Answers& answers);

/// Takes out what follows from another finding: a host behind its own firewall is alone, too.
void drop_consequences(Findings& findings);
/// The worst first; equally bad ones stay in their order.
void sort_by_severity(Findings& findings);

/// `status: KEY=COUNT`, and that none was added between two looks where it is so: what happened long ago says less.
[[nodiscard]] std::string words_for_count(const Answers& answers, std::string_view key);
/// A number of an answer; 0 where it is none.
[[nodiscard]] double number(std::string_view text);
/// How the daemon speaks.
[[nodiscard]] Habits habits_of(const Answers& answers);
/// The parts of a list between commas.
[[nodiscard]] std::vector<std::string> parts_of(std::string_view list);
/// `robot2 (1f151dd5)`
[[nodiscard]] std::string words_for(const Record& participant, std::string_view id_key);

}  // namespace geminga::doctor

#endif
