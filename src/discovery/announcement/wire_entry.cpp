#include "discovery/announcement/wire_entry.hpp"

#include "base/address.hpp"
#include "discovery/announcement/wire_choice.hpp"

namespace geminga::announcement {
namespace {

wire::Mode to_wire(ChannelMode mode) {
  switch (mode) {
    case ChannelMode::one_to_one:
      return wire::MODE_ONE_TO_ONE;
    case ChannelMode::one_to_many_stream:
      return wire::MODE_ONE_TO_MANY_STREAM;
    case ChannelMode::one_to_many_pubsub:
      return wire::MODE_ONE_TO_MANY_PUBSUB;
    case ChannelMode::participant:
      break;  // in a field of its own, which says as much
  }
  return wire::MODE_UNSPECIFIED;
}

wire::Degree to_wire(Degree degree) {
  switch (degree) {
    case Degree::exact:
      return wire::DEGREE_EXACT;
    case Degree::equivalent:
      return wire::DEGREE_EQUIVALENT;
    case Degree::narrower:
      return wire::DEGREE_NARROWER;
    case Degree::broader:
    case Degree::overlapping:  // in a field of its own, which who knows no such degree skips
      return wire::DEGREE_BROADER;
    case Degree::converted:
      break;  // nobody asks for it by degree
  }
  return wire::DEGREE_NARROWER;
}

/// A representation beside an offered expression has a field of its own.
void write_representation(bool is_of_expression, std::uint32_t term, wire::Publication& message) {
  if (is_of_expression) {
    message.set_representation_of_expression(term);
  } else {
    message.set_representation_term(term);
  }
}
void write_representation(bool, std::uint32_t term, wire::Subscription& message) {
  message.set_representation_term(term);
}

/// The fields that publications and subscriptions share.
template <typename Message, typename Service>
void write_common(const Service& service, TermTable& terms, Message& message) {
  message.set_mode(to_wire(service.mode));
  if (const auto* numeric = std::get_if<NumericIdentity>(&service.identity)) {
    message.set_numeric(numeric->number);
  } else if (const auto* text = std::get_if<TextIdentity>(&service.identity)) {
    message.set_text(text->text);
  } else if (const auto* semantic = std::get_if<SemanticIdentity>(&service.identity)) {
    if (has_expression(*semantic)) {
      message.set_is_expression(true);
      message.set_text(semantic->concept_iri);
    } else {
      message.set_concept_term(terms.number(semantic->concept_iri));
    }
    write_representation(has_expression(*semantic), terms.number(semantic->representation_iri), message);
  }
  message.set_port(service.port);
  message.set_address(address_octets(service.address));
  message.set_priority(service.priority);
  for (const auto& [key, value] : service.attributes) {
    auto* attribute = message.add_attributes();
    attribute->set_key(key);
    attribute->set_value(value);
  }
}

void write(const ProviderFilter& filter, wire::ProviderFilter& message) {
  message.set_participant(filter.participant);
  message.set_peer(filter.peer);
}

}  // namespace

std::optional<std::string> address_of(const std::string& octets) {
  const base::Address address{{octets.begin(), octets.end()}, {}};
  if ((octets.size() != 4 && octets.size() != 16) || address.scope() == base::AddressScope::unspecified)
    return std::nullopt;
  return address.text();
}

std::string address_octets(const std::string& text) {
  const auto address = base::parse_address(text);
  return address ? std::string(address->octets.begin(), address->octets.end()) : std::string();
}

wire::Publication to_wire(const NumberedPublication& numbered, TermTable& terms) {
  wire::Publication message;
  message.set_number(numbered.number);
  write_common(numbered.publication, terms, message);
  if (numbered.publication.protocol != "udp") message.set_protocol(numbered.publication.protocol);
  message.set_scope(numbered.publication.scope);
  message.set_for_whom(numbered.publication.for_whom);
  return message;
}

wire::Subscription to_wire(const NumberedSubscription& numbered, TermTable& terms) {
  wire::Subscription message;
  message.set_number(numbered.number);
  write_common(numbered.subscription, terms, message);
  message.set_weakest(to_wire(numbered.subscription.weakest));
  message.set_overlapping(numbered.subscription.weakest == Degree::overlapping);
  for (const auto& filter : numbered.subscription.providers) write(filter, *message.add_providers());
  message.set_where(numbered.subscription.where);
  message.set_limit(numbered.subscription.limit);
  for (const auto& protocol : numbered.subscription.protocols) message.add_protocols(protocol);
  for (const auto& favoured : numbered.subscription.favoured) write(favoured, *message.add_favoured());
  message.set_prefer(numbered.subscription.prefer);
  message.set_rank(numbered.subscription.rank);
  message.set_scope(numbered.subscription.scope);
  write_choice(numbered.subscription.chosen, message);
  message.set_convert(numbered.subscription.convert);
  message.set_on(numbered.subscription.on);
  return message;
}

}  // namespace geminga::announcement
