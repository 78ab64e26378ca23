// Events from the daemon to a peer, as lines and as values (src/discovery/gcnp/GCNP.md; paper section 3.3).
#ifndef GEMINGA_DISCOVERY_GCNP_EVENT_HPP
#define GEMINGA_DISCOVERY_GCNP_EVENT_HPP

#include <cstdint>
#include <expected>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "discovery/gcnp/statement.hpp"
#include "geminga/error.hpp"
#include "geminga/event.hpp"
#include "geminga/named.hpp"

namespace geminga::gcnp {

/// The cost of a conversion: a key only in a line with `convert`, otherwise an attribute.
inline constexpr std::string_view cost_key = "cost";
/// The converters of a conversion: a key as `cost` is.
inline constexpr std::string_view via_key = "via";

/// Writes `N pub add|modify service=S provider=PARTICIPANT/PEER name=... IDENTITY degree=D distance=K mode=M address=A
/// port=P protocol=... priority=K participant_name=... [convert=A>B cost=K [via=V]] [attributes] [hops=N path=A/B]
/// [reachable=no]`, or `N pub del service=S reason=...`. `request` is the subscription that is told. An empty name is
/// left out.
[[nodiscard]] Statement to_statement(std::uint32_t request, const ServiceEvent& event);

/// Writes `N sub add|modify subscription=S consumer=PARTICIPANT/PEER name=... IDENTITY degree=D distance=K mode=M
/// address=A port=P priority=K participant_name=... [attributes] [hops=N path=A/B] [reachable=no]`, or `N sub del
/// subscription=S reason=...`. `request` is the publication that is told. An address or port that is not stated is left
/// out.
[[nodiscard]] Statement to_statement(std::uint32_t request, const ConsumerEvent& event);

/// A line from the daemon: an event or error about a request, or a message (`N msg ...`).
using Reply = std::variant<Event, Statement>;

/// Reads a line from the daemon, without its end. Unknown keys of an event are attributes, so that a daemon may say
/// more than this client knows. The error says why the line is none of GCNP.
[[nodiscard]] std::expected<Reply, Error> read_reply(std::string_view line);

/// Appends `id=N`, `text=NAME`, or `concept=C [representation=R]`; for the lines of `query`, too.
void append_identity(std::vector<Parameter>& parameters, const NamedIdentity& identity);
/// Appends the attributes as the daemon shows them (shown_key()), sorted by name.
void append_attributes(std::vector<Parameter>& parameters, const Attributes& attributes);
/// Appends `convert=A>B cost=K` and `via=V` if something is converted, then the attributes.
void append_attributes(std::vector<Parameter>& parameters, const std::string& convert, std::uint32_t cost,
                       const std::string& via, const Attributes& attributes);

}  // namespace geminga::gcnp

#endif
