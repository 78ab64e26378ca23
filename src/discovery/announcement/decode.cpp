// Strict reading: first the size, then protobuf, then every field.
#include <google/protobuf/stubs/logging.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "base/address.hpp"
#include "base/text.hpp"
#include "discovery/announcement/announceable.hpp"
#include "discovery/announcement/codec.hpp"
#include "discovery/announcement/fault.hpp"
#include "discovery/announcement/limits.hpp"
#include "discovery/announcement/wire_choice.hpp"
#include "discovery/announcement/wire_entry.hpp"
#include "discovery/announcement/wire_presence.hpp"
#include "discovery/announcement/wire_relay.hpp"

namespace geminga::announcement {
namespace {

using Failure = std::unexpected<DecodeError>;
template <typename Value>
using Decoded = std::expected<Value, DecodeError>;

bool parse(std::span<const std::byte> datagram, wire::Announcement& message) {
  // protobuf writes a line to standard error for each bad text; a sender must not be able to fill our log.
  static const google::protobuf::LogSilencer silence;
  return message.ParseFromArray(datagram.data(), static_cast<int>(datagram.size()));
}

/// The message that datagrams are parsed into, one after the other. It keeps the memory of a presence, but not that of
/// messages with many small pieces.
class Scratch {
 public:
  Scratch() = default;
  ~Scratch() {
    if (message_.peers_size() + message_.terms_size() + message_.namespaces_size() + message_.lines_size() > 0)
      message_ = {};
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  [[nodiscard]] wire::Announcement& message() { return message_; }

 private:
  static thread_local wire::Announcement message_;
};
thread_local wire::Announcement Scratch::message_;

/// Resets an announcement, but keeps its memory.
void reset(Announcement& announcement) {
  Announcement fresh;
  fresh.witness.heard = std::move(announcement.witness.heard);
  fresh.lacks = std::move(announcement.lacks);
  fresh.doubts = std::move(announcement.doubts);
  fresh.behind = std::move(announcement.behind);
  fresh.witness.heard.clear();
  fresh.lacks.clear();
  fresh.doubts.clear();
  fresh.behind.clear();
  announcement = std::move(fresh);
}

/// A name that may be left out.
bool is_name_or_empty(std::string_view name) { return name.empty() || is_valid_name(name); }

Decoded<Kind> kind_of(wire::Kind kind) {
  switch (kind) {
    case wire::KIND_STATE:
      return Kind::state;
    case wire::KIND_CLAIM:
      return Kind::claim;
    case wire::KIND_GOODBYE:
      return Kind::goodbye;
    case wire::KIND_PRESENCE:
      return Kind::presence;
    case wire::KIND_CHANGE:
      return Kind::change;
    case wire::KIND_INQUIRY:
      return Kind::inquiry;
    case wire::KIND_DIAGNOSIS:
      return Kind::diagnosis;
    case wire::KIND_RELAYED:
      return Kind::relayed;
    default:
      return Failure(DecodeError::bad_kind);
  }
}

Decoded<ChannelMode> mode_of(wire::Mode mode) {
  switch (mode) {
    case wire::MODE_ONE_TO_ONE:
      return ChannelMode::one_to_one;
    case wire::MODE_ONE_TO_MANY_STREAM:
      return ChannelMode::one_to_many_stream;
    case wire::MODE_ONE_TO_MANY_PUBSUB:
      return ChannelMode::one_to_many_pubsub;
    default:
      return Failure(DecodeError::bad_mode);
  }
}

Decoded<Degree> degree_of(wire::Degree degree) {
  switch (degree) {
    case wire::DEGREE_NARROWER:
      return Degree::narrower;
    case wire::DEGREE_EXACT:
      return Degree::exact;
    case wire::DEGREE_EQUIVALENT:
      return Degree::equivalent;
    case wire::DEGREE_BROADER:
      return Degree::broader;
    default:
      return Failure(DecodeError::bad_degree);
  }
}

/// The IRIs of the term table, in its order.
Decoded<std::vector<std::string>> terms_of(const wire::Announcement& message) {
  std::vector<std::string> terms;
  terms.reserve(static_cast<std::size_t>(message.terms_size()));
  for (const auto& term : message.terms()) {
    const auto number = term.namespace_number();
    if (number > static_cast<std::uint32_t>(message.namespaces_size())) return Failure(DecodeError::bad_table);
    std::string iri = number == 0 ? std::string() : message.namespaces(static_cast<int>(number - 1));
    iri += term.local();
    // Checked here and not at its use, so that a term costs the same however often it is used.
    if (!is_valid_iri(iri)) return Failure(DecodeError::bad_identity);
    terms.push_back(std::move(iri));
  }
  return terms;
}

template <typename Message>
Decoded<Identity> identity_of(const Message& message, const std::vector<std::string>& terms) {
  auto representation = message.representation_term();
  if constexpr (requires { message.representation_of_expression(); }) {
    if (message.is_expression()) representation = message.representation_of_expression();
  }
  if (representation > terms.size()) return Failure(DecodeError::bad_table);
  const std::string representation_iri = representation == 0 ? std::string() : terms[representation - 1];
  if (message.is_expression()) {
    SemanticIdentity identity{message.text(), representation_iri};
    if (!has_expression(identity)) return Failure(DecodeError::bad_identity);  // a name would be a term
    return identity;
  }
  if (message.identity_case() != Message::kConceptTerm && representation != 0) {
    return Failure(DecodeError::bad_identity);
  }
  switch (message.identity_case()) {
    case Message::kNumeric:
      return NumericIdentity{message.numeric()};
    case Message::kText:
      return TextIdentity{message.text()};
    case Message::kConceptTerm: {
      const auto number = message.concept_term();
      if (number == 0 || number > terms.size()) return Failure(DecodeError::bad_table);
      return SemanticIdentity{terms[number - 1], representation_iri};
    }
    default:
      return Failure(DecodeError::bad_identity);
  }
}

/// Reads the attributes of a service. False where a key comes twice.
template <typename Message>
bool read_attributes(const Message& message, Attributes& attributes) {
  const auto is_new = [&](const auto& one) { return attributes.emplace(one.key(), one.value()).second; };
  return std::ranges::all_of(message.attributes(), is_new);
}

/// The fields that publications and subscriptions share.
template <typename Message, typename Service>
Decoded<void> read_common(const Message& message, const std::vector<std::string>& terms, Service& service) {
  const auto mode = mode_of(message.mode());
  if (!mode) return Failure(mode.error());
  service.mode = *mode;
  auto identity = identity_of(message, terms);
  if (!identity) return Failure(identity.error());
  service.identity = std::move(*identity);
  if (message.port() > std::numeric_limits<std::uint16_t>::max()) return Failure(DecodeError::bad_port);
  service.port = static_cast<std::uint16_t>(message.port());
  if (!message.address().empty()) {
    auto address = address_of(message.address());
    if (!address) return Failure(DecodeError::bad_address);
    service.address = std::move(*address);
  }
  service.priority = message.priority();
  if (!read_attributes(message, service.attributes)) return Failure(DecodeError::bad_attribute);
  return {};
}

Decoded<NumberedPublication> publication_of(const wire::Publication& message, const std::vector<std::string>& terms) {
  NumberedPublication numbered;
  numbered.number = message.number();
  if (const auto read = read_common(message, terms, numbered.publication); !read) return Failure(read.error());
  if (!message.protocol().empty()) numbered.publication.protocol = message.protocol();
  numbered.publication.scope = message.scope();
  numbered.publication.for_whom = message.for_whom();
  if (const auto fault = find_fault(numbered.publication)) return Failure(fault->word);
  return numbered;
}

Decoded<NumberedSubscription> subscription_of(const wire::Subscription& message,
                                              const std::vector<std::string>& terms) {
  NumberedSubscription numbered;
  numbered.number = message.number();
  auto& subscription = numbered.subscription;
  if (const auto read = read_common(message, terms, subscription); !read) return Failure(read.error());
  const auto weakest = degree_of(message.weakest());
  if (!weakest) return Failure(weakest.error());
  if (message.overlapping() && *weakest != Degree::broader) return Failure(DecodeError::bad_degree);
  subscription.weakest = message.overlapping() ? Degree::overlapping : *weakest;
  for (const auto& provider : message.providers()) {
    subscription.providers.push_back({provider.participant(), provider.peer()});
  }
  subscription.where = message.where();
  subscription.limit = message.limit();
  subscription.protocols.assign(message.protocols().begin(), message.protocols().end());
  for (const auto& provider : message.favoured()) {
    subscription.favoured.push_back({provider.participant(), provider.peer()});
  }
  subscription.prefer = message.prefer();
  subscription.rank = message.rank();
  subscription.scope = message.scope();
  auto chosen = read_choice(message);
  if (!chosen) return Failure(DecodeError::bad_identifier);
  subscription.chosen = std::move(*chosen);
  subscription.convert = message.convert();
  subscription.on = message.on();
  if (const auto fault = find_fault(subscription)) return Failure(fault->word);
  return numbered;
}

/// Whether no number is 0 and none occurs twice.
bool are_identifiers(std::vector<std::uint32_t> numbers) {
  std::ranges::sort(numbers);
  return (numbers.empty() || numbers.front() != 0) && std::ranges::adjacent_find(numbers) == numbers.end();
}

Decoded<PeerState> peer_of(const wire::Peer& message, Kind kind, const std::vector<std::string>& terms) {
  PeerState peer;
  peer.id = PeerId{message.id()};
  peer.name = message.name();
  if (!is_name_or_empty(peer.name)) return Failure(DecodeError::bad_name);
  std::vector<std::uint32_t> numbers;
  for (const auto& entry : message.publications()) {
    auto publication = publication_of(entry, terms);
    if (!publication) return Failure(publication.error());
    numbers.push_back(publication->number);
    peer.publications.push_back(std::move(*publication));
  }
  for (const auto& entry : message.subscriptions()) {
    auto subscription = subscription_of(entry, terms);
    if (!subscription) return Failure(subscription.error());
    numbers.push_back(subscription->number);
    peer.subscriptions.push_back(std::move(*subscription));
  }
  peer.withheld.assign(message.withheld().begin(), message.withheld().end());
  numbers.insert(numbers.end(), peer.withheld.begin(), peer.withheld.end());
  if (kind == Kind::change) peer.removed.assign(message.removed().begin(), message.removed().end());
  numbers.insert(numbers.end(), peer.removed.begin(), peer.removed.end());
  if (!are_identifiers(std::move(numbers))) return Failure(DecodeError::bad_identifier);
  return peer;
}

/// The participant's own entry. An empty message is one that a change removes.
Decoded<PeerState> self_of(const wire::Publication& message, Kind kind, const std::vector<std::string>& terms) {
  const std::uint32_t number = description_key({}).number;
  PeerState self;
  if (message.ByteSizeLong() == 0) {
    self.removed.assign(kind == Kind::change ? 1 : 0, number);
    return self;
  }
  auto& description = self.publications.emplace_back(number, Publication{}).publication;
  description.mode = ChannelMode::participant;
  auto identity = identity_of(message, terms);
  if (!identity) return Failure(identity.error());
  description.identity = std::move(*identity);
  if (!read_attributes(message, description.attributes)) return Failure(DecodeError::bad_attribute);
  if (const auto fault = find_fault(description)) return Failure(fault->word);
  return self;
}

/// Whether a kind leaves to the state its name, its interval and all that stands for long.
bool is_short(Kind kind) { return kind >= Kind::presence; }

/// The fields of an inquiry and a diagnosis only.
Decoded<void> read_exchange(const wire::Announcement& message, Announcement& announcement) {
  if (message.partner() == 0) return Failure(DecodeError::bad_diagnosis);
  announcement.partner = ParticipantId{message.partner()};
  announcement.token = message.token();
  if (announcement.kind == Kind::inquiry) return {};
  if (message.lines_size() > static_cast<int>(max_diagnosis_lines)) return Failure(DecodeError::bad_diagnosis);
  for (const std::string& line : message.lines()) {
    if (line.empty() || line.size() > max_diagnosis_line_bytes || base::has_control_character(line))
      return Failure(DecodeError::bad_diagnosis);
    announcement.lines.push_back(line);
  }
  return {};
}

Decoded<void> read_header(const wire::Announcement& message, Announcement& announcement) {
  if ((message.format() & 0xffffff) != format_magic) return Failure(DecodeError::not_geminga);
  if (message.format() >> 24 != format_major) return Failure(DecodeError::other_version);
  const auto kind = kind_of(message.kind());
  if (!kind) return Failure(kind.error());
  announcement.kind = *kind;
  if (message.participant() == 0) return Failure(DecodeError::bad_identifier);
  announcement.participant = ParticipantId{message.participant()};
  announcement.boot = BootNonce{message.boot()};
  if (!is_name_or_empty(message.group()) || !is_name_or_empty(message.name())) return Failure(DecodeError::bad_name);
  announcement.group = message.group();
  announcement.name = message.name();
  announcement.link = message.link();
  announcement.sequence = message.sequence();
  if (!is_short(*kind)) {
    announcement.interval = std::chrono::milliseconds(message.interval_ms());
    if (announcement.interval < min_interval || announcement.interval > max_interval) {
      return Failure(DecodeError::bad_interval);
    }
  } else if (announcement.group.empty()) {
    announcement.group = default_group;
  }
  if (message.doublings() > max_doublings) return Failure(DecodeError::bad_interval);
  announcement.doublings = static_cast<std::uint8_t>(message.doublings());
  announcement.ontology_digest = message.ontology_digest();
  announcement.lasting = message.lasting();
  announcement.revision = message.revision();
  announcement.since = message.since();
  if (*kind == Kind::change && announcement.since >= announcement.revision) return Failure(DecodeError::bad_change);
  announcement.part = message.part();
  announcement.part_count = std::max(message.part_count(), 1U);
  if (announcement.part_count > max_parts || announcement.part >= announcement.part_count) {
    return Failure(DecodeError::bad_part);
  }
  if (message.addresses_size() > static_cast<int>(max_addresses)) return Failure(DecodeError::bad_address);
  for (const auto& octets : message.addresses()) {
    auto address = address_of(octets);
    if (!address || base::address_scope(*address) == base::AddressScope::multicast)
      return Failure(DecodeError::bad_address);
    announcement.addresses.push_back(std::move(*address));
  }
  return {};
}

}  // namespace

std::optional<DecodeError> decode(std::span<const std::byte> datagram, Announcement& announcement) {
  if (datagram.size() > max_datagram_bytes) return DecodeError::too_large;
  Scratch scratch;
  wire::Announcement& message = scratch.message();
  if (!parse(datagram, message)) return DecodeError::not_protobuf;
  reset(announcement);
  if (const auto read = read_header(message, announcement); !read) return read.error();
  if (announcement.kind == Kind::presence) {
    if (!read_presence(message, announcement)) return DecodeError::bad_witness;
    return read_behind(message, announcement.behind) ? std::nullopt : std::optional(DecodeError::bad_relayed);
  }
  if (announcement.kind == Kind::inquiry || announcement.kind == Kind::diagnosis) {
    const auto read = read_exchange(message, announcement);
    return read ? std::nullopt : std::optional(read.error());
  }
  if (announcement.kind == Kind::relayed) {
    auto relayed = read_relayed(message);
    if (!relayed) return DecodeError::bad_relayed;
    announcement.relayed = std::move(*relayed);
    return std::nullopt;
  }
  const auto terms = terms_of(message);
  if (!terms) return terms.error();
  std::vector<std::uint32_t> ids;
  if (message.has_description() && (announcement.kind == Kind::state || announcement.kind == Kind::change)) {
    auto self = self_of(message.description(), announcement.kind, *terms);
    if (!self) return self.error();
    announcement.peers.push_back(std::move(*self));
  }
  for (const auto& entry : message.peers()) {
    auto peer = peer_of(entry, announcement.kind, *terms);
    if (!peer) return peer.error();
    ids.push_back(entry.id());
    announcement.peers.push_back(std::move(*peer));
  }
  if (!are_identifiers(std::move(ids))) return DecodeError::bad_identifier;
  return std::nullopt;
}

std::expected<Announcement, DecodeError> decode(std::span<const std::byte> datagram) {
  std::expected<Announcement, DecodeError> announcement;
  if (const auto error = decode(datagram, *announcement)) return Failure(*error);
  return announcement;
}

}  // namespace geminga::announcement
