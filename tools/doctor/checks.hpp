// The causes of silence, each looked for in what the host, the daemon and the team say of themselves.
#ifndef GEMINGA_DOCTOR_CHECKS_HPP
#define GEMINGA_DOCTOR_CHECKS_HPP

#include <string>
#include <string_view>

#include "doctor/answers.hpp"
#include "doctor/finding.hpp"
#include "doctor/host.hpp"
#include "geminga/client.hpp"

namespace geminga::doctor {

/// The share of lost announcements from which deadlines no longer bear it: living robots are then told as gone now and
/// then (src/discovery/announcement/ANNOUNCEMENT.md).
inline constexpr double bearable_loss = 0.6;
/// The time after which a daemon that hears nobody is alone, in seconds: every neighbour has spoken twice by then.
inline constexpr double time_to_hear = 10;
/// The least MTU that IPv6 needs and announcements are made for (RFC 8200, section 5).
inline constexpr std::size_t least_mtu = 1280;

/// Interfaces, daemons and rights of this host.
[[nodiscard]] Findings check_host(const Host& host);
/// Why no daemon answers at `connect`.
[[nodiscard]] Findings check_absent_daemon(const Host& host, const ClientError& error, std::string_view connect);
/// The daemon's own troubles: configuration, ontology, memory, limits. `version` is that of this program.
[[nodiscard]] Findings check_daemon(const Answers& answers, std::string_view version);
/// Loss, hosts that do not hear us, keys, digests, and strangers on the link.
[[nodiscard]] Findings check_team(const Answers& answers);
/// Requests that nobody serves, grouped by their reason.
[[nodiscard]] Findings check_requests(const Answers& answers);

/// The worst first; equally bad ones stay in their order.
void sort_by_severity(Findings& findings);

}  // namespace geminga::doctor

#endif
