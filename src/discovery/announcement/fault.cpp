#include "discovery/announcement/fault.hpp"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "base/address.hpp"
#include "base/text.hpp"
#include "discovery/announcement/announceable.hpp"
#include "discovery/announcement/limits.hpp"

namespace geminga::announcement {
namespace {

using Found = std::optional<Fault>;

Found fault(DecodeError word, ErrorCode code, std::string text) { return Fault{word, {code, std::move(text)}}; }

Found oversized(DecodeError word, std::string_view field, std::size_t size, std::size_t limit) {
  return fault(word, ErrorCode::too_large,
               std::string(field) + " is too large: " + std::to_string(size) + " octets, at most " +
                   std::to_string(limit) + " can be announced");
}

/// Free text may have a tab and line ends, since GCNP can write them, and no other character that could steer a
/// terminal.
bool is_free_text(std::string_view text) {
  return base::is_valid_utf8(text) && std::ranges::none_of(text, [](char c) {
           const auto octet = static_cast<unsigned char>(c);
           return (octet < 0x20 && c != '\t' && c != '\n' && c != '\r') || octet == 0x7f;
         });
}

bool is_word(std::string_view text) {
  return !text.empty() &&
         std::ranges::all_of(text, [](char c) { return c > 0x20 && c < 0x7f && c != '"' && c != ','; });
}

Found iri_fault(std::string_view field, std::string_view iri) {
  constexpr auto word = DecodeError::bad_identity;
  if (iri.size() > max_iri_bytes) return oversized(word, field, iri.size(), max_iri_bytes);
  if (is_valid_iri(iri)) return std::nullopt;
  return fault(word, ErrorCode::malformed, std::string(field) + " is no IRI: " + base::printable(iri));
}

Found concept_fault(const std::string& text, std::size_t most) {
  constexpr auto word = DecodeError::bad_identity;
  if (!has_expression(SemanticIdentity{text, {}})) return iri_fault("concept", text);
  if (text.size() > most) return oversized(word, "the expression", text.size(), most);
  if (base::is_valid_utf8(text) && !base::has_control_character(text)) return std::nullopt;
  return fault(word, ErrorCode::malformed, "an expression must be UTF-8 without control characters");
}

/// `most`: octets of an expression.
Found identity_fault(const Identity& identity, std::size_t most = max_expression_bytes) {
  constexpr auto word = DecodeError::bad_identity;
  if (const auto* text = std::get_if<TextIdentity>(&identity)) {
    if (text->text.size() > max_text_identity_bytes) {
      return oversized(word, "text", text->text.size(), max_text_identity_bytes);
    }
    if (!text->text.empty() && base::is_valid_utf8(text->text) && !base::has_control_character(text->text)) {
      return std::nullopt;
    }
    return fault(word, ErrorCode::malformed, "text must be UTF-8 without control characters, and not empty");
  }
  if (const auto* semantic = std::get_if<SemanticIdentity>(&identity)) {
    if (auto found = concept_fault(semantic->concept_iri, most)) return found;
    if (!semantic->representation_iri.empty()) return iri_fault("representation", semantic->representation_iri);
  }
  return std::nullopt;
}

Found address_fault(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto address = base::parse_address(text);
  if (address && address->scope() != base::AddressScope::unspecified) return std::nullopt;
  return fault(DecodeError::bad_address, ErrorCode::impossible,
               "address " + base::printable(text) +
                   (address ? " is none that can be reached: leave address out for the interfaces' own"
                            : " is no numeric IP address"));
}

Found attributes_fault(const Attributes& attributes) {
  constexpr auto word = DecodeError::bad_attribute;
  if (attributes.size() > max_attributes) {
    return fault(word, ErrorCode::too_large,
                 std::to_string(attributes.size()) + " attributes are too many: at most " +
                     std::to_string(max_attributes) + " can be announced");
  }
  for (const auto& [key, value] : attributes) {
    if (key.size() > max_attribute_key_bytes) {
      return oversized(word, "the key of an attribute", key.size(), max_attribute_key_bytes);
    }
    if (value.size() > max_attribute_value_bytes) {
      return oversized(word, base::printable(key), value.size(), max_attribute_value_bytes);
    }
    if (!base::is_key(key)) {
      return fault(word, ErrorCode::malformed,
                   "attribute " + base::printable(key) + ": a key is made of A-Z a-z 0-9 _ . -");
    }
    if (!is_free_text(value)) {
      return fault(word, ErrorCode::malformed,
                   "attribute " + key + " must be UTF-8 without control characters other than tab and line end");
    }
  }
  return std::nullopt;
}

Found protocol_fault(const std::string& protocol) {
  constexpr auto word = DecodeError::bad_protocol;
  if (protocol.size() > max_protocol_bytes) return oversized(word, "protocol", protocol.size(), max_protocol_bytes);
  if (is_word(protocol)) return std::nullopt;
  return fault(word, ErrorCode::malformed, "protocol " + base::printable(protocol) + " is no word such as udp or tcp");
}

Found protocols_fault(const std::vector<std::string>& protocols) {
  if (protocols.size() > max_accepted_protocols) {
    return fault(DecodeError::bad_protocol, ErrorCode::too_large,
                 std::to_string(protocols.size()) + " protocols are too many: at most " +
                     std::to_string(max_accepted_protocols) + " can be announced");
  }
  for (const auto& protocol : protocols) {
    if (auto found = protocol_fault(protocol)) return found;
  }
  return std::nullopt;
}

Found providers_fault(const std::vector<ProviderFilter>& providers) {
  constexpr auto word = DecodeError::bad_filter;
  if (providers.size() > max_provider_filters) {
    return fault(word, ErrorCode::too_large,
                 std::to_string(providers.size()) + " providers are too many: at most " +
                     std::to_string(max_provider_filters) + " can be announced");
  }
  for (const auto& filter : providers) {
    if (!is_valid_name(filter.participant) || (!filter.peer.empty() && !is_valid_name(filter.peer))) {
      return fault(word, ErrorCode::malformed,
                   "provider " + base::printable(filter.participant + (filter.peer.empty() ? "" : "/" + filter.peer)) +
                       " is no PARTICIPANT or PARTICIPANT/PEER");
    }
  }
  return std::nullopt;
}

Found filter_fault(std::string_view what, const std::string& text, std::size_t most) {
  if (text.size() > most) return oversized(DecodeError::bad_filter, what, text.size(), most);
  if (is_free_text(text)) return std::nullopt;
  return fault(DecodeError::bad_filter, ErrorCode::malformed,
               std::string(what) + " must be UTF-8 without control characters");
}

/// Whether the keys exist, ascend, and occur once each.
Found chosen_fault(const std::vector<ServiceKey>& chosen) {
  const bool are_keys = std::ranges::all_of(chosen, [](const ServiceKey& key) {
    return key.participant != ParticipantId{} && key.peer != PeerId{} && key.number != 0;
  });
  if (are_keys && chosen.size() <= max_announced_choice &&
      std::ranges::adjacent_find(chosen, std::greater_equal()) == chosen.end()) {
    return std::nullopt;
  }
  return fault(DecodeError::bad_identifier, ErrorCode::malformed, "what is chosen is no list of services");
}

Found filters_fault(const Subscription& subscription) {
  if (auto found = providers_fault(subscription.providers)) return found;
  if (auto found = filter_fault("where", subscription.where, max_where_bytes)) return found;
  if (auto found = providers_fault(subscription.favoured)) return found;
  if (auto found = filter_fault("prefer", subscription.prefer, max_prefer_bytes)) return found;
  if (auto found = filter_fault("rank", subscription.rank, max_rank_bytes)) return found;
  if (auto found = filter_fault("on", subscription.on, max_expression_bytes)) return found;
  return filter_fault("scope", subscription.scope, max_scope_bytes);
}

}  // namespace

bool is_valid_name(std::string_view name) {
  return !name.empty() && name.size() <= max_name_bytes && base::is_valid_utf8(name) &&
         !base::has_control_character(name) && name.find_first_of("/,") == std::string_view::npos;
}

bool is_valid_iri(std::string_view iri) {
  return !iri.empty() && iri.size() <= max_iri_bytes && base::is_valid_utf8(iri) && !base::has_control_character(iri) &&
         iri.find_first_of(" <>\"{}|\\^`") == std::string_view::npos;
}

std::optional<Fault> find_fault(const Publication& publication) {
  const bool is_description = publication.mode == ChannelMode::participant;
  const std::size_t most = is_description ? max_described_bytes : max_expression_bytes;
  if (auto found = identity_fault(publication.identity, most)) return found;
  if (is_description && !std::holds_alternative<SemanticIdentity>(publication.identity)) {
    return fault(DecodeError::bad_identity, ErrorCode::malformed, "a participant is described by a class expression");
  }
  if (publication.port == 0 && !is_description) {
    return fault(DecodeError::bad_port, ErrorCode::malformed, "port 0: a service is reached at a port from 1 to 65535");
  }
  if (auto found = address_fault(publication.address)) return found;
  if (auto found = protocol_fault(publication.protocol)) return found;
  if (auto found = filter_fault("scope", publication.scope, max_scope_bytes)) return found;
  if (auto found = filter_fault("for", publication.for_whom, max_where_bytes)) return found;
  return attributes_fault(publication.attributes);
}

std::optional<Fault> find_fault(const Subscription& subscription) {
  if (auto found = chosen_fault(subscription.chosen)) return found;
  if (auto found = identity_fault(subscription.identity)) return found;
  if (auto found = address_fault(subscription.address)) return found;
  if (auto found = attributes_fault(subscription.attributes)) return found;
  if (auto found = protocols_fault(subscription.protocols)) return found;
  return filters_fault(subscription);
}

}  // namespace geminga::announcement
