// What a peer offers and asks for in its own words: names, before an ontology has turned them into IRIs.
#ifndef GEMINGA_NAMED_HPP
#define GEMINGA_NAMED_HPP

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geminga/identity.hpp"
#include "geminga/match.hpp"
#include "geminga/service.hpp"

namespace geminga {

/// A concept and a representation as a user writes them: `prefix:Name`, `<IRI>`, or a label where it is unambiguous.
struct ConceptNames {
  std::string concept_name;
  std::string representation_name;  ///< empty: unstated in a publication, any in a subscription
  friend bool operator==(const ConceptNames&, const ConceptNames&) = default;
};

/// The IDENTITY of GCNP: `id=N`, `text=NAME`, or `concept=C [representation=R]`.
using NamedIdentity = std::variant<NumericIdentity, TextIdentity, ConceptNames>;

/// A publication whose identity is stated by name. The fields mean what they mean in Publication.
struct NamedPublication {
  NamedIdentity identity;
  ChannelMode mode = ChannelMode::one_to_one;
  std::string address;
  std::uint16_t port = 0;  ///< 1 to 65535
  std::string protocol = "udp";
  std::int32_t priority = 0;
  Attributes attributes;
  friend bool operator==(const NamedPublication&, const NamedPublication&) = default;
};

/// A subscription whose identity is stated by name. The fields mean what they mean in Subscription.
struct NamedSubscription {
  NamedIdentity identity;
  ChannelMode mode = ChannelMode::one_to_one;
  Degree weakest = Degree::narrower;
  std::vector<ProviderFilter> providers;
  std::string where;
  std::optional<std::uint32_t> limit;  ///< nothing: 1 for one_to_one and all otherwise; 0: all
  std::int32_t priority = 0;
  std::uint16_t port = 0;
  std::string address;
  Attributes attributes;
  friend bool operator==(const NamedSubscription&, const NamedSubscription&) = default;
};

}  // namespace geminga

#endif
