// Publications and subscriptions: the services that peers offer and ask for (paper sections 3 and 3.2.3).
#ifndef GEMINGA_SERVICE_HPP
#define GEMINGA_SERVICE_HPP

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geminga/identity.hpp"
#include "geminga/match.hpp"

namespace geminga {

/// The way in which a channel between provider and consumers is set up (paper section 3).
enum class ChannelMode : std::uint8_t {
  one_to_one,          ///< `oto`
  one_to_many_stream,  ///< `otm/stream`: consumers only listen, the provider is not told
  one_to_many_pubsub,  ///< `otm/pubsub`: the provider opens the channel when the first consumer comes
  participant,         ///< no channel: not a service, but the description of a participant, and who asks for such
};

/// Whether a provider is told of the consumers of a service of this mode.
[[nodiscard]] constexpr bool is_provider_told(ChannelMode mode) {
  return mode == ChannelMode::one_to_one || mode == ChannelMode::one_to_many_pubsub;
}

/// The word of GCNP for a mode, e.g. "otm/stream". Static storage.
[[nodiscard]] std::string_view to_string(ChannelMode mode);
/// The mode of a GCNP word, or nothing.
[[nodiscard]] std::optional<ChannelMode> channel_mode(std::string_view word);

/// The services that a consumer is told of, by whether their address can be reached from its host.
enum class RequiredReach : std::uint8_t {
  routed,  ///< those of which it is not certain that they cannot be reached
  any,     ///< all, as one that reaches them by a way that the host does not know
};

/// The word of GCNP for it: "routed" or "any". Static storage.
[[nodiscard]] std::string_view to_string(RequiredReach reach);
/// The meaning of a GCNP word, or nothing.
[[nodiscard]] std::optional<RequiredReach> required_reach(std::string_view word);

/// Names one daemon on the air. Drawn at random and claimed before use (paper section 3.5.1); the value 0 is no
/// participant. Written as eight lower-case hexadecimal digits.
enum class ParticipantId : std::uint32_t {};

/// Names one local client of a participant; 0 is no peer.
enum class PeerId : std::uint32_t {};

/// Names one publication or subscription in the whole team: the participant, its peer, and the peer's GCNP statement
/// id. Written `PARTICIPANT/PEER/NUMBER`, the participant in hexadecimal, the others in decimal.
struct ServiceKey {
  ParticipantId participant{};
  PeerId peer{};
  std::uint32_t number = 0;
  friend auto operator<=>(const ServiceKey&, const ServiceKey&) = default;
};

/// The key of the description of a participant, which no peer has stated.
[[nodiscard]] constexpr ServiceKey description_key(ParticipantId participant) { return {participant, PeerId{}, 1}; }

/// "1a2b3c4d"
[[nodiscard]] std::string to_string(ParticipantId id);
/// "1a2b3c4d/1/42"
[[nodiscard]] std::string to_string(const ServiceKey& key);
/// The participant and the peer of a service: "1a2b3c4d/1".
[[nodiscard]] std::string peer_word(const ServiceKey& key);
/// The participant of eight hexadecimal digits, or nothing.
[[nodiscard]] std::optional<ParticipantId> participant_id(std::string_view text);
/// The key of a text as to_string() writes it, or nothing.
[[nodiscard]] std::optional<ServiceKey> service_key(std::string_view text);

/// Free attributes of a service: sorted by key, so that order never depends on chance.
using Attributes = std::map<std::string, std::string, std::less<>>;

/// An offered service. Two are equal if a consumer cannot tell them apart.
struct Publication {
  ChannelMode mode = ChannelMode::one_to_one;
  Identity identity;
  std::string address;  ///< a numeric IP address; empty: the provider's own, as valid for each consumer
  std::uint16_t port = 0;
  std::string protocol = "udp";
  std::int32_t priority = 0;  ///< greater wins an arbitration
  Attributes attributes;
  std::string scope{};     ///< which hosts it is for (SCOPE.md); empty: all
  std::string for_whom{};  ///< a condition on the consumer (WHERE.md); empty: none
  friend bool operator==(const Publication&, const Publication&) = default;
};

/// One provider that a consumer accepts or favours: a participant by id or by name, and perhaps one of its peers, by id
/// or by name.
struct ProviderFilter {
  std::string participant;
  std::string peer;  ///< empty: any peer
  friend bool operator==(const ProviderFilter&, const ProviderFilter&) = default;
};

/// A requested service.
struct Subscription {
  ChannelMode mode = ChannelMode::one_to_one;
  Identity identity;
  Degree weakest = Degree::narrower;      ///< the weakest degree of match that counts
  std::vector<ProviderFilter> providers;  ///< empty: any provider
  std::string where;                      ///< a filter over attributes (WHERE.md); empty: none
  std::uint32_t limit = 0;                ///< at most this many providers, the best; 0: all
  std::int32_t priority = 0;
  std::uint16_t port = 0;  ///< where the consumer can be reached; 0: unstated
  std::string address;     ///< as in Publication
  Attributes attributes;
  std::vector<std::string> protocols{};    ///< only publications with one of these; empty: any
  std::vector<ProviderFilter> favoured{};  ///< first these providers, in this order, then all others
  std::string prefer{};                    ///< the attributes by which a provider is preferred (PREFERENCES.md);
                                           ///< empty: none
  std::string rank{};                      ///< the order of the criteria of ranking; empty: the usual order
  std::string scope{};                     ///< from which hosts (SCOPE.md); empty: all
  /// The providers that the consumer's host has chosen, ascending. It is announced, not stated, where there was a
  /// choice.
  std::vector<ServiceKey> chosen{};
  std::uint32_t convert = 0;  ///< the largest cost of converting (CONVERSIONS.md); 0: not at all
  /// The class expression that must describe the provider's participant, or a class as `<IRI>`; empty: any participant.
  std::string on{};
  RequiredReach reach = RequiredReach::routed;  ///< stated, and not announced: the consumer's host judges
  friend bool operator==(const Subscription&, const Subscription&) = default;
};

}  // namespace geminga

#endif
